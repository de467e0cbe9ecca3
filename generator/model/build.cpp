#include "model/build.hpp"

#include <fmt/format.h>

#include <utility>

#include "model/checks.hpp"
#include "model/fields.hpp"
#include "model/frames.hpp"
#include "model/names.hpp"
#include "model/regime.hpp"
#include "model/sections.hpp"
#include "model/submodels.hpp"
#include "spec/reader.hpp"
#include "support/content_hash.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

std::string base_name(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

void read_sections(const spec::Node& root, Reading& reading) {
  read_header(root, reading);
  read_tables(root, reading);  // expressions call them
  read_parameters(root, reading);
  read_inputs(root, reading);
  read_coordinates(root, reading);
  read_orientations(root, reading);
  read_frames(root, reading);
  read_joints(root, reading);
  read_speeds(root, reading);
  check_rate_names(reading);
  read_bodies(root, reading);
  order_frames(reading);
  read_constraints(root, reading);
  read_contacts(root, reading);
  read_forces(root, reading);
  read_quantities(root, reading);
  check_regime(reading);
  make_guards(reading);
  declare_reactions(reading);
  read_exact(root, reading);
  read_elimination(root, reading);
  read_rank_tolerance(root, reading);
  read_outputs(root, reading);
  read_sensitivities(root, reading);
}

}  // namespace

namespace {

/// Which is what users have at hand where a command takes models alone.
bool is_scene(const spec::Node& root, Reading& reading) {
  const spec::Node* const model = spec::find(root, "model");
  if (model == nullptr || spec::find(root, "coordinates") != nullptr) return false;
  reading.diagnostics.error(
      support::code::k_unknown_key, model->span, "this is a scene, and a model is asked for",
      model->kind == spec::NodeKind::scalar ? fmt::format("its model is '{}'", model->scalar.text) : "name its model");
  return true;
}

}  // namespace

std::optional<Model> build_model(support::Source& source, support::Diagnostics& diagnostics, const Choices& choices) {
  Reading reading{source, diagnostics, {}};
  reading.choices = choices;
  reading.model.is_ground = choices.is_ground;
  reading.model.file = base_name(source.name());
  reading.model.symbols["t"] = {SymbolKind::time, 0};
  reading.model.symbols["pi"] = {SymbolKind::pi, 0};

  // Other files stand behind it when it is read once more.
  const support::Source own = source.first();
  auto root = spec::read_yaml(own, diagnostics);
  if (!root || !expect_map(*root, root->span, "a model file", reading) || is_scene(*root, reading)) return std::nullopt;
  const spec::Node whole = with_submodels(*std::move(root), source, reading);
  reading.model.content_hash = support::content_hash(source.text());
  read_sections(whole, reading);
  check_model(reading);
  check_units(reading);
  // Next to errors this is of no interest.
  if (!diagnostics.has_errors()) check_frequencies(reading);
  check_dimensions(reading);
  diagnostics = reading.copies.in_own_names(diagnostics, source);
  if (diagnostics.has_errors()) return std::nullopt;
  return std::move(reading.model);
}

}  // namespace gaussgen::model
