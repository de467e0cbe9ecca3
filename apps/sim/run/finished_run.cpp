#include "sim/run/finished_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "sim/output/files.hpp"
#include "sim/run/jumps.hpp"
#include "sim/run/setting.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using gauss::simulate::Outcome;

/// Numbers of a state for people.
std::string said(double value) { return fmt::format("{:.3g}", value); }

/// In parts of ranges.
std::string in_words(const DeliveredError& error) {
  return said(error.value) + " of the range" + (error.output.empty() ? "" : ", largest in " + error.output);
}

/// Whether it is to be relied on is said where it is not.
std::string in_words(const Estimate& estimate, bool is_found) {
  std::string text = in_words(static_cast<const DeliveredError&>(estimate));
  if (is_found) return text;
  if (estimate.is_in_doubt()) return text + "; more may come of digits that are lost";
  if (estimate.is_by_rounding())
    return text +
           (estimate.rounding.is_told_in_wider
                ? fmt::format("; told by a run in {}, since tighter runs lose the same digits", estimate.rounding.wider)
                : " at most; from values that are rounded otherwise, runs differ by as much");
  if (!estimate.agreement) return text + "; by one tighter run, which no other one confirms";
  return estimate.is_confirmed()
             ? text
             : fmt::format("{} at most; two tighter runs agree to {} only", text, said(estimate.agreement->value));
}

/// Of forces that jump, or are functions of time: nobody knows of those that act for less than a step of what the run is compared with.
std::string what_is_seen(const PreparedModel& prepared) {
  if (!is_jump(prepared.edge) && !prepared.acts_in_time) return "";
  return fmt::format("; of what acts for {} s or longer", said(longest_steps(prepared).fine));
}

/// What a run is off by where tighter ones agree with it.
std::string beside_tighter_runs(const Estimate& error, const std::string& number) {
  const RoundingError& rounding = error.rounding;
  if (rounding.is_told_in_wider)
    return fmt::format(
        "a run in {} differs by {:.2g} of the range of '{}': in {}, formulas and equations lose too many digits, and",
        rounding.wider, error.value, error.output, number);
  return fmt::format(
      "a run from values that are rounded otherwise differs by {:.2g} of the range of '{}': one of the two is not "
      "this motion, as where steps miss what acts for a short time; a shorter longest_step shows it, and",
      error.value, error.output);
}

/// Of motions that nobody can follow, or not with this tolerance.
void warn_of_error(const Estimate& error, const std::string& number, const cli::MessageOptions& messages) {
  constexpr double k_useless = 0.1;
  if (error.is_in_doubt())
    return cli::warn(
        fmt::format("in {}, formulas and equations lose digits: {:.1g} of '{}' is rounding, and a run in {} "
                    "takes too long to tell what comes of it; --error 1e-3 does",
                    number, error.rounding.lost.value, error.rounding.lost.output, error.rounding.wider),
        messages);
  if (error.value < k_useless) return;
  const std::string what = error.is_by_rounding() && error.by_tighter_runs < k_useless
                               ? beside_tighter_runs(error, number)
                               : fmt::format("the table is off by {:.2g} of the range of '{}': it is not this motion;",
                                             error.value, error.output);
  cli::warn(what + " --error 1e-3 looks for a setting that is, or says that there is none", messages);
}

/// Of motions that end where steps of one length go on, or that nothing is compared with.
void warn_of_no_error(const KnownErrors& errors, const std::string& number, const cli::MessageOptions& messages) {
  const auto& [value, output] = errors.lost;
  if (errors.why_none.is_doubtful)
    cli::warn(errors.why_none.text + ", so that the table may be no motion of this model from there on", messages);
  if (value > 0)
    cli::warn(fmt::format("in {}, formulas and equations lose digits: {:.1g} of '{}' is rounding; --error 1e-3 tells "
                          "what comes of it",
                          number, value, output),
              messages);
}

/// Who wrote the closed form had another motion in mind. `asked`: for an error, or 0.
void warn_of_closed_forms(const KnownErrors& errors, double asked, const cli::MessageOptions& messages) {
  constexpr double k_apart = 1e-3, k_clear = 100;
  if (!errors.estimate || !errors.from_closed_forms) return;
  const auto& [apart, output] = *errors.from_closed_forms;
  if (apart < (asked > 0 ? std::min(asked, k_apart) : k_apart) || apart < k_clear * errors.estimate->value) return;
  cli::warn(fmt::format("the closed form of '{}' is another motion: it is {:.2g} of its range off, where the error is "
                        "about {:.2g}",
                        output, apart, errors.estimate->value),
            messages);
}

/// With the exit code of motions that end before their time.
int say_why_it_stops(const FinishedRun& finished, bool has_new_rows, const cli::MessageOptions& messages) {
  const Simulated& run = finished.run;
  const PreparedModel& prepared = finished.prepared;
  const std::string why = run.why.empty() ? gauss::simulate::name(run.outcome) : run.why;
  const bool is_by_steps = run.outcome == Outcome::too_many_steps || run.outcome == Outcome::step_too_small;
  std::string hint;
  if (run.outcome == Outcome::step_too_small && are_times_coarse(finished.setting.number, run.reached, prepared.span))
    hint = fmt::format(
        "in {}, times near {:.3g} s are {:.1g} s apart, which is too much for such short steps: begin nearer to 0, "
        "or take a looser tolerance or a wider number type",
        finished.setting.number, run.reached, rounding_unit(finished.setting.number) * std::abs(run.reached));
  else if (is_by_steps && !prepared.edge.empty())
    hint = hint_for_edge(prepared.edge);
  else if (run.outcome == Outcome::too_many_steps && finished.csv != "-" && has_new_rows)
    hint = "--resume goes on from the last row, for as many steps again";
  return cli::fail(
      fmt::format("the motion of {} stops at t = {:.10g}: {}{}", prepared.in_words(), run.reached, why,
                  run.status == gauss::Status::ok ? "" : std::string(" (status: ") + gauss::name(run.status) + ")"),
      cli::k_motion_stopped, messages, hint);
}

}  // namespace

std::string events_in_words(const Simulated& run) {
  if (run.events.empty()) return "none";
  std::vector<std::pair<std::string, long>> counts;
  for (const Event& event : run.events) {
    const auto known =
        std::find_if(counts.begin(), counts.end(), [&](const auto& one) { return one.first == event.what; });
    if (known == counts.end())
      counts.emplace_back(event.what, 1);
    else
      ++known->second;
  }
  std::stable_sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  constexpr std::size_t k_most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(counts.size(), k_most); ++i)
    text += fmt::format("{}{}{}", i == 0 ? "" : ", ", counts[i].first,
                        counts[i].second > 1 ? fmt::format(" {} times", counts[i].second) : "");
  return counts.size() > k_most ? text + ", ..." : text;
}

void tell(const FinishedRun& finished) {
  const auto& [prepared, setting, engine, run, times, errors, found, asked_before, csv] = finished;
  const std::string how = setting.step > 0 ? "step " + said(setting.step) : "tolerance " + said(setting.tolerance);
  const char* const projection =
      run.drift.has_constraints && setting.projection == Projection::off ? ", no projection" : "";
  std::string text =
      fmt::format("{}: {:.6g} s by {} ({}, {}, {}{})\n", prepared.name(), run.reached - prepared.span.start,
                  setting.method, how, setting.number, engine, projection);
  if (prepared.has_effects())
    text +=
        fmt::format("  effects {}\n", prepared.effects.empty() ? "none" : gaussgen::support::joined(prepared.effects));
  text += fmt::format("  steps   {} ({} refused), {} calls, {} s", run.steps, run.rejected, run.calls,
                      said(run.wall_seconds));
  text += times.was_cached || times.compile == 0 ? "\n" : fmt::format("; compiled in {} s\n", said(times.compile));
  if (found)
    text += fmt::format("  asked   for {} of the range; found by trying, against {}\n", said(*prepared.scene.error),
                        found->reference_in_words);
  text += fmt::format(
      "  error   {}{}\n",
      errors.estimate ? in_words(*errors.estimate, found.has_value()) : "not estimated: " + errors.why_none.text,
      errors.estimate ? what_is_seen(prepared) : "");
  if (errors.from_closed_forms) text += fmt::format("  exact   off by {}\n", in_words(*errors.from_closed_forms));
  if (run.drift.has_energy)
    text += fmt::format("  energy  changes by {} J of {} J\n", said(run.drift.energy), said(run.drift.energy_scale));
  if (run.drift.has_constraints)
    text += fmt::format("  drift   {} in positions, {} in velocities\n", said(run.drift.positions),
                        said(run.drift.velocities));
  if (prepared.regimes) {
    text += "  events  " + events_in_words(run) + "\n";
    text += fmt::format("  regimes {}, derived{} in {} s\n", run.regimes, engine == "compiled" ? " and compiled" : "",
                        said(run.regime_seconds));
  }
  text += fmt::format("  wrote   {} ({} rows of {} columns) and {}\n", csv, run.samples,
                      prepared.columns.columns.size() + 1, summary_path(csv));
  cli::write_standard_output(text);
}

int report_end(const FinishedRun& finished, bool has_new_rows, const cli::MessageOptions& messages) {
  const Simulated& run = finished.run;
  const auto& error = finished.errors.estimate;
  if (error && !finished.found) warn_of_error(*error, finished.setting.number, messages);
  if (!error) warn_of_no_error(finished.errors, finished.setting.number, messages);
  warn_of_closed_forms(finished.errors, finished.found ? *finished.prepared.scene.error : 0, messages);
  if (finished.found && error && run.outcome == Outcome::running && !(error->value <= *finished.prepared.scene.error))
    return cli::fail(fmt::format("the run is off by {:.2e}, in {}", error->value, error->output), cli::k_not_delivered,
                     messages);
  if (run.untrusted_samples > 0)
    cli::warn(fmt::format("not all outputs of {} samples are to be trusted: {}", run.untrusted_samples,
                          gauss::name(run.sample_status)),
              messages);
  if (run.was_interrupted) {
    cli::remark(fmt::format("interrupted at t = {:.10g}; the table ends there{}", run.reached,
                            finished.csv == "-" ? "" : ", and --resume goes on from it"),
                messages);
    return cli::k_interrupted;
  }
  return run.outcome == Outcome::running ? cli::k_ok : say_why_it_stops(finished, has_new_rows, messages);
}

}  // namespace gausssim
