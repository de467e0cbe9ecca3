#include "sim/run/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "cli/files.hpp"
#include "cli/usage_error.hpp"
#include "sim/output/csv.hpp"
#include "sim/run/identity.hpp"
#include "sim/run/setting.hpp"
#include "support/content_hash.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;
using Json = nlohmann::json;

std::string text_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) cli::fail_on(path, "there is no such file, so there is no run to go on with");
  return std::string(std::istreambuf_iterator<char>(in), {});
}

[[noreturn]] void refuse_summary(const std::string& path) {
  cli::fail_on(path, "this is no summary of a run that can go on");
}

Json parsed(const std::string& path) {
  Json result = Json::parse(text_of_file(path), nullptr, false);
  if (result.is_discarded() || !result.is_object() || !result.contains("resume")) refuse_summary(path);
  return result;
}

/// Whether a summary says the same of a run as its settings do now.
class Comparison {
 public:
  Comparison(std::string file, const Json& summary) : file_(std::move(file)), summary_(summary) {}

  void text(const char* key, const std::string& now) const {
    const std::string before = summary_.value(key, std::string());
    if (before != now) refuse(fmt::format("{} was '{}' and is '{}' now", key, before, now));
  }
  void number(const char* key, double now) const {
    const double before = summary_.value(key, 0.0);
    if (before != now) refuse(fmt::format("{} was {} and is {} now", key, before, now));
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw cli::UsageError(fmt::format("--resume: the run in '{}' is another one: {}", file_, why));
  }

 private:
  std::string file_;
  const Json& summary_;
};

/// A setting that was found for an error delivers no other one.
void compare_errors(const Json& summary, const Comparison& with, const Scene& scene) {
  const bool was_asked = summary.contains("asked_for");
  const double before = was_asked ? summary["asked_for"].at("error").get<double>() : 0;
  const double now = scene.error.value_or(0);
  if (before == now) return;
  if (was_asked) with.refuse(fmt::format("it was asked for an error of {0}, so --error {0} goes on with it", before));
  with.refuse(fmt::format("it was asked for no error, and for {} now", now));
}

void compare(const Json& summary, const std::string& file, const PreparedModel& prepared, const Setting& setting) {
  const Comparison with(file, summary);
  compare_errors(summary, with, prepared.scene);
  with.text("model", prepared.model.unit.model_name);
  with.text("scene", prepared.scene.name);
  with.text("instance", prepared.scene.instance);
  with.text("method", setting.method);
  with.text("number", setting.number);
  with.text("projection", name_of(setting.projection));
  with.number("tolerance", setting.tolerance);
  with.number("step", setting.step);
  with.number("longest_step", setting.longest_step);
  with.number("gain", setting.projection == Projection::gains ? setting.gain : 0);
  with.number("start", prepared.span.start);
  with.number("duration", prepared.span.duration);
  Comparison(file, summary["resume"]).number("samples", static_cast<double>(prepared.span.samples));
}

/// After columns: other ones may ask for other functions.
void compare_models(const Json& summary, const std::string& file, const PreparedModel& prepared) {
  if (summary["resume"].value("model", std::string()) != identity_of(prepared))
    Comparison(file, summary).refuse("the model, or a value in it or in its start, has changed");
}

bool is_number(const std::string& text) {
  char* end = nullptr;
  const long double value = std::strtold(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value);
}

/// Also nan and inf, which tables have where an output is not to be trusted.
bool is_row(std::string_view row, std::size_t width) {
  for (std::size_t cell = 0; cell < width; ++cell) {
    double value = 0;
    const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), value);
    if (error == std::errc::invalid_argument) return false;
    row.remove_prefix(static_cast<std::size_t>(end - row.data()));
    const bool is_last = cell + 1 == width;
    if (is_last) return row.empty();
    if (row.empty() || row.front() != ',') return false;
    row.remove_prefix(1);
  }
  return false;
}

void check_rows(std::string_view rows, const std::string& csv, std::size_t width) {
  for (long line = 2; !rows.empty(); ++line) {
    const std::size_t end = rows.find('\n');
    if (!is_row(rows.substr(0, end), width))
      cli::fail_on(csv, fmt::format("line {} is no row of {} numbers, so this is no table to go on with", line, width));
    rows.remove_prefix(end + 1);
  }
}

void check_header(const std::string& table, const std::string& csv, const std::string& header) {
  if (table.compare(0, header.size(), header) != 0)
    throw cli::UsageError(fmt::format("--resume: '{}' has other columns than are asked for", csv));
}

/// The header and a row for each sample, and nothing else.
void check_table(const std::string& table, const std::string& csv, const PreparedModel& prepared, long samples) {
  const std::string header = csv_header(prepared.columns.columns);
  const auto lines = std::count(table.begin() + static_cast<std::ptrdiff_t>(header.size()), table.end(), '\n');
  if (lines != samples || table.back() != '\n')
    cli::fail_on(csv, fmt::format("it has {} rows where its summary says {}", lines, samples));
  check_rows(std::string_view(table).substr(header.size()), csv, prepared.columns.columns.size() + 1);
}

gauss::Status status_of(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(gauss::Status::violated_constraints); ++i) {
    if (name == gauss::name(static_cast<gauss::Status>(i))) return static_cast<gauss::Status>(i);
  }
  return gauss::Status::ok;
}

Drift drift_of(const Json& summary) {
  Drift drift;
  const Json from = summary.value("drift", Json::object());
  if (from.contains("energy")) {
    drift.energy = from["energy"].value("largest_change", 0.0);
    drift.energy_scale = from["energy"].value("largest_kinetic", 0.0);
  }
  if (from.contains("constraints")) {
    drift.positions = from["constraints"].value("positions", 0.0);
    drift.velocities = from["constraints"].value("velocities", 0.0);
  }
  return drift;
}

Simulated run_of(const Json& summary) {
  Simulated run;
  run.samples = summary.at("samples").get<long>();
  run.reached = summary.at("reached").get<double>();
  run.steps = summary.at("steps").get<long>();
  run.rejected = summary.at("rejected").get<long>();
  run.calls = summary.at("calls").get<long>();
  run.jacobians = summary.at("jacobians").get<long>();
  run.with_fewer_constraints = summary.value("steps_with_fewer_constraints", 0L);
  run.crossings = summary.value("crossings", 0L);
  if (summary.contains("start_moved")) {
    run.start_moved = summary["start_moved"].at("by").get<double>();
    run.start_component = summary["start_moved"].at("component").get<std::string>();
  }
  if (summary.contains("untrusted_samples")) {
    run.untrusted_samples = summary["untrusted_samples"].at("count").get<long>();
    run.sample_status = status_of(summary["untrusted_samples"].at("status").get<std::string>());
  }
  run.drift = drift_of(summary);
  run.wall_seconds = summary.at("seconds").at("run").get<double>();
  run.cpu_seconds = summary.at("seconds").at("run_cpu").get<double>();
  run.last_state = summary.at("last_state").get<std::vector<std::string>>();
  run.start_energy = summary["resume"].value("start_energy", std::string());
  run.kept_energy = summary["resume"].value("kept_energy", std::string());
  for (const Json& event : summary["resume"].value("events", Json::array()))
    run.events.push_back({event.at(0).get<double>(), event.at(1).get<std::string>(), event.at(2).get<double>()});
  return run;
}

/// A summary belongs to the table that ends like this.
std::string end_of(std::string_view last_row, const std::vector<std::string>& last_state) {
  return gaussgen::support::content_hash(fmt::format("{}{}", last_row, fmt::join(last_state, " ")));
}

std::string_view last_line(std::string_view table) {
  const std::size_t before = table.rfind('\n', table.size() - 2);
  return table.substr(before + 1);
}

/// What nobody has edited.
bool is_sound(const Simulated& run, const Span& span, bool is_finished) {
  for (const long count : {run.steps, run.rejected, run.calls, run.jacobians, run.with_fewer_constraints, run.crossings,
                           run.untrusted_samples})
    if (count < 0) return false;
  const bool has_samples = run.samples >= 1 && run.samples <= span.samples;
  return has_samples && (!is_finished || run.samples == span.samples) && run.reached >= span.start &&
         run.reached <= span.start + span.duration;
}

EarlierRun earlier_run_of(const Json& said, const std::string& csv, const std::string& summary,
                          const PreparedModel& prepared, const Setting& setting) {
  compare(said, summary, prepared, setting);
  EarlierRun earlier;
  earlier.table = text_of_file(csv);
  check_header(earlier.table, csv, csv_header(prepared.columns.columns));
  compare_models(said, summary, prepared);
  const std::string outcome = said.value("outcome", std::string());
  earlier.is_finished = outcome == "finished";
  const bool can_go_on = outcome == "interrupted" || outcome == name(gauss::simulate::Outcome::too_many_steps);
  if (!earlier.is_finished && !can_go_on)
    throw cli::UsageError(fmt::format("--resume: the motion in '{}' has stopped by itself: {}", csv, outcome));
  earlier.run = run_of(said);
  if (said.contains("asked_for")) earlier.asked_for = said["asked_for"].dump();
  const auto& last = earlier.run.last_state;
  const bool is_state = last.size() == prepared.model.size() && std::all_of(last.begin(), last.end(), is_number);
  if (!is_state || !is_sound(earlier.run, prepared.span, earlier.is_finished)) refuse_summary(summary);
  check_table(earlier.table, csv, prepared, earlier.run.samples);
  earlier.run.last_row = last_line(earlier.table);
  if (said["resume"].value("end", std::string()) != end_of(earlier.run.last_row, last))
    cli::fail_on(csv, "its last row is not that of the run in " + summary);
  return earlier;
}

}  // namespace

Setting setting_of_earlier_run(const std::string& path) {
  const Json summary = parsed(path);
  Setting setting;
  try {
    setting.method = summary.at("method").get<std::string>();
    setting.number = summary.at("number").get<std::string>();
    setting.projection = projection_of(summary.at("projection").get<std::string>());
    setting.tolerance = summary.value("tolerance", 0.0);
    setting.step = summary.value("step", 0.0);
    setting.longest_step = summary.value("longest_step", 0.0);
  } catch (const Json::exception&) {
    refuse_summary(path);
  }
  const MethodInfo* const method = find_method(setting.method);
  if (method == nullptr || !computes_in(*method, setting.number)) refuse_summary(path);
  return setting;
}

nlohmann::ordered_json resume_json(const PreparedModel& prepared, const Simulated& run) {
  nlohmann::ordered_json result;
  result["model"] = identity_of(prepared);
  result["samples"] = prepared.span.samples;
  result["end"] = end_of(run.last_row, run.last_state);
  if (!run.start_energy.empty()) result["start_energy"] = run.start_energy;
  if (!run.kept_energy.empty()) result["kept_energy"] = run.kept_energy;
  for (const Event& event : run.events) result["events"].push_back({event.t, event.what, event.impulse});
  return result;
}

EarlierRun read_earlier_run(const std::string& csv, const std::string& summary, const PreparedModel& prepared,
                            const Setting& setting) {
  const Json said = parsed(summary);
  try {
    return earlier_run_of(said, csv, summary, prepared, setting);
  } catch (const Json::exception&) {
    refuse_summary(summary);
  }
}

}  // namespace gausssim
