#include "sim/run/build_engine.hpp"

#include "sim/engine/interpreted.hpp"
#include "sim/engine/plugin_text.hpp"
#include "sim/run/interruption.hpp"

namespace gausssim {

namespace {

/// From so many on, several at once are worth the time that a compiler takes for it: half a second, for half of a sample's time.
constexpr long k_many_samples = 10'000;

/// Of the constraints: all of them where the equations have no second way.
int usual_rank_of(const gaussgen::emit::Unit& unit) {
  for (const gaussgen::emit::Artefact& artefact : unit.artefacts)
    if (artefact.name == "rhs" && artefact.ways) return artefact.ways->usual_rank;
  return static_cast<int>(unit.constraints.size());
}

}  // namespace

void warn_of_interpreting(const EngineTimes& times, const gaussgen::cli::MessageOptions& messages) {
  if (!times.why_interpreted.empty()) gaussgen::cli::warn(times.why_interpreted + "; it is interpreted", messages);
}

std::string scalar_of(const std::string& number) {
  return number == "long-double" ? "long double" : number == "float128" ? "__float128" : number;
}

std::string number_of(const std::string& scalar) {
  return scalar == "long double" ? "long-double" : scalar == "__float128" ? "float128" : scalar;
}

std::unique_ptr<Engine> build_engine(const PreparedModel& prepared, EngineChoice choice,
                                     const std::vector<std::string>& scalars, EngineTimes& times, std::string& why) {
  auto interpreted = std::make_unique<InterpretedEngine>(prepared.model.tree);
  if (choice == EngineChoice::interpreted) return interpreted;
  auto toolchain = find_toolchain(why);
  if (!toolchain && choice != EngineChoice::automatic) return nullptr;
  if (!toolchain) {
    // Nobody misses a compiler, but for who has named one.
    if (is_compiler_chosen()) times.why_interpreted = why;
    return interpreted;
  }
  PluginRequest request;
  request.functions = {"prepare",   "rhs",      "project", "project_positions", "project_speeds", "energy",
                       "residuals", "jacobian", "guards",  "impact_system", "load_system"};
  const std::vector<std::string> sampled = names_of(prepared.columns.functions);
  request.functions.insert(request.functions.end(), sampled.begin(), sampled.end());
  if (prepared.span.samples >= k_many_samples) request.sampled = sampled;
  request.scalars = scalars;
  if (prepared.wants_gains) request.usual_rank = usual_rank_of(prepared.model.unit);
  if (uses_quad(request)) toolchain->libraries.push_back("-lquadmath");
  const std::string text = plugin_text(prepared.model.tree, request);
  const Built built =
      prepared.plugins ? prepared.plugins->get(text, *toolchain, ends_now) : build_plugin(text, *toolchain, ends_now);
  if (built.was_ended || Interruption::is_asked_for()) throw_if_ended();
  times = {built.compile_seconds, built.was_cached, {}};
  if (built.plugin) return std::make_unique<CompiledEngine>(built.plugin, std::move(interpreted));
  why = "the model cannot be compiled: " + built.why;
  if (choice != EngineChoice::automatic) return nullptr;
  times.why_interpreted = why;
  return interpreted;
}

}  // namespace gausssim
