#include "sim/ensemble/summary.hpp"

#include <algorithm>
#include <cmath>

#include "version.hpp"

namespace gausssim {

namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Distribution::Kind kind) {
  return kind == Distribution::Kind::uniform       ? "uniform"
         : kind == Distribution::Kind::normal      ? "normal"
         : kind == Distribution::Kind::log_uniform ? "log_uniform"
                                                   : "points";
}

Json varied_json(const Varied& one) {
  Json json;
  json["name"] = one.name;
  json["section"] = name_of(one.section);
  const Distribution& distribution = one.distribution;
  if (distribution.is_random()) {
    json[name_of(distribution.kind)] = {distribution.a, distribution.b};
  } else {
    json["points"] = distribution.points.size();
    json["least"] = *std::min_element(distribution.points.begin(), distribution.points.end());
    json["most"] = *std::max_element(distribution.points.begin(), distribution.points.end());
  }
  return json;
}

std::vector<double> finals_of(const Outcomes& outcomes, std::size_t column) {
  std::vector<double> values;
  for (std::size_t i = 0; i < outcomes.ended.size(); ++i) {
    const double value = outcomes.finals[i * outcomes.width + column];
    if (outcomes.ended[i].how == Ended::How::finished && std::isfinite(value)) values.push_back(value);
  }
  return values;
}

Json statistics_json(const Column& column, const Statistics& statistics) {
  Json json;
  json["output"] = column.name;
  json["unit"] = column.unit;
  json["count"] = statistics.count;
  if (statistics.count == 0) return json;
  json["mean"] = statistics.mean;
  json["deviation"] = statistics.deviation;
  json["least"] = statistics.least;
  json["most"] = statistics.most;
  json["quantiles"] = Json::array();
  for (std::size_t k = 0; k < k_shares.size(); ++k)
    json["quantiles"].push_back({{"share", k_shares[k]}, {"value", statistics.quantiles[k]}});
  return json;
}

void add_setting(const EnsembleSetting& all, Json& json) {
  const Setting& setting = all.setting;
  json["method"] = setting.method;
  json["number"] = setting.number;
  if (setting.tolerance > 0) json["tolerance"] = setting.tolerance;
  if (setting.step > 0) json["step"] = setting.step;
  if (setting.longest_step > 0) json["longest_step"] = setting.longest_step;
  for (const auto& [name, how] : k_projections) {
    if (how == setting.projection) json["projection"] = name;
  }
  json["lanes"] = all.lanes == nullptr ? 1 : all.lanes->lanes();
  json["threads"] = all.threads;
  json["record"] = all.records_samples ? "samples" : "end";
}

}  // namespace

std::vector<Statistics> statistics_of_outputs(const Outcomes& outcomes) {
  std::vector<Statistics> result;
  for (std::size_t k = 0; k < outcomes.width; ++k) result.push_back(statistics_of(finals_of(outcomes, k)));
  return result;
}

std::map<std::string, long> counts_by_status(const Outcomes& outcomes) {
  std::map<std::string, long> counts;
  for (const Ended& one : outcomes.ended) {
    if (one.how != Ended::How::not_run) ++counts[status_text(one)];
  }
  return counts;
}

double rate_of(long count, const Outcomes& outcomes) {
  return outcomes.wall_seconds > 0 ? static_cast<double>(count) / outcomes.wall_seconds : 0;
}

nlohmann::ordered_json ensemble_json(const EnsembleTold& told) {
  const PreparedModel& prepared = told.prepared;
  const Ensemble& ensemble = *prepared.scene.ensemble;
  const Outcomes& outcomes = told.outcomes;
  Json json;
  json["tool"] = std::string("gauss-sim ") + gaussgen::k_version;
  json["model"] = prepared.model.unit.model_name;
  if (!prepared.scene.name.empty()) json["scene"] = prepared.scene.name;
  json["outcome"] = told.was_interrupted ? "interrupted" : "finished";
  json["trajectories"] = outcomes.ended.size();
  json["run"] = outcomes.run();
  json["by_status"] = counts_by_status(outcomes);
  json["seed"] = ensemble.seed;
  json["varied"] = Json::array();
  for (const Varied& one : ensemble.varied) json["varied"].push_back(varied_json(one));
  json["start"] = prepared.span.start;
  json["duration"] = prepared.span.duration;
  json["engine"] = told.engine;
  add_setting(told.setting, json);
  if (told.setting.lanes != nullptr) json["left_lanes"] = outcomes.left_lane();
  json["steps"] = outcomes.steps();
  if (outcomes.untrusted() > 0) json["untrusted_rows"] = outcomes.untrusted();
  json["trajectories_per_s"] = rate_of(outcomes.run(), outcomes);
  json["steps_per_s"] = rate_of(outcomes.steps(), outcomes);
  json["seconds"] = {{"generate", prepared.generate_seconds},
                     {"compile", told.times.compile + told.lanes_seconds},
                     {"cached", told.times.was_cached},
                     {"run", outcomes.wall_seconds},
                     {"run_cpu", outcomes.cpu_seconds}};
  json["statistics"] = Json::array();
  for (std::size_t k = 0; k < told.statistics.size(); ++k)
    json["statistics"].push_back(statistics_json(prepared.columns.columns[k], told.statistics[k]));
  return json;
}

}  // namespace gausssim
