#include "sim/run/in_rows.hpp"

namespace gausssim {

RunInRows in_rows(const PreparedModel& prepared, const Engine& engine, const Setting& setting, Meter meter) {
  RunInRows result{{}, Rows(prepared.columns.columns.size(), prepared.span.samples)};
  Listeners listeners;
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) { result.rows.set(k, row); };
  listeners.measures_drift = meter == Meter::drift;
  result.run = simulate(prepared, engine, setting, listeners);
  return result;
}

Simulated unheard(const PreparedModel& prepared, const Engine& engine, const Setting& setting) {
  Listeners none;
  none.measures_drift = false;
  return simulate(prepared, engine, setting, none);
}

}  // namespace gausssim
