#include "sim/ensemble/choose_lanes.hpp"

#include <fmt/format.h>

#include "cli/usage_error.hpp"

namespace gausssim {

namespace {

namespace cli = gaussgen::cli;

/// Why nobody could have lanes here; empty where they may be built.
std::string why_none(const Engine& engine, const Setting& setting) {
  if (setting.method != "taylor") return fmt::format("method '{}' takes one trajectory at a time", setting.method);
  if (setting.projection != Projection::full && setting.projection != Projection::off)
    return "series take full projection, or none";
  if (setting.number != "double") return "lanes are of double";
  if (engine.name() != std::string("compiled")) return "the model is interpreted";
  return "";
}

}  // namespace

BuiltLanes choose_lanes(const std::string& wanted, const PreparedModel& prepared, const Engine& engine,
                        const Setting& setting, const cli::MessageOptions& messages) {
  BuiltLanes built;
  if (wanted == "1") return built;
  const bool is_automatic = wanted == "auto";
  built.why = why_none(engine, setting);
  const bool is_possible = built.why.empty();
  if (is_possible) built = build_lanes(prepared.model);
  if (!built.kernel && !is_automatic) throw cli::UsageError(fmt::format("--lanes {}: {}", wanted, built.why));
  if (!built.kernel && is_possible) cli::remark("no lanes: " + built.why, messages);
  if (built.kernel && !is_automatic && std::to_string(built.kernel->lanes()) != wanted)
    throw cli::UsageError(fmt::format("--lanes {}: this processor has {} of double", wanted, built.kernel->lanes()));
  return built;
}

}  // namespace gausssim
