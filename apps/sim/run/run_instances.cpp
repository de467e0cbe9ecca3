#include "sim/run/run_instances.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "scene_choice.hpp"
#include "sim/output/csv.hpp"
#include "sim/output/files.hpp"
#include "sim/run/instances_report.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/prepared_instances.hpp"
#include "sim/run/watched_run.hpp"
#include "spec/reader.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

class InstancesRun {
 public:
  InstancesRun(const RunOptions& options, const PreparedInstances& prepared)
      : options_(options), prepared_(prepared), csv_(csv_path()) {
    for (const auto& one : prepared.all) bodies_.push_back(std::make_unique<Body>(options, *one));
  }

  int make() {
    check_outputs(csv_, {options_.file, prepared_.all.front()->model_file});
    for (const auto& body : bodies_) {
      if (const int code = choose(*body); code != cli::k_ok) return code;
    }
    for (const auto& body : bodies_) {
      if (const int code = run(*body); code != cli::k_ok) return code;
    }
    const bool has_motion =
        std::any_of(bodies_.begin(), bodies_.end(), [](const auto& body) { return body->run.samples > 0; });
    const std::vector<FinishedRun> finished = finish();
    if (has_motion) write(finished);
    return report(finished);
  }

 private:
  struct Body {
    Body(const RunOptions& options, const PreparedModel& prepared) : watched(options, prepared) {}

    WatchedRun watched;
    EngineTimes times;
    Simulated run;
    std::vector<std::string> rows;  ///< without ends of lines
  };

  std::string csv_path() const {
    return options_.output.empty() ? prepared_.all.front()->name_of_scene() + ".csv" : options_.output;
  }

  int choose(Body& body) {
    if (const int code = body.watched.choose(); code != cli::k_ok) return code;
    body.times = body.watched.engines().times();
    for (const std::string& text : {body.times.why_interpreted}) {
      if (!text.empty() && prepared_.among->is_new(text)) warn_of_interpreting(body.times, options_.messages);
    }
    warn_of_tolerance(body.watched.setting(), options_.messages);
    return cli::k_ok;
  }

  /// Rows of some instances without those of the others are no table.
  int run(Body& body) {
    body.run =
        body.watched.run([&](const std::string& row) { body.rows.push_back(row.substr(0, row.size() - 1)); }, nullptr);
    if (body.run.was_interrupted) throw Interrupted{};
    if (body.run.outcome != gauss::simulate::Outcome::bad_settings) return cli::k_ok;
    return cli::fail(fmt::format("{}: {}", body.watched.prepared().scene.instance, body.run.why), cli::k_usage_error,
                     options_.messages);
  }

  std::vector<FinishedRun> finish() {
    std::vector<FinishedRun> all;
    for (const auto& body : bodies_) {
      WatchedRun& watched = body->watched;
      all.push_back({watched.prepared(), watched.setting(), watched.engine().name(), body->run, body->times,
                     watched.errors_of(body->run, false), watched.found(), "", csv_});
    }
    return all;
  }

  void write(const std::vector<FinishedRun>& finished) const {
    CsvFile file(csv_);
    file.write(header());
    for (std::size_t k = 0; k < row_count(); ++k) file.write(row(k));
    const InstancesReport report{finished, *prepared_.among, csv_, static_cast<long>(row_count())};
    const std::string summary = in_json(report);
    file.finish();
    if (csv_ == "-") return;
    cli::Replacement(summary_path(csv_), summary).commit();
    if (report.has_regimes()) cli::Replacement(events_path(csv_), events_csv(report)).commit();
    if (!options_.quiet) cli::write_standard_output(in_words(report));
  }

  std::string header() const {
    std::vector<Column> columns;
    for (const auto& one : prepared_.all) {
      for (Column column : one->columns.columns) {
        column.name = one->scene.instance + "." + column.name;
        columns.push_back(std::move(column));
      }
    }
    return csv_header(columns);
  }

  std::size_t row_count() const {
    std::size_t most = 0;
    for (const auto& body : bodies_) most = std::max(most, body->rows.size());
    return most;
  }

  /// Cells of an instance that has stopped are empty.
  std::string row(std::size_t k) const {
    std::string text;
    for (const auto& body : bodies_) {
      if (text.empty() && k < body->rows.size()) text = body->rows[k].substr(0, body->rows[k].find(','));
    }
    for (const auto& body : bodies_) {
      if (k < body->rows.size())
        text += body->rows[k].substr(body->rows[k].find(','));
      else
        text += std::string(body->watched.prepared().columns.columns.size(), ',');
    }
    return text + "\n";
  }

  /// Of each that is not as it should be; the others are there all the same.
  int report(const std::vector<FinishedRun>& finished) const {
    int code = cli::k_ok;
    for (const FinishedRun& one : finished) {
      const int own = report_end(with_full_names(one), false, options_.messages);
      if (code == cli::k_ok) code = own;
    }
    return code;
  }

  const RunOptions& options_;
  const PreparedInstances& prepared_;
  std::string csv_;
  std::vector<std::unique_ptr<Body>> bodies_;
};

}  // namespace

bool has_instances(const gaussgen::support::Source& text) {
  if (!gaussgen::is_scene(text)) return false;
  gaussgen::support::Diagnostics said_later;
  const auto root = gaussgen::spec::read_yaml(text, said_later);
  const auto* const instances = root ? gaussgen::spec::find(*root, "instances") : nullptr;
  return instances != nullptr && !instances->entries.empty();
}

int run_instances(const RunOptions& options, const gaussgen::support::Source& text) {
  if (options.resume)
    throw cli::UsageError(
        "--resume: a scene with instances is written as a whole; --instance NAME goes on with one of them");
  if (options.budget)
    cli::warn("--budget is time of a search for a setting: without an error to look for there is none",
              options.messages);
  int code = cli::k_ok;
  const auto prepared = prepare_instances(options, text, code);
  if (!prepared) return code;
  return InstancesRun(options, *prepared).make();
}

}  // namespace gausssim
