#include "sim/run/instances_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "sim/output/files.hpp"
#include "sim/regimes/impulse_units.hpp"
#include "sim/run/summary.hpp"
#include "support/suggest.hpp"
#include "version.hpp"

namespace gausssim {

namespace {

using gauss::simulate::Outcome;
using Json = nlohmann::ordered_json;

const std::string& name_of(const FinishedRun& run) { return run.prepared.scene.instance; }

bool is_finished(const FinishedRun& run) { return run.run.outcome == Outcome::running; }

std::string three_digits(double value) { return fmt::format("{:.3g}", value); }

std::string effects_of(const FinishedRun& run) {
  const auto& effects = run.prepared.effects;
  return effects.empty() ? "none" : gaussgen::support::joined(effects);
}

std::string error_of(const FinishedRun& run) {
  const auto& estimate = run.errors.estimate;
  if (!estimate) return "not estimated";
  return three_digits(estimate->value) + (estimate->output.empty() ? "" : " in " + estimate->output);
}

/// Columns as wide as what is in them.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) line += fmt::format(" {:<{}} ", row[i], widths[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::vector<std::string> row_of(const FinishedRun& run, const InstancesReport& report) {
  const PreparedModel& prepared = run.prepared;
  std::vector<std::string> row{name_of(run), std::to_string(prepared.code + 1)};
  if (prepared.has_effects()) row.push_back(effects_of(run));
  row.push_back(run.setting.method);
  row.push_back(std::to_string(run.run.steps));
  row.push_back(error_of(run));
  if (report.has_regimes()) row.push_back(events_in_words(run.run));
  if (!is_finished(run)) row.push_back(fmt::format("stops at {:.6g} s", run.run.reached));
  return row;
}

std::string table_of(const InstancesReport& report) {
  std::vector<std::string> head{"instance", "code"};
  if (report.runs.front().prepared.has_effects()) head.emplace_back("effects");
  for (const char* const word : {"method", "steps", "error of the range"}) head.emplace_back(word);
  if (report.has_regimes()) head.emplace_back("events");
  head.emplace_back("");
  std::vector<std::vector<std::string>> rows{std::move(head)};
  for (const FinishedRun& run : report.runs) {
    rows.push_back(row_of(run, report));
    rows.back().resize(rows.front().size());
  }
  return aligned(rows);
}

std::string plural(std::size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

struct Seconds {
  double generate = 0, compile = 0, run = 0;
};

Seconds seconds_of(const InstancesReport& report) {
  Seconds sum;
  for (const FinishedRun& run : report.runs) {
    sum.generate += run.prepared.generate_seconds;
    sum.compile += run.times.compile;
    sum.run += run.run.wall_seconds;
  }
  return sum;
}

std::string codes_in_words(const InstancesReport& report) {
  const SharedCodes& codes = report.among.codes;
  const Seconds seconds = seconds_of(report);
  std::string text = fmt::format("  codes   {} for {}, derived in {} s", codes.count(),
                                 plural(report.runs.size(), "instance"), three_digits(seconds.generate));
  // Constraints that are solved with the motion have bounds that come from values.
  if (codes.derivations() > codes.count()) text += fmt::format(" (equations {} times)", codes.derivations());
  if (seconds.compile > 0) text += fmt::format(", compiled in {} s", three_digits(seconds.compile));
  return text + fmt::format("; runs {} s\n", three_digits(seconds.run));
}

Json codes_json(const InstancesReport& report) {
  Json codes = Json::array();
  for (std::size_t number = 0; number < report.among.codes.count(); ++number) {
    Json code;
    for (const FinishedRun& run : report.runs) {
      if (run.prepared.code != number) continue;
      if (code.empty()) {
        if (run.prepared.has_effects()) code["effects"] = run.prepared.effects;
        code["operations"] = run.prepared.operations;
        code["instances"] = Json::array();
      }
      code["instances"].push_back(name_of(run));
    }
    codes.push_back(std::move(code));
  }
  return codes;
}

}  // namespace

bool InstancesReport::has_regimes() const {
  return std::any_of(runs.begin(), runs.end(), [](const FinishedRun& run) { return run.prepared.regimes != nullptr; });
}

FinishedRun with_full_names(const FinishedRun& run) {
  FinishedRun result = run;
  const auto name = [&](DeliveredError& error) {
    if (!error.output.empty()) error.output = name_of(run) + "." + error.output;
  };
  if (auto& estimate = result.errors.estimate) {
    name(*estimate);
    name(estimate->rounding.lost);
  }
  name(result.errors.lost);
  if (result.errors.from_closed_forms) name(*result.errors.from_closed_forms);
  // Nothing goes on from it.
  result.csv = "-";
  return result;
}

std::string in_words(const InstancesReport& report) {
  const PreparedModel& first = report.runs.front().prepared;
  std::string text = fmt::format("{}: {:.6g} s of {} ({}, {})\n", first.name_of_scene(), first.span.duration,
                                 plural(report.runs.size(), "instance"), report.runs.front().setting.number,
                                 report.runs.front().engine);
  text += table_of(report) + codes_in_words(report);
  std::size_t columns = 1;
  for (const FinishedRun& run : report.runs) columns += run.prepared.columns.columns.size();
  return text + fmt::format("  wrote   {} ({} rows of {} columns) and {}\n", report.csv, report.rows, columns,
                            summary_path(report.csv));
}

std::string in_json(const InstancesReport& report) {
  const PreparedModel& first = report.runs.front().prepared;
  const bool have_all_finished = std::all_of(report.runs.begin(), report.runs.end(), is_finished);
  Json json;
  json["tool"] = std::string("gauss-sim ") + gaussgen::k_version;
  json["model"] = first.model.unit.model_name;
  if (!first.scene.name.empty()) json["scene"] = first.scene.name;
  json["outcome"] = have_all_finished ? "finished" : "some stopped";
  json["start"] = first.span.start;
  json["duration"] = first.span.duration;
  json["samples"] = report.rows;
  json["codes"] = codes_json(report);
  json["derivations"] = report.among.codes.derivations();
  json["instances"] = Json::object();
  for (const FinishedRun& run : report.runs) {
    Json& one = json["instances"][name_of(run)];
    one["code"] = run.prepared.code;
    if (!run.prepared.scene.about.empty()) one["about"] = run.prepared.scene.about;
    one.update(how_it_went(run));
  }
  return json.dump(2) + "\n";
}

namespace {

/// Of all instances: contacts of one name are of one model.
Switches switches_of(const InstancesReport& report) {
  Switches all;
  for (const FinishedRun& run : report.runs) {
    if (run.prepared.regimes == nullptr) continue;
    const auto& contacts = run.prepared.regimes->switches().contacts;
    all.contacts.insert(all.contacts.end(), contacts.begin(), contacts.end());
  }
  return all;
}

}  // namespace

std::string events_csv(const InstancesReport& report) {
  struct Row {
    double t;
    std::string instance, text;
  };
  std::vector<Row> rows;
  const Switches all = switches_of(report);
  for (const FinishedRun& run : report.runs) {
    for (const Event& event : run.run.events)
      rows.push_back({event.t, name_of(run),
                      fmt::format("{},{},{},{}\n", event.t, name_of(run), event.what, cell_of_impulse(event, all))});
  }
  // Whatever the order of the instances is.
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.t < b.t || (a.t == b.t && a.instance < b.instance); });
  std::string text = fmt::format("t [s],instance,event,{}\n", head_of_impulses(all));
  for (const Row& row : rows) text += row.text;
  return text;
}

}  // namespace gausssim
