#include "sim/study/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "sim/run/build_engine.hpp"
#include "sim/run/closed_form.hpp"
#include "sim/run/in_rows.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/setting.hpp"

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
  const bool is_refused = run.outcome == Outcome::bad_settings || run.outcome == Outcome::interrupted;
  point.status = is_refused ? PointStatus::refused : PointStatus::failed;
  point.why = run.outcome == Outcome::interrupted ? k_beyond_time : reason(run);
}

RunInRows first_run(const PreparedModel& model, const Engine& engine, const Setting& setting, const Effort& effort) {
  const TimeLimit limit(effort.limit);
  return in_rows(model, engine, setting, Meter::drift);
}

void time_it(const PreparedModel& model, const Engine& engine, const Effort& effort, double first, Point& point) {
  std::vector<double> times{first};
  if (first < effort.longest) {
    times.clear();
    double sum = 0;
    constexpr double k_short = 0.05;
    const int least = first < k_short ? 3 : 1;
    constexpr int k_most = 1000;
    const auto goes_on = [&] {
      const int count = static_cast<int>(times.size());
      return count < least ||
             (count < k_most && (count < effort.repeats || sum < effort.seconds) && sum < effort.longest);
    };
    while (goes_on()) {
      times.push_back(unheard(model, engine, point.candidate.setting).cpu_seconds);
      sum += times.back();
    }
  }
  std::sort(times.begin(), times.end());
  point.repeats = static_cast<int>(times.size());
  point.time = times[times.size() / 2];
  point.least_time = times.front();
  point.most_time = times.back();
}

/// The two runs of a reference, with longest steps that have nothing in common, so that they see what acts for a short time: series of two orders; extrapolation, twice; or where forces jump, which extrapolation may not see, two pairs.
std::array<Setting, 2> tight_settings(const PreparedModel& model, const Engine& engine, double lengthened) {
  Setting fine, other;
  fine.number = other.number = "float128";
  fine.method = other.method = default_method(model, engine, fine.number);
  const LongestSteps longest = longest_steps(model, lengthened);
  fine.longest_step = longest.fine, other.longest_step = longest.other;
  if (fine.method == "taylor") {
    fine.tolerance = 1e-29, other.tolerance = 1e-27;
    fine.order = 36, other.order = 30;
  } else if (fine.method == k_method_of_edges) {
    fine.tolerance = 1e-19, other.tolerance = 1e-17;
    other.method = k_method_of_any_model, other.number = "long-double";
  } else {
    fine.tolerance = 1e-26, other.tolerance = 1e-23;
  }
  return {fine, other};
}

/// Where outputs are known as functions of time, both have to say the same.
void take_closed_forms(const PreparedModel& model, StudyReference& reference, std::string& why) {
  const ClosedForms forms(model);
  if (!forms.are_there()) return;
  constexpr double k_alike = 1e-12;
  const auto& columns = model.columns.columns;
  const bool are_all =
      std::all_of(columns.begin(), columns.end(), [&](const Column& column) { return forms.has(column.name); });
  Rows rows = forms.instead_of(reference.yardstick.rows(), model);
  const DeliveredError apart = reference.yardstick.error_of(rows);
  if (!(apart.value <= k_alike))
    why = fmt::format("the closed form of '{}' differs from the motion by {:.2g} of its range", apart.output,
                      apart.value);
  reference.agreement = std::max(reference.agreement, apart.value);
  reference.methods.emplace_back(are_all ? "closed forms of all outputs" : "closed forms of some outputs");
  if (are_all) reference.kind = "closed form", reference.yardstick.take(std::move(rows));
}

std::string in_words(const Setting& setting) {
  const std::string tolerance = fmt::format("tolerance {:.0e}", setting.tolerance);
  if (setting.order > 0) return fmt::format("power series of order {}, {}", setting.order, tolerance);
  if (setting.method == "bulirsch_stoer") return "extrapolation (Bulirsch and Stoer), " + tolerance;
  return fmt::format("{} in {}, {}", setting.method, setting.number, tolerance);
}

}  // namespace

Point measure(const PreparedModel& model, const Engine& engine, const Candidate& candidate,
              const StudyReference& reference, const Effort& effort) {
  Point point;
  point.candidate = candidate;
  const RunInRows found = first_run(model, engine, candidate.setting, effort);
  note(found.run, point);
  if (point.status != PointStatus::ok) return point;
  point.error = reference.yardstick.error_of(found.rows);
  // So far the reference may be off itself.
  point.error->value += reference.agreement;
  time_it(model, engine, effort, found.run.cpu_seconds, point);
  return point;
}

DeliveredError error_of(const PreparedModel& model, const Engine& engine, const Setting& setting,
                        const StudyReference& reference, std::string& why) {
  const RunInRows found = in_rows(model, engine, setting, Meter::none);
  if (found.run.outcome != Outcome::running) why = reason(found.run);
  if (model.columns.columns.size() != reference.yardstick.rows().columns()) why = "it has other outputs";
  return why.empty() ? reference.yardstick.error_of(found.rows) : DeliveredError{};
}

namespace {

/// Both arrive.
struct TwoRuns {
  Setting fine, other;
  RunInRows one, two;
};

/// Over a place where constraints lose their rank, steps have to be as long as the digits that are lost there ask for: then longer ones are allowed.
std::optional<TwoRuns> tight_runs(const PreparedModel& model, const Engine& engine, std::string& why) {
  for (const double lengthened : {1.0, 10.0, 100.0, 1000.0}) {
    const auto [fine, other] = tight_settings(model, engine, lengthened);
    TwoRuns both{fine, other, in_rows(model, engine, fine, Meter::none), in_rows(model, engine, other, Meter::none)};
    why.clear();
    for (const RunInRows* const run : {&both.one, &both.two})
      if (run->run.outcome != Outcome::running) why = reason(run->run);
    if (why.empty()) return both;
    if (ends_now() || both.one.run.status != gauss::Status::dependent_constraints) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<StudyReference> find_reference(const PreparedModel& model, const Engine& engine, std::string& why) {
  const auto runs = tight_runs(model, engine, why);
  if (!runs) return std::nullopt;
  const auto& [fine, other, one, two] = *runs;
  constexpr double k_least_range = 1e-15;
  StudyReference reference{
      Yardstick(one.rows, two.rows, model.columns.columns, k_least_range, least_tolerance(fine.number)),
      "float128",
      {in_words(fine), in_words(other)},
      0};
  // They are compared with the digits of long double.
  reference.agreement = std::max(reference.yardstick.error_of(two.rows).value,
                                 static_cast<double>(std::numeric_limits<long double>::epsilon()));
  constexpr double k_useless = 1e-4;  ///< nothing that a study shows would be known
  if (!(reference.agreement <= k_useless)) {
    const DeliveredError apart = reference.yardstick.error_of(two.rows);
    why = fmt::format("two tight runs ({} and {}) differ by {:.1e}, in {}", in_words(fine), in_words(other),
                      apart.value, apart.output);
    return std::nullopt;
  }
  take_closed_forms(model, reference, why);
  if (!why.empty()) return std::nullopt;
  return reference;
}

}  // namespace gausssim
