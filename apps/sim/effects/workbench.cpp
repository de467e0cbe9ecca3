#include "sim/effects/workbench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/usage_error.hpp"
#include "scene_choice.hpp"
#include "sim/drive/stopwatch.hpp"
#include "sim/engine/binding.hpp"
#include "sim/run/engines.hpp"
#include "sim/run/in_rows.hpp"
#include "sim/run/setting.hpp"
#include "sim/run/settings.hpp"
#include "sim/scene/instances.hpp"
#include "sim/scene/read_scene.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

/// Rates of others would take their place in the cache of the processor; these are of one function alone.
double ns_of_rates(const PreparedModel& prepared, const Engine& engine) {
  const auto functions = bind<double>(engine, prepared.model);
  Numbers<double> state;
  initial_state(engine, prepared.model, *functions, state);
  Numbers<double> rates(state.size(), 0.0);
  double best = 0;
  constexpr int k_blocks = 7;
  constexpr double k_block = 1e-3;
  int calls = 16;
  for (int block = 0; block < k_blocks;) {
    const Stopwatch watch;
    for (int k = 0; k < calls; ++k) functions->rates(prepared.span.start, state.data(), rates.data());
    const double seconds = watch.seconds().cpu;
    if (seconds < k_block && calls < 10'000'000) {
      calls *= 2;
      continue;
    }
    const double one = 1e9 * seconds / calls;
    best = block++ == 0 ? one : std::min(best, one);
  }
  return best;
}

double median_seconds(const PreparedModel& prepared, const Engine& engine, const Setting& setting, double first) {
  constexpr double k_long = 2;
  std::vector<double> times{first};
  constexpr double k_enough = 0.02;
  constexpr std::size_t k_least = 5, k_most = 500;
  double sum = first;
  while (first < k_long && times.size() < k_most && (times.size() < k_least || sum < k_enough)) {
    times.push_back(unheard(prepared, engine, setting).cpu_seconds);
    sum += times.back();
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

std::string why_it_ends(const Simulated& run) {
  if (!run.why.empty()) return run.why;
  return fmt::format("{} at t = {:.6g} s", gauss::simulate::name(run.outcome), run.reached);
}

/// Where neither options nor the scene say it: all effects, and the state, since energies would say as much as everything else together, of
/// effects that have some.
void choose_what_is_shown(RunOptions& options) {
  const auto source = cli::read_source(options.file);
  Scene scene;
  gaussgen::support::Diagnostics said_later;
  if (gaussgen::is_scene(source)) scene = read_scene(source, said_later).value_or(Scene());
  if (const Instance* const found = find_instance(scene, options.instance)) {
    const Instance one = *found;
    take_instance(one, scene);
  }
  if (options.outputs.empty() && scene.outputs.empty()) options.outputs = {"state"};
  if (options.effects.empty() && scene.effects.empty()) options.effects = {"all"};
}

}  // namespace

int Workbench::begin() {
  const cli::MessageOptions messages = options_.messages;
  choose_what_is_shown(options_);
  int code = cli::k_ok;
  const auto prepared = prepare_run(options_, code);
  if (!prepared) return code;
  if (!prepared->has_effects())
    throw cli::UsageError(
        fmt::format("'{}' has no effects; docs/effects.md says how a model gets some", options_.file));
  if (prepared->scene.error)
    throw cli::UsageError("'error' looks for a setting: name a method and a tolerance instead, for all runs");
  if (prepared->effects.empty()) throw cli::UsageError("none of the effects acts: --effects all takes all of them");
  options_.messages.is_silent = true;
  name_ = prepared->name();
  about_ = prepared->scene.about.empty() ? prepared->model.unit.about : prepared->scene.about;
  model_file_ = prepared->model_file;
  effects_ = prepared->known_effects;
  all_ = {prepared->effects.begin(), prepared->effects.end()};
  columns_ = prepared->columns.columns;
  duration_ = prepared->span.duration;
  const Measured of_all = measure(*prepared, all_);
  if (!of_all.why.empty()) return cli::fail(of_all.why, cli::k_motion_stopped, messages);
  known_[all_] = of_all;
  return cli::k_ok;
}

const Measured& Workbench::measured(const EffectSet& acting) {
  if (const auto known = known_.find(acting); known != known_.end()) return known->second;
  RunOptions options = options_;
  options.effects = {"none"};
  for (const std::string& name : acting) options.effects.push_back("+" + name);
  int code = cli::k_ok;
  std::optional<PreparedModel> prepared;
  std::string why = "there are no equations without what it leaves out";
  try {
    prepared = prepare_run(options, code);
  } catch (const cli::UsageError& error) {
    why = error.what();
  }
  if (prepared) return known_[acting] = measure(*prepared, acting);
  Measured none;
  none.acting = acting;
  none.why = why;
  return known_[acting] = none;
}

Rows Workbench::in_columns_of_all(const Rows& rows, const std::vector<Column>& columns,
                                  std::vector<std::string>& lacks) const {
  std::vector<std::size_t> place(columns_.size(), columns.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [&](const Column& column) { return column.name == columns_[i].name; });
    place[i] = static_cast<std::size_t>(found - columns.begin());
    if (found == columns.end()) lacks.push_back(columns_[i].name);
  }
  const long samples = std::min(rows.samples(), rows_.samples());
  Rows result(columns_.size(), samples);
  std::vector<long double> row(columns_.size());
  for (long k = 0; k < samples; ++k) {
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = place[i] < columns.size() ? rows.at(k, place[i]) : rows_.at(k, i);
    result.set(k, row);
  }
  return result;
}

Measured Workbench::measure(const PreparedModel& prepared, const EffectSet& acting) {
  Measured result;
  result.acting = acting;
  result.operations = prepared.operations;
  Engines engines(prepared, engine_choice(prepared.scene));
  const Engine* const engine = engines.of(number_name(prepared.scene));
  if (engine == nullptr) {
    result.why = engines.why();
    return result;
  }
  const Setting setting = setting_of(prepared, *engine);
  const RunInRows found = in_rows(prepared, *engine, setting, Meter::none);
  if (found.run.outcome != gauss::simulate::Outcome::running) {
    result.why = why_it_ends(found.run);
    return result;
  }
  if (known_.empty()) {
    const auto closer = tighter_runs(prepared, *engine, engines, setting, found.run, found.rows, why_no_noise_);
    if (closer) {
      yardstick_ = closer->yardstick;
      noise_ = closer->error;
      if (closer->agreement && closer->agreement->value > noise_->value) noise_ = closer->agreement;
    } else {
      yardstick_ =
          Yardstick(found.rows, found.rows, columns_, least_range(setting.tolerance), rounding_unit(setting.number));
    }
    rows_ = found.rows;
    method_ = setting.method;
    engine_ = engine->name();
  } else {
    result.change = yardstick_.difference(in_columns_of_all(found.rows, prepared.columns.columns, result.lacks), rows_);
  }
  result.calls = found.run.calls;
  result.ns = number_name(prepared.scene) == "double" ? ns_of_rates(prepared, *engine) : 0;
  result.seconds = median_seconds(prepared, *engine, setting, found.run.cpu_seconds);
  return result;
}

}  // namespace gausssim
