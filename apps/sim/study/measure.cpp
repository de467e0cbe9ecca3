#include "sim/study/measure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gausssim {

namespace {

using gauss::simulate::Outcome;

std::string reason(const Simulated& run) {
  std::string text = run.why.empty() ? gauss::simulate::name(run.outcome) : run.why;
  if (run.outcome != Outcome::bad_settings) text += fmt::format(" at t = {:.6g}", run.reached);
  if (run.status != gauss::Status::ok) text += std::string(" (") + gauss::name(run.status) + ")";
  return text;
}

void note(const Simulated& run, Point& point) {
  point.calls = run.calls;
  point.steps = run.steps;
  point.rejected = run.rejected;
  point.drift = run.drift;
  if (run.outcome == Outcome::running) return;
  point.status = run.outcome == Outcome::bad_settings ? PointStatus::refused : PointStatus::failed;
  point.why = reason(run);
}

void time_it(const PreparedModel& model, const Engine& engine, const Effort& effort, double first, Point& point) {
  std::vector<double> times{first};
  if (first < effort.longest) {
    times.clear();
    double sum = 0;
    constexpr int k_least = 3, k_most = 1000;
    const auto goes_on = [&] {
      const int count = static_cast<int>(times.size());
      return count < k_least ||
             (count < k_most && (count < effort.repeats || sum < effort.seconds) && sum < effort.longest);
    };
    while (goes_on()) {
      Listeners none;
      none.measures_drift = false;
      times.push_back(simulate(model, engine, point.candidate.setting, none).cpu_seconds);
      sum += times.back();
    }
  }
  std::sort(times.begin(), times.end());
  point.repeats = static_cast<int>(times.size());
  point.time = times[times.size() / 2];
  point.least_time = times.front();
  point.most_time = times.back();
}

struct Traced {
  Simulated run;
  Rows rows;
};

Traced traced(const PreparedModel& model, const Engine& engine, const Setting& setting) {
  Traced result{{}, Rows(model.columns.columns.size(), model.span.samples)};
  Listeners listeners;
  listeners.on_numbers = [&](long k, const std::vector<double>& row) { result.rows.set(k, row); };
  result.run = simulate(model, engine, setting, listeners);
  return result;
}

Setting in_long_double(const char* method, double tolerance) {
  Setting setting;
  setting.method = method;
  setting.number = "long-double";
  setting.tolerance = tolerance;
  return setting;
}

}  // namespace

Point measure(const PreparedModel& model, const Engine& engine, const Candidate& candidate, const Reference& reference,
              const Effort& effort) {
  Point point;
  point.candidate = candidate;
  const Traced traced_run = traced(model, engine, candidate.setting);
  note(traced_run.run, point);
  if (point.status != PointStatus::ok) return point;
  point.error = delivered_error(traced_run.rows, reference.rows, model.columns.columns);
  time_it(model, engine, effort, traced_run.run.cpu_seconds, point);
  return point;
}

std::optional<Reference> find_reference(const PreparedModel& model, const Engine& engine, std::string& why) {
  constexpr double k_tolerance = 1e-17, k_other = 3e-17;
  const Traced one = traced(model, engine, in_long_double("fehlberg78", k_tolerance));
  const Traced two = traced(model, engine, in_long_double("prince87", k_other));
  for (const Traced* const run : {&one, &two}) {
    if (run->run.outcome == Outcome::running) continue;
    why = reason(run->run);
    return std::nullopt;
  }
  Reference reference{one.rows, "long double", {}, 0};
  reference.methods = {fmt::format("fehlberg78, tolerance {}", k_tolerance),
                       fmt::format("prince87, tolerance {}", k_other)};
  reference.agreement = delivered_error(two.rows, one.rows, model.columns.columns).value;
  return reference;
}

}  // namespace gausssim
