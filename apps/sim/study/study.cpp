#include "sim/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <list>
#include <optional>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "sim/output/files.hpp"
#include "sim/page/page.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/setting.hpp"
#include "sim/study/measure.hpp"
#include "sim/study/study_json.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

std::string in_words(const Point& point, const StudyProblem& problem) {
  const Setting& setting = point.candidate.setting;
  const Form& form = problem.forms[point.candidate.form];
  std::string text = setting.step > 0 ? fmt::format("{}, step {:.3g} s", setting.method, setting.step)
                                      : fmt::format("{}, tolerance {:.0e}", setting.method, setting.tolerance);
  if (setting.number != "double") text += ", " + setting.number;
  if (setting.projection != default_projection(setting.method)) text += ", projection " + name_of(setting.projection);
  if (form.formulation != problem.forms.front().formulation) text += ", " + form.formulation;
  return form.code == "optimised" ? text : text + ", " + form.code;
}

/// What was refused was never begun: wherever runs are counted, it is none.
std::ptrdiff_t runs_of(const StudyProblem& problem) {
  return std::count_if(problem.points.begin(), problem.points.end(),
                       [](const Point& point) { return point.status != PointStatus::refused; });
}

void tell(const StudyProblem& problem) {
  const bool is_short = std::any_of(problem.points.begin(), problem.points.end(),
                                    [](const Point& point) { return point.why == k_beyond_time; });
  std::string text =
      fmt::format("{}: {} runs{}, reference good to {:.1e}\n", problem.name, runs_of(problem),
                  problem.was_interrupted ? " until it was interrupted" : "", problem.reference.agreement);
  for (const double error : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Point* const best = cheapest(problem.points, error);
    text += best == nullptr
                ? fmt::format("  {:.0e}  no run delivered it{}\n", error,
                              is_short ? "; others had no time, and --budget gives it" : "")
                : fmt::format("  {:.0e}  {:8.3f} ms  {}\n", error, 1e3 * best->time, in_words(*best, problem));
  }
  cli::write_standard_output(text);
}

int say_interrupted(const std::vector<StudyProblem>& problems, const StudyOptions& options) {
  std::ptrdiff_t runs = 0;
  for (const StudyProblem& problem : problems) runs += runs_of(problem);
  cli::remark(fmt::format("interrupted: the study has {} runs, of {} of {} problems", runs, problems.size(),
                          options.files.size()),
              options.messages);
  return cli::k_interrupted;
}

/// Nothing is measured for files of which a later one is wrong. Returns an exit code; what is wrong is reported.
int check_files(const StudyOptions& options) {
  int worst = cli::k_ok;
  for (const std::string& file : options.files) {
    Request request{file, {}, {}, options.messages};
    request.instance = options.instance;
    const auto code_of = [&](bool is_silent) {
      request.messages.is_silent = is_silent;
      int code = cli::k_ok;
      const auto prepared = prepare(
          request, [](Scene&) {}, code);
      return code;
    };
    try {
      // Warnings come with the study itself.
      if (code_of(true) != cli::k_ok) worst = code_of(false);
    } catch (const cli::FileError& error) {
      worst = cli::fail(error.what(), cli::k_file_error, options.messages);
    }
    throw_if_ended();
  }
  return worst;
}

}  // namespace

int study(const StudyOptions& options) {
  const Interruption interruption;
  const std::string output = without_ending(options.output, {".html", ".json", ".csv"});
  if (options.loosest < options.tightest)
    throw cli::UsageError(
        fmt::format("--loosest {:g} is tighter than --tightest {:g}", options.loosest, options.tightest));
  if (std::filesystem::path(output).filename().empty())
    throw cli::UsageError(fmt::format("-o '{}': a name is missing, to which .json, .csv and .html are added", output));
  for (const char* const ending : {".json", ".csv", ".html"}) check_writable(output + ending);
  if (options.files.size() > 1) {
    const EndsAtOnce while_it_checks(options.messages);
    if (const int code = check_files(options); code != cli::k_ok) return code;
  }
  std::vector<StudyProblem> problems;
  for (const std::string& file : options.files) {
    int code = cli::k_ok;
    std::optional<StudyProblem> problem;
    try {
      problem = solve_problem(file, options, code);
    } catch (const Interrupted&) {
      if (problems.empty()) throw;
      break;
    }
    if (!problem) return code;
    if (!problem->why.empty())
      cli::warn(fmt::format("{}: there is no reference: {}", problem->name, problem->why), options.messages);
    if (!options.quiet && problem->why.empty()) tell(*problem);
    problems.push_back(std::move(*problem));
    if (Interruption::is_asked_for()) break;
  }
  const auto json = study_json(problems, options);
  std::list<cli::Replacement> files;
  files.emplace_back(output + ".json", json.dump(1) + "\n");
  files.emplace_back(output + ".csv", study_csv(problems));
  files.emplace_back(output + ".html", page_of(json));
  for (cli::Replacement& file : files) file.commit();
  if (!options.quiet) cli::write_standard_output(fmt::format("wrote {0}.json, {0}.csv and {0}.html\n", output));
  if (was_interrupted(problems, options)) return say_interrupted(problems, options);
  const bool tells_anything =
      std::any_of(problems.begin(), problems.end(), [](const StudyProblem& one) { return one.why.empty(); });
  return tells_anything ? cli::k_ok : cli::k_not_delivered;
}

}  // namespace gausssim
