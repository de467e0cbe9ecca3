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
  std::vector<emit::Artefact> result;
  result.push_back(builder.finish({}));
  return result;
}

}  // namespace gaussgen
