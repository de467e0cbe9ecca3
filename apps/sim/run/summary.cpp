#include "sim/run/summary.hpp"

#include <nlohmann/json.hpp>

#include "sim/run/resume.hpp"
#include "version.hpp"

namespace gausssim {

namespace {

using gauss::simulate::Outcome;
using Json = nlohmann::ordered_json;

Json drift_json(const Drift& drift) {
  Json json = Json::object();
  if (drift.has_energy)
    json["energy"] = {{"largest_change", drift.energy}, {"largest_kinetic", drift.energy_scale}, {"unit", "J"}};
  if (drift.has_constraints) json["constraints"] = {{"positions", drift.positions}, {"velocities", drift.velocities}};
  return json;
}

Json asked_json(const FoundSetting& found, double error) {
  return {{"error", error},
          {"reference", found.reference_in_words},
          {"agreement", found.agreement},
          {"settings_tried", found.trials.size()},
          // Of the processor, for a run that writes nothing: what settings are compared by.
          {"seconds", found.chosen.seconds}};
}

Json lost_json(const RoundingError& rounding) {
  Json json{{"relative", rounding.lost.value}, {"output", rounding.lost.output}, {"wider_number", rounding.wider}};
  if (rounding.is_told_in_wider) json["makes"] = rounding.value;
  return json;
}

Json estimate_json(const Estimate& estimate) {
  Json json{{"relative", estimate.value}, {"output", estimate.output}, {"constant", estimate.constants}};
  if (estimate.agreement) json["agreement"] = estimate.agreement->value;
  const RoundingError& rounding = estimate.rounding;
  if (rounding.value > 0 && !rounding.is_told_in_wider) json["rounding"] = rounding.value;
  if (rounding.lost.value > 0) json["digits_lost"] = lost_json(rounding);
  return json;
}

}  // namespace

Json how_it_went(const FinishedRun& finished) {
  const auto& [prepared, setting, engine, run, times, errors, found, asked_before, csv] = finished;
  Json json = Json::object();
  if (prepared.has_effects()) json["effects"] = prepared.effects;
  json["outcome"] = run.was_interrupted               ? "interrupted"
                    : run.outcome == Outcome::running ? "finished"
                                                      : gauss::simulate::name(run.outcome);
  json["status"] = gauss::name(run.status);
  json["start"] = prepared.span.start;
  json["reached"] = run.reached;
  json["duration"] = prepared.span.duration;
  json["samples"] = run.samples;
  json["engine"] = engine;
  json["method"] = setting.method;
  json["number"] = setting.number;
  if (setting.tolerance > 0) json["tolerance"] = setting.tolerance;
  if (setting.step > 0) json["step"] = setting.step;
  if (setting.longest_step > 0) json["longest_step"] = setting.longest_step;
  json["projection"] = name_of(setting.projection);
  if (setting.projection == Projection::gains) json["gain"] = setting.gain;
  json["steps"] = run.steps;
  json["rejected"] = run.rejected;
  json["calls"] = run.calls;
  json["jacobians"] = run.jacobians;
  if (errors.estimate)
    json["error_estimate"] = estimate_json(*errors.estimate);
  else
    json["not_estimated"] = errors.why_none.text;
  if (const auto& error = errors.from_closed_forms)
    json["from_closed_forms"] = {{"relative", error->value}, {"output", error->output}};
  if (found) json["asked_for"] = asked_json(*found, *prepared.scene.error);
  if (!asked_before.empty()) json["asked_for"] = Json::parse(asked_before);
  if (prepared.regimes) {
    json["regimes"] = run.regimes;
    json["events"] = run.events.size();
  }
  json["drift"] = drift_json(run.drift);
  if (run.start_moved > 0) json["start_moved"] = {{"by", run.start_moved}, {"component", run.start_component}};
  if (run.with_fewer_constraints > 0) json["steps_with_fewer_constraints"] = run.with_fewer_constraints;
  if (run.crossings > 0) json["crossings"] = run.crossings;
  if (run.untrusted_samples > 0)
    json["untrusted_samples"] = {{"count", run.untrusted_samples}, {"status", gauss::name(run.sample_status)}};
  json["seconds"] = {{"generate", prepared.generate_seconds},
                     {"compile", times.compile},
                     {"cached", times.was_cached},
                     {"run", run.wall_seconds},
                     {"run_cpu", run.cpu_seconds}};
  if (prepared.regimes) json["seconds"]["regimes"] = run.regime_seconds;
  return json;
}

std::string summary_of(const FinishedRun& finished) {
  const auto& [prepared, setting, engine, run, times, errors, found, asked_before, csv] = finished;
  Json json;
  json["tool"] = std::string("gauss-sim ") + gaussgen::k_version;
  json["model"] = prepared.model.unit.model_name;
  if (!prepared.scene.name.empty()) json["scene"] = prepared.scene.name;
  if (!prepared.scene.instance.empty()) json["instance"] = prepared.scene.instance;
  json.update(how_it_went(finished));
  json["last_state"] = run.last_state;
  json["resume"] = resume_json(prepared, run);
  return json.dump(2) + "\n";
}

}  // namespace gausssim
