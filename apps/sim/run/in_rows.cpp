#include "sim/run/in_rows.hpp"

#include <algorithm>
#include <cmath>

#include "sim/run/interruption.hpp"

namespace gausssim {

RunInRows in_rows(const PreparedModel& prepared, const Engine& engine, const Setting& setting, Meter meter) {
  RunInRows result{{}, Rows(prepared.columns.columns.size(), prepared.span.samples)};
  Listeners listeners;
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) { result.rows.set(k, row); };
  listeners.measures_drift = meter == Meter::drift;
  result.run = simulate(prepared, engine, setting, listeners);
  return result;
}

std::future<RunInRows> begin_in_rows(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                                     double seconds) {
  constexpr std::size_t k_many = 10'000'000;  ///< numbers of a table
  const bool is_large = static_cast<std::size_t>(prepared.span.samples) * prepared.columns.columns.size() > k_many;
  return std::async(is_large ? std::launch::deferred : std::launch::async, [&prepared, &engine, setting, seconds] {
    const TimeLimit limit(seconds);
    return in_rows(prepared, *engine.another(), setting, Meter::none);
  });
}

namespace {

/// A part of the duration: as near as events are known.
constexpr double k_at_event = 1e-9;

void agree_at(double t, const Span& span, const Rows& rows, Rows& other) {
  const double dt = span.every > 0 ? span.every : span.duration / static_cast<double>(std::max(span.samples - 1, 1L));
  const double place = (t - span.start) / dt, nearest = std::round(place);
  const bool is_near = std::fabs(place - nearest) * dt <= k_at_event * span.duration;
  const auto k = static_cast<long>(nearest);
  if (is_near && k >= 0 && k < std::min(rows.samples(), other.samples())) other.take(k, rows);
}

}  // namespace

void agree_at_events(RunInRows& other, const std::vector<Event>& events, const Rows& rows, const Span& span) {
  for (const auto& all : {events, other.run.events})
    for (const Event& event : all) agree_at(event.t, span, rows, other.rows);
}

bool gets_as_far(const Simulated& other, const Simulated& run) {
  return !Interruption::is_asked_for() &&
         (other.outcome == gauss::simulate::Outcome::running || other.samples >= run.samples);
}

Simulated unheard(const PreparedModel& prepared, const Engine& engine, const Setting& setting) {
  Listeners none;
  none.measures_drift = false;
  return simulate(prepared, engine, setting, none);
}

}  // namespace gausssim
