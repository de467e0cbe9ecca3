#include "sim/effects/ladder_json.hpp"

#include <fmt/format.h>

#include "cli/exit_codes.hpp"
#include "cli/usage_error.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Measured& measured, const EffectsReport& report) {
  Json json{{"effects", in_order(measured.acting, report.bench.effects())}};
  if (measured.acting.empty()) json["effects"] = Json::array();
  if (!measured.why.empty()) {
    json["why"] = measured.why;
    return json;
  }
  json["operations"] = measured.operations;
  if (measured.ns > 0) json["ns"] = measured.ns;
  json["run_seconds"] = measured.seconds;
  json["calls"] = measured.calls;
  json["change"] = measured.change.value;
  if (!measured.change.output.empty()) json["output"] = measured.change.output;
  if (!measured.lacks.empty()) json["lacks"] = measured.lacks;
  return json;
}

Json json_of(const std::vector<Compared>& list, const EffectsReport& report) {
  Json json = Json::array();
  for (const Compared& one : list) {
    Json entry{{"what", one.move.what}};
    entry.update(json_of(one.measured, report));
    json.push_back(std::move(entry));
  }
  return json;
}

/// Of all that the model has, whether a scene calls for them or not.
Json abouts(const Workbench& bench) {
  Json json = Json::object();
  for (const auto& effect : bench.effects()) json[effect.name.text] = effect.about;
  return json;
}

Json why_not(const std::string& why) { return {{"why", why}}; }

}  // namespace

Json json_of(const EffectsReport& report) {
  const auto& [bench, ladder, need, chosen] = report;
  Json json{
      {"scene", bench.name()}, {"duration", bench.duration()}, {"method", bench.method()}, {"engine", bench.engine()}};
  if (bench.noise()) json["good_to"] = bench.noise()->value;
  json["about"] = abouts(bench);
  json["all"] = json_of(ladder.all, report);
  json["none"] = json_of(ladder.none, report);
  json["shared_operations"] = ladder.shared_operations();
  json["each"] = json_of(ladder.each, report);
  json["ladder"] = json_of(ladder.rungs, report);
  if (need) json["need"] = {{"change", *need}, {"chosen", json_of(*chosen, report)}};
  return json;
}

Json json_of_effects(const std::string& file, double seconds) {
  const TimeLimit limit(seconds);
  RunOptions options;
  options.file = file;
  options.messages.is_silent = true;
  Workbench bench(options);
  try {
    if (bench.begin() != gaussgen::cli::k_ok && !limit.is_over())
      return why_not("the run with all effects does not come to its end");
  } catch (const gaussgen::cli::UsageError& error) {
    return why_not(error.what());
  }
  const auto ladder = limit.is_over() ? std::nullopt : make_ladder(bench);
  if (Interruption::is_asked_for()) throw Interrupted{};
  if (!ladder || limit.is_over()) return why_not(fmt::format("runs without each take more than {:.3g} s", seconds));
  return json_of({bench, *ladder, {}, {}});
}

}  // namespace gausssim
