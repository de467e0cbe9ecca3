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
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) { result.rows.set(k, row); };
  result.run = simulate(model, engine, setting, listeners);
  return result;
}

/// Tolerances and orders of the two runs of a reference: another number of terms in other steps.
constexpr double k_finer = 1e-29, k_coarser = 1e-27;
constexpr int k_order = 36, k_other_order = 30;

Setting by_series(double tolerance, int order) {
  Setting setting;
  setting.method = "taylor";
  setting.number = "float128";
  setting.tolerance = tolerance;
  setting.order = order;
  return setting;
}

std::string in_words(const Setting& setting) {
  return fmt::format("power series of order {}, tolerance {:.0e}", setting.order, setting.tolerance);
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
  const Setting fine = by_series(k_finer, k_order), other = by_series(k_coarser, k_other_order);
  const Traced one = traced(model, engine, fine), two = traced(model, engine, other);
  for (const Traced* const run : {&one, &two}) {
    if (run->run.outcome == Outcome::running) continue;
    why = reason(run->run);
    return std::nullopt;
  }
  Reference reference{one.rows, "float128", {in_words(fine), in_words(other)}, 0};
  reference.agreement = delivered_error(two.rows, one.rows, model.columns.columns).value;
  return reference;
}

}  // namespace gausssim
