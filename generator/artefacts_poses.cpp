#include <set>

#include "artefact_builder.hpp"
#include "emit/identifiers.hpp"
#include "kinematics/body_motions.hpp"

namespace gaussgen {

namespace {

using emit::Field;

std::vector<Field> pose_of(const kinematics::BodyMotion& body) {
  std::vector<Field> fields{{"position", "[m], space axes, of the mass centre", {3}, ids(body.position)}};
  if (!body.is_rigid) return fields;
  std::vector<emit::NodeId> entries;
  for (const ir::Vector3& row : body.rotation.matrix) {
    for (const emit::NodeId id : ids(row)) entries.push_back(id);
  }
  fields.push_back({"rotation", "from components along the body's axes to those in space", {3, 3}, std::move(entries)});
  return fields;
}

/// Two places that stay together close a loop, as a joint would.
bool is_closing(const model::Constraint& constraint) {
  const auto* const law = std::get_if<model::PositionLaw>(&constraint.law);
  return law != nullptr && law->is_coincidence;
}

/// Of a constraint; nothing where it is none of a place, or of several.
std::optional<ir::Vector3> place_of(const model::Constraint& constraint, const kinematics::ConstraintRow& row) {
  if (row.point) return row.point;
  if (row.actions.empty()) return std::nullopt;
  const bool is_of_one =
      row.actions.size() == 1 || is_closing(constraint) || std::holds_alternative<model::SlipLaw>(constraint.law);
  return is_of_one ? std::optional(row.actions.front().point) : std::nullopt;
}

void add_places_of_constraints(ArtefactBuilder& builder, const Mechanics& mechanics) {
  std::set<std::string> known;
  for (const auto mu : mechanics.kinematics.constraints.indices()) {
    const model::Constraint& constraint = mechanics.model.constraints[mu.value];
    const auto place = place_of(constraint, mechanics.kinematics.constraints[mu]);
    const std::string name = model::name_in_file(constraint);
    if (!place || !known.insert(name).second) continue;
    const bool closes = is_closing(constraint);
    builder.fields((closes ? "closing_" : "where_") + name, (closes ? "Closing" : "Where") + emit::pascal_case(name),
                   (closes ? "closing joint " : "where the reaction acts of ") + name,
                   {{"position", "[m], space axes", {3}, ids(*place)}});
  }
}

}  // namespace

std::vector<emit::Artefact> poses_artefact(Mechanics& mechanics) {
  ArtefactBuilder builder("poses", "Where bodies and joints are, and how bodies are turned.", mechanics);
  builder.artefact().takes_inputs = false;
  builder.result_type("Poses");
  for (const kinematics::BodyMotion& body : *mechanics.kinematics.bodies)
    builder.fields(body.name, emit::pascal_case(body.name) + "Pose", "body " + body.name, pose_of(body));
  for (const kinematics::Cut& joint : *mechanics.kinematics.joints) {
    if (!joint.is_joint) continue;
    builder.fields("at_" + joint.name, "At" + emit::pascal_case(joint.name), "joint " + joint.name,
                   {{"position", "[m], space axes", {3}, ids(joint.point)}});
  }
  add_places_of_constraints(builder, mechanics);
  std::vector<emit::Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

}  // namespace gaussgen
