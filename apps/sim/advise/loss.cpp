#include "sim/advise/loss.hpp"

#include "sim/run/interruption.hpp"
#include "sim/run/lost_digits.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

Loss::Loss(const PreparedModel& prepared, Engines& engines, double error) {
  const std::string& asked = number_name(prepared.scene);
  const Engine* const engine = asked == "double" || asked == "float" ? engines.of("double") : nullptr;
  if (engine == nullptr) return;
  constexpr double k_seconds = 1;
  const TimeLimit limit(k_seconds);
  Setting setting = default_setting(prepared, *engine);
  setting.tolerance = error;
  PassedStates states(prepared.span.samples);
  Rows rows(prepared.columns.columns.size(), prepared.span.samples);
  Listeners listeners;
  listeners.measures_drift = false;
  listeners.on_state = [&](long k, long double t, const std::vector<long double>& state) { states.note(k, t, state); };
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) { rows.set(k, row); };
  const Simulated run = simulate(prepared, *engine, setting, listeners);
  if (run.samples <= 1) return;
  const Yardstick own = of_themselves(rows, prepared, setting);
  const LostDigits digits(prepared, *engine, setting, states, own);
  in_double_ = digits.in("double").value;
  in_long_double_ = digits.in("long-double").value;
}

bool Loss::is_above(double part, const std::string& number) const {
  return (number == "double" ? in_double_ : number == "long-double" ? in_long_double_ : 0) > part;
}

}  // namespace gausssim
