#include "sim/run/tighter_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/run/interruption.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

using gauss::simulate::Outcome;

constexpr double k_tighter = 1e-2;           ///< tolerances, from one run to the next
constexpr double k_tighter_at_edges = 1e-3;  ///< where a force jumps, errors fall with tolerances by chance
constexpr double k_shorter = 0.5;            ///< steps
constexpr double k_shortest = 0.1;           ///< of the step of the first of them
constexpr double k_other =
    0.9;  ///< likewise, of runs whose tolerances differ: no step of one ends where steps of the other do
constexpr double k_of_steps = 1e-9;  ///< nobody knows the tolerance of these
constexpr int k_longer = 20;         ///< times what the run took; then tighter ones are given up
constexpr double k_least_limit = 2;  ///< s

class Tightening {
 public:
  Tightening(const PreparedModel& prepared, const Engine& engine, Engines& engines, const Setting& setting,
             const Simulated& run, const Rows& rows)
      : prepared_(prepared), engine_(&engine), setting_(setting), run_(run), rows_(rows) {
    // Runs in float do not see what they share: the rounding of values and times.
    const Engine* const wide = setting.number == "float" ? engines.of("double") : nullptr;
    if (wide != nullptr) setting_.number = "double", engine_ = wide;
    rounding_ = rounding_unit(setting_.number);
    begin();
  }

  std::optional<TighterRuns> look(WhyNone& why) {
    const TimeLimit limit(most_seconds());
    const Setting first = setting_;
    (void)tighten();  // beside the first, another one in any case
    std::future<RunInRows> next = begun();
    RunInRows tight = as_far(in_rows(prepared_, *engine_, first, Meter::none));
    why = why_no_yardstick(tight.run);
    if (!why.text.empty()) return std::nullopt;
    TighterRuns result{yardstick_of(std::move(tight.rows), rows_), {}, std::nullopt};
    result.error = result.yardstick.error_of(rows_);
    for (;;) {
      RunInRows tighter = as_far(next.get());
      if (!gets_as_far(tighter.run, run_)) break;
      Yardstick yardstick = yardstick_of(std::move(tighter.rows), result.yardstick.rows());
      result.agreement = yardstick.error_of(result.yardstick.rows());
      result.yardstick = std::move(yardstick);
      result.error = result.yardstick.error_of(rows_);
      if (result.agreement->value <= k_agree * result.error.value || !tighten()) break;
      next = begun();
    }
    return result;
  }

 private:
  double most_seconds() const { return most_seconds_beside(run_); }

  /// It takes no longer than all may.
  std::future<RunInRows> begun() const { return begin_in_rows(prepared_, *engine_, setting_, most_seconds()); }

  /// As the run goes.
  RunInRows as_far(RunInRows other) const {
    other.rows.keep(rows_.samples());
    agree_at_events(other, run_.events, rows_, prepared_.span);
    return other;
  }

  /// Closer to the motion, by other terms. Where samples are closer than steps would be, a tolerance alone changes nothing, nor does a step.
  void begin() {
    const double taken = prepared_.span.duration / static_cast<double>(std::max(run_.steps, 1L));
    const double of_others = longest_steps(prepared_).fine;
    setting_.most_steps = 0;
    if (setting_.tolerance > 0) {
      setting_.tolerance *= tighter();
      // What acts for a short time may lie within a step of both.
      const double longest = std::min(k_shorter * taken, of_others);
      double& given = setting_.longest_step;
      given = given > 0 ? std::min(k_shorter * given, longest) : longest;
    }
    if (setting_.step > 0) setting_.step = k_shorter * std::min(setting_.step, taken);
    shortest_ = k_shortest * setting_.step;
    if (!is_its_own_measure()) setting_ = by_other_terms(setting_, prepared_);
    // In place of steps of one length, too.
    if (setting_.tolerance > 0 && setting_.longest_step == 0) setting_.longest_step = of_others;
    if (setting_.tolerance > 0) setting_.tolerance = std::max(setting_.tolerance, least_tolerance(setting_.number));
    least_range_ = least_range(setting_.tolerance > 0 ? setting_.tolerance : k_of_steps);
  }

  /// Short steps of the method of any model see all that extrapolation does of smooth forces, at half the calls and with less rounding.
  bool is_its_own_measure() const { return setting_.method == k_method_of_any_model && prepared_.edge.empty(); }

  /// False: for the last time, since no tolerance is below rounding, and steps that are so much shorter should have agreed.
  bool tighten() {
    if (setting_.step > 0) return setting_.step *= k_shorter, setting_.step > shortest_;
    const double least = least_tolerance(setting_.number);
    const bool is_tighter = setting_.tolerance > least;
    setting_.tolerance = std::max(tighter() * setting_.tolerance, least);
    setting_.longest_step *= k_other;
    return is_tighter;
  }

  double tighter() const { return prepared_.edge.empty() ? k_tighter : k_tighter_at_edges; }

  /// Empty: it says something of errors.
  WhyNone why_no_yardstick(const Simulated& tight) const {
    if (Interruption::is_asked_for()) return {"interrupted while a tighter run was made"};
    if (tight.steps == run_.steps && tight.calls == run_.calls) return {"a tighter run takes the same steps"};
    if (gets_as_far(tight, run_)) return {};
    if (tight.outcome == Outcome::step_too_small && are_times_coarse(setting_.number, tight.reached, prepared_.span))
      return {fmt::format("times near {:.3g} s are too far apart for the steps of a tighter run", tight.reached)};
    if (tight.outcome == Outcome::interrupted)
      return {fmt::format("a tighter run takes {} times as long and more", k_longer)};
    return {fmt::format("a tighter run stops at t = {:.6g}: {}", tight.reached, gauss::simulate::name(tight.outcome)),
            true};
  }

  Yardstick yardstick_of(Rows rows, const Rows& other) const {
    return Yardstick(std::move(rows), other, prepared_.columns.columns, least_range_, rounding_);
  }

  const PreparedModel& prepared_;
  const Engine* engine_;
  Setting setting_;
  const Simulated& run_;
  const Rows& rows_;
  double rounding_ = 0;  ///< of the rows
  double shortest_ = 0;  ///< step
  double least_range_ =
      0;  ///< as the first of them has it: what rounding makes of a constant is not less for tighter ones
};

}  // namespace

double most_seconds_beside(const Simulated& run) { return k_least_limit + k_longer * run.wall_seconds; }

std::optional<TighterRuns> tighter_runs(const PreparedModel& prepared, const Engine& engine, Engines& engines,
                                        const Setting& setting, const Simulated& run, const Rows& rows, WhyNone& why) {
  return Tightening(prepared, engine, engines, setting, run, rows).look(why);
}

}  // namespace gausssim
