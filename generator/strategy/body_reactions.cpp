#include "strategy/body_reactions.hpp"

#include "ir/contract.hpp"
#include "strategy/link_choice.hpp"
#include "strategy/link_origins.hpp"
#include "strategy/reactions.hpp"

namespace gaussgen::strategy {

using ir::Vector3;
using kinematics::BodyMotion;

namespace {

void begin(const std::string& body, Steps& steps) {
  steps.begin("all constraint forces on " + body + ": m a - F and d(I omega)/dt - M (theory.md, section 4)");
}

}  // namespace

std::vector<BodyReaction> body_reactions_by_speeds(const Dynamics& dynamics, const Solution& solution, Steps& steps) {
  std::vector<BodyReaction> reactions;
  for (const BodyMotion& body : *dynamics.kinematics->bodies) {
    begin(body.name, steps);
    const BodyAcceleration a = acceleration_of(body, dynamics, solution.accelerations);
    BodyReaction reaction{body.name, steps.name(body.mass * a.linear - body.force, "force_on_" + body.name), {}};
    if (body.is_rigid) {
      Vector3 moment = body.inertia_times(a.angular);
      const Vector3& omega = body.rotation.omega;
      if (!body.is_isotropic) moment = moment + cross(omega, body.inertia_times(omega));
      reaction.moment = steps.name(in_space(body, moment) - body.moment, "moment_on_" + body.name);
    }
    reactions.push_back(std::move(reaction));
  }
  return reactions;
}

namespace {

class PartReactions {
 public:
  PartReactions(const model::Model& model, const kinematics::Kinematics& kinematics, const TreeMotion& motion,
                Steps& steps)
      : model_(model),
        loads_(kinematics.loads),
        motion_(motion),
        steps_(steps),
        origins_(motion, kinematics.field[0].graph(), steps) {}

  BodyReaction of(const kinematics::Part& part) {
    const model::Body& body = model_.bodies[part.body];
    const kinematics::BodyLoad& load = loads_[part.body];
    begin(body.name.text, steps_);
    const ir::Rational force = motion_.mass * motion_.length;
    BodyReaction reaction{
        body.name.text,
        steps_.name(scaled(force, part.mass * acceleration(part)) - load.force, "force_on_" + body.name.text),
        {}};
    if (body.inertia) {
      const Vector3 moment = scaled(force * motion_.length, ir::multiply(origins_.axes(part.link), spin(part)));
      reaction.moment = steps_.name(moment - load.moment, "moment_on_" + body.name.text);
    }
    return reaction;
  }

 private:
  /// Of the mass centre against free fall: so the forces of fields are in it.
  Vector3 acceleration(const kinematics::Part& part) {
    const Vector3& origin = origins_.acceleration(part.link);
    if (is_zero(part.centre)) return origin;
    const Vector3& omega = motion_.omega[part.link];
    const Vector3 beside =
        cross(motion_.accelerations[part.link].angular, part.centre) + cross(omega, cross(omega, part.centre));
    return origin + ir::multiply(origins_.axes(part.link), beside);
  }

  Vector3 spin(const kinematics::Part& part) const {
    const Vector3& omega = motion_.omega[part.link];
    return ir::multiply(part.inertia, motion_.accelerations[part.link].angular) +
           cross(omega, ir::multiply(part.inertia, omega));
  }

  const model::Model& model_;
  const std::vector<kinematics::BodyLoad>& loads_;
  const TreeMotion& motion_;
  Steps& steps_;
  LinkOrigins origins_;
};

}  // namespace

std::optional<std::vector<BodyReaction>> body_reactions_by_links(const model::Model& model, const Dynamics& dynamics,
                                                                 const Solution& solution, Steps& steps) {
  if (!solution.motion) return std::nullopt;
  const std::vector<kinematics::Part>& parts = solution.motion->linkage.parts;
  std::vector<const kinematics::Part*> of_body(model.bodies.size(), nullptr);
  for (const kinematics::Part& part : parts) {
    // A body on two links, or beside a massless one, is told by its coordinates only.
    if (part.link == kinematics::k_ground || of_body[part.body] != nullptr) return std::nullopt;
    of_body[part.body] = &part;
  }
  PartReactions reactions(model, *dynamics.kinematics, *solution.motion, steps);
  std::vector<BodyReaction> result;
  for (const kinematics::Part* const part : of_body) {
    if (part == nullptr) return std::nullopt;
    result.push_back(reactions.of(*part));
  }
  return result;
}

namespace {

Vector values_of(const std::vector<BodyReaction>& reactions) {
  Vector values;
  for (const BodyReaction& reaction : reactions) {
    values.insert(values.end(), reaction.force.begin(), reaction.force.end());
    if (reaction.moment) values.insert(values.end(), reaction.moment->begin(), reaction.moment->end());
  }
  return values;
}

}  // namespace

std::vector<BodyReaction> body_reactions(const model::Model& model, const Dynamics& dynamics, const Solution& solution,
                                         Steps& steps) {
  return by_links_or_speeds<std::vector<BodyReaction>>(
      solution, [&](Steps& own) { return body_reactions_by_links(model, dynamics, solution, own); },
      [&](Steps& own) { return body_reactions_by_speeds(dynamics, solution, own); }, values_of, steps);
}

}  // namespace gaussgen::strategy
