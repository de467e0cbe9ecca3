#include "sim/study/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "cli/exit_codes.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/study/grid.hpp"

namespace gausssim {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// What a run of a method may take, from that of the one before it, which was looser: an estimate on the safe side.
class Forecast {
 public:
  double of(const Candidate& candidate) const {
    const auto found = last_.find(key(candidate));
    return found == last_.end() ? 0 : 4 * found->second;
  }
  void note(const Point& point) { last_[key(point.candidate)] = point.time; }

 private:
  static std::string key(const Candidate& candidate) {
    return fmt::format("{} {} {}", candidate.formulation, candidate.setting.method, candidate.setting.number);
  }

  std::map<std::string, double> last_;
};

class Solver {
 public:
  Solver(Problem& problem, const StudyOptions& options) : problem_(problem), options_(options) {}

  void run() {
    const Formulation& first = problem_.formulations.front();
    auto reference = find_reference(first.model, *first.engine, problem_.why);
    if (!reference) return;
    problem_.reference = std::move(*reference);
    problem_.ranges = ranges_of(problem_.reference.rows);
    measure_all();
    mark_front(problem_.points);
    trace_front();
  }

 private:
  std::vector<Candidate> candidates() const {
    std::vector<Candidate> all;
    GridOptions grid;
    grid.loosest = options_.loosest;
    grid.tightest = options_.tightest;
    for (std::size_t i = 0; i < problem_.formulations.size(); ++i) {
      for (const Candidate& one : grid_of(problem_.formulations[i].model, i, grid)) all.push_back(one);
    }
    return all;
  }

  void measure_all() {
    ProgressBar bar(!options_.quiet);
    Forecast forecast;
    const std::vector<Candidate> all = candidates();
    for (const Candidate& candidate : all) {
      if (Interruption::is_asked_for()) return;
      bar.show(static_cast<double>(problem_.points.size()) / static_cast<double>(all.size()), problem_.name);
      const double left = options_.budget - since(begin_);
      Point point;
      if (left <= 0 || forecast.of(candidate) > std::min(left, options_.budget / 5)) {
        point.candidate = candidate;
        point.status = PointStatus::refused;
        point.why = "beyond the time that the study was given";
      } else {
        const Formulation& formulation = problem_.formulations[candidate.formulation];
        point = measure(formulation.model, *formulation.engine, candidate, problem_.reference, {});
        if (point.status == PointStatus::ok) forecast.note(point);
      }
      point.id = static_cast<int>(problem_.points.size()) + 1;
      problem_.points.push_back(std::move(point));
    }
  }

  static std::vector<double> ranges_of(const Rows& rows) {
    std::vector<double> ranges;
    for (std::size_t i = 0; i < rows.columns(); ++i) {
      long double least = rows.at(0, i), most = least;
      for (long k = 1; k < rows.samples(); ++k) {
        least = std::min(least, rows.at(k, i));
        most = std::max(most, rows.at(k, i));
      }
      ranges.push_back(static_cast<double>(most - least));
    }
    return ranges;
  }

  /// Drift over time of the best ones, which people may take.
  void trace_front() {
    for (const Point& point : problem_.points) {
      if (!point.is_on_front) continue;
      const Formulation& formulation = problem_.formulations[point.candidate.formulation];
      DriftTrace trace;
      trace.point = point.id;
      Listeners listeners;
      listeners.on_drift = [&](double t, double energy, double constraints) {
        trace.t.push_back(t);
        trace.energy.push_back(energy);
        trace.constraints.push_back(constraints);
      };
      simulate(formulation.model, *formulation.engine, point.candidate.setting, listeners);
      problem_.drifts.push_back(std::move(trace));
    }
  }

  Problem& problem_;
  const StudyOptions& options_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::optional<Problem> solve_problem(const std::string& file, const StudyOptions& options, int& code) {
  Problem problem;
  problem.file = std::filesystem::path(file).filename().string();
  Request request{file, {}, {}, options.messages};
  auto prepared = prepare(
      request, [](Scene&) {}, code);
  if (!prepared) return std::nullopt;
  problem.name = prepared->scene.name.empty() ? prepared->model.unit.model_name : prepared->scene.name;
  Formulation formulation{"as given", std::move(*prepared), nullptr, {}, 0};
  formulation.engine = build_engine(formulation.model, EngineChoice::compiled, {"double", "long double", "__float128"},
                                    formulation.times, problem.why);
  if (!formulation.engine) {
    code = gaussgen::cli::fail(problem.why, gaussgen::cli::k_file_error, options.messages);
    return std::nullopt;
  }
  problem.formulations.push_back(std::move(formulation));
  Solver(problem, options).run();
  return problem;
}

}  // namespace gausssim
