#include "sim/study/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>

#include "cli/exit_codes.hpp"
#include "sim/effects/ladder_json.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/run/setting.hpp"
#include "sim/study/grid.hpp"

namespace gausssim {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// All that differs in tolerances or steps alone.
std::string row_of(const Candidate& candidate) {
  return fmt::format("{} {} {} {}", candidate.form, candidate.setting.method, candidate.setting.number,
                     static_cast<int>(candidate.setting.projection));
}

/// What a run of a method may take, from that of the one before it, which was looser: an estimate on the safe side.
class Forecast {
 public:
  double of(const Candidate& candidate) const {
    const auto found = last_.find(row_of(candidate));
    return found == last_.end() ? 0 : 4 * found->second;
  }
  void note(const Candidate& candidate, double seconds) { last_[row_of(candidate)] = seconds; }

 private:
  std::map<std::string, double> last_;
};

/// As a table has them: row by row, each from loose to tight.
void number_in_rows(std::vector<Point>& points) {
  std::map<std::string, std::size_t> rows;
  for (const Point& point : points) rows.emplace(row_of(point.candidate), rows.size());
  std::stable_sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return rows.at(row_of(a.candidate)) < rows.at(row_of(b.candidate));
  });
  int id = 0;
  for (Point& point : points) point.id = ++id;
}

/// No run takes more of the time than this part, and none is made again once its repeats have.
constexpr double k_least_runs = 40;
constexpr double k_least_first_runs = 10;  ///< of which nothing is known before

class Solver {
 public:
  Solver(const std::string& file, StudyProblem& problem, const StudyOptions& options)
      : file_(file), problem_(problem), options_(options) {}

  void run() {
    auto reference = reference_in_time();
    throw_if_ended();
    if (reference) {
      problem_.reference = std::move(*reference);
      compare_with_reference();
    }
    try {
      if (problem_.why.empty()) show_beside();
      show_motion();
      show_effects();
    } catch (const Interrupted&) {
      // The points are there.
    }
    problem_.was_interrupted = Interruption::is_asked_for();
  }

 private:
  /// Motions that stick where a force jumps would take for ever.
  std::optional<StudyReference> reference_in_time() {
    const Form& first = problem_.forms.front();
    constexpr double k_least = 30, k_share = 5;
    const double seconds = k_least + k_share * options_.budget;
    const TimeLimit limit(seconds);
    auto reference = find_reference(first.model, *first.engine, problem_.why);
    if (!reference && limit.is_over()) problem_.why = fmt::format("two tight runs take more than {:.3g} s", seconds);
    return reference;
  }

  void compare_with_reference() {
    problem_.ranges = ranges_of(problem_.reference.yardstick.rows());
    compare_forms();
    begin_ = Clock::now();
    measure_all();
    number_in_rows(problem_.points);
    mark_front(problem_.points);
    if (problem_.points.empty()) throw_if_ended();
  }

  /// What a page has beside points; each whole, or not at all.
  void show_beside() {
    trace_drifts();
    LanesEffort effort;
    effort.seconds = 0.3;
    std::string why_no_lanes;
    if (!options_.methods.empty()) return;
    auto lanes = measure_lanes(problem_.forms.front().model, effort, why_no_lanes);
    throw_if_ended();
    problem_.lanes = std::move(lanes);
  }

  /// None where it does not come to its end.
  void show_motion() {
    const Form& first = problem_.forms.front();
    const TimeLimit limit(options_.budget, TimeLimit::Of::all);
    auto motion = motion_of(first.model, *first.engine, default_setting(first.model, *first.engine));
    if (Interruption::is_asked_for()) throw Interrupted{};
    if (!limit.is_over()) problem_.motion = std::move(motion);
  }

  /// Each of the sets is derived and compiled, which takes its time, too.
  void show_effects() {
    const PreparedModel& model = problem_.forms.front().model;
    const bool are_left_out = !model.scene.effects.empty() && model.effects.empty();
    if (!options_.methods.empty() || !model.has_effects() || are_left_out) return;
    constexpr double k_least = 60;
    problem_.effects = json_of_effects(file_, k_least + options_.budget);
  }

  /// Another description has to tell the same motion, as far as tight runs tell it at all.
  void compare_forms() {
    double own = 0;
    for (Form& form : problem_.forms) {
      if (!form.engine) continue;
      constexpr double k_alike = 1e-3, k_far = 100;
      const DeliveredError error = tight_error_of(form);
      throw_if_ended();
      if (&form == &problem_.forms.front()) {
        own = error.value;
        form.why.clear();
      } else if (form.why.empty() && !(error.value <= std::max(k_alike, k_far * own))) {
        form.why =
            fmt::format("it tells another motion: '{}' is off by {:.2g} of its range", error.output, error.value);
      }
    }
  }

  DeliveredError tight_error_of(Form& form) const {
    constexpr double k_tight = 1e-11;
    const TimeLimit limit(options_.budget, TimeLimit::Of::all);
    Setting setting = default_setting(form.model, *form.engine);
    setting.tolerance = k_tight;
    const DeliveredError error = error_of(form.model, *form.engine, setting, problem_.reference, form.why);
    if (limit.is_over()) form.why = fmt::format("a tight run takes more than {:.3g} s", options_.budget);
    return error;
  }

  void measure_all() {
    ProgressBar bar(!options_.quiet);
    Forecast forecast;
    GridOptions grid;
    grid.loosest = options_.loosest;
    grid.tightest = options_.tightest;
    grid.only = options_.methods;
    const std::vector<Candidate> all = grid_of(problem_.forms, grid);
    for (const Candidate& candidate : all) {
      if (Interruption::is_asked_for()) return;
      bar.show(static_cast<double>(problem_.points.size()) / static_cast<double>(all.size()), problem_.name);
      Point point = measured(candidate, forecast);
      if (Interruption::is_asked_for()) return;
      problem_.points.push_back(std::move(point));
    }
    measure_in_time_left(forecast);
  }

  /// Those whose share was over, in what others have left of theirs.
  void measure_in_time_left(Forecast& forecast) {
    for (Point& point : problem_.points) {
      if (point.why != k_beyond_time || point.candidate.share_of_time >= 1) continue;
      Candidate candidate = point.candidate;
      candidate.share_of_time = 1;
      Point again = measured(candidate, forecast);
      if (Interruption::is_asked_for()) return;
      point = std::move(again);
    }
  }

  Point measured(const Candidate& candidate, Forecast& forecast) const {
    const Form& form = problem_.forms[candidate.form];
    const double left = options_.budget * candidate.share_of_time - since(begin_);
    Point point;
    point.candidate = candidate;
    point.status = PointStatus::refused;
    point.why = form.why;
    if (point.why.empty() && (left <= 0 || forecast.of(candidate) > std::min(left, options_.budget / k_least_runs)))
      point.why = k_beyond_time;
    if (!point.why.empty()) return point;
    Effort effort;
    effort.limit = std::min(left, options_.budget / k_least_first_runs);
    effort.longest = options_.budget / k_least_runs;
    point = measure(form.model, *form.engine, candidate, problem_.reference, effort);
    if (point.status == PointStatus::ok) forecast.note(candidate, point.time);
    if (point.why == k_beyond_time) forecast.note(candidate, effort.limit);
    return point;
  }

  static std::vector<double> ranges_of(const Rows& rows) {
    std::vector<double> ranges;
    for (std::size_t i = 0; i < rows.columns(); ++i) ranges.push_back(static_cast<double>(extent_of(rows, i).range));
    return ranges;
  }

  /// The default, and what differs from it in one thing that drift may depend on.
  std::vector<int> worth_tracing() const {
    const auto usual = std::find_if(problem_.points.begin(), problem_.points.end(),
                                    [](const Point& point) { return point.candidate.is_default; });
    std::set<int> ids;
    for (const Point& point : problem_.points) {
      if (usual == problem_.points.end() || point.status != PointStatus::ok) continue;
      const Setting &one = point.candidate.setting, &other = usual->candidate.setting;
      const bool is_alike = one.tolerance == other.tolerance && one.number == other.number;
      const bool is_usual_form = point.candidate.form == 0;
      const bool is_unusual_description =
          problem_.forms[point.candidate.form].formulation != problem_.forms.front().formulation;
      if (is_alike && (is_usual_form ? one.method == other.method || one.method == k_method_of_any_model
                                     : one.method == other.method && is_unusual_description))
        ids.insert(point.id);
    }
    for (const double error : {1e-3, 1e-6, 1e-12}) {
      if (const Point* const best = cheapest(problem_.points, error)) ids.insert(best->id);
    }
    return {ids.begin(), ids.end()};
  }

  void trace_drifts() {
    for (const int id : worth_tracing()) {
      const Point& point = problem_.points[static_cast<std::size_t>(id - 1)];
      const Form& form = problem_.forms[point.candidate.form];
      DriftTrace trace;
      trace.point = point.id;
      Listeners listeners;
      listeners.on_drift = [&](double t, double energy, double constraints) {
        trace.t.push_back(t);
        trace.energy.push_back(energy);
        trace.constraints.push_back(constraints);
      };
      const Drift drift = simulate(form.model, *form.engine, point.candidate.setting, listeners).drift;
      throw_if_ended();
      // Nothing was looked at then.
      if (!drift.has_energy) trace.energy.clear();
      if (!drift.has_constraints) trace.constraints.clear();
      problem_.drifts.push_back(std::move(trace));
    }
  }

  const std::string& file_;
  StudyProblem& problem_;
  const StudyOptions& options_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::optional<StudyProblem> solve_problem(const std::string& file, const StudyOptions& options, int& code) {
  StudyProblem problem;
  problem.forms = forms_of(file, options.instance, !options.methods.empty(), options.messages, code);
  if (problem.forms.empty()) return std::nullopt;
  const PreparedModel& model = problem.forms.front().model;
  problem.name = model.name();
  problem.file = std::filesystem::path(model.model_file).filename().string();
  if (!model.scene.model.text.empty()) problem.scene = std::filesystem::path(file).filename().string();
  Solver(file, problem, options).run();
  return problem;
}

}  // namespace gausssim
