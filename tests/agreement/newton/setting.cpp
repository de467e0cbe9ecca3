#include "newton/setting.hpp"

#include <algorithm>

namespace agreement::newton {

using gaussgen::model::Ast;
using gaussgen::model::Frame;
using gaussgen::model::k_space;

namespace {

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace

Setting::Setting(Specimen& at)
    : specimen(at),
      model(at.model),
      course(at.model, at.fixed, at.state),
      motion(course.motion(at.a)),
      time(course.passage_of_time()),
      loads(newton::loads(at.model, motion)) {
  for (const auto& constraint : model.constraints) actions.push_back(newton::actions(model, constraint, motion));
  for (std::size_t i = 0; i < course.full_count(); ++i) displaced.push_back(course.displacement(i));
  find_beta();
  find_terms();
}

void Setting::find_beta() {
  const std::size_t l = model.constraints.size();
  beta = Eigen::MatrixXd::Zero(index(l), index(course.full_count()));
  drift = Eigen::VectorXd::Zero(index(l));
  Motion base = course.motion(std::vector<double>(course.free_count(), 0.0));
  for (std::size_t mu = 0; mu < l; ++mu) drift[index(mu)] = phi(model.constraints[mu], base).rate;
  for (std::size_t i = 0; i < course.full_count(); ++i) {
    Motion pushed = course.unit_acceleration(i);
    for (std::size_t mu = 0; mu < l; ++mu) {
      beta(index(mu), index(i)) = phi(model.constraints[mu], pushed).rate - drift[index(mu)];
    }
  }
}

void Setting::find_terms() {
  for (const auto& body : model.bodies) {
    Terms size;
    const double m = motion(body.mass).value;
    size.force = m * centre(body).second.norm();
    const Eigen::Matrix3d I = body.inertia ? inertia(body, motion) : Eigen::Matrix3d::Zero();
    const double stretch = I.norm();
    size.moment = stretch * motion.omega(body.frame).value.squaredNorm();
    for (std::size_t i = 0; i < specimen.a.size(); ++i) {
      const double a = std::fabs(specimen.a[i]);
      size.force += m * a * displaced[i].point(body.frame, displaced[i](body.centre)).rate.norm();
      size.moment += a * stretch * displaced[i].omega(body.frame).value.norm();
    }
    terms.push_back(size);
  }
}

double Setting::size_of_work(Motion& displacement) {
  double size = work_of_loads(loads, displacement).size;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const auto& body = model.bodies[i];
    size += terms[i].force * displacement.point(body.frame, displacement(body.centre)).rate.norm();
    size += terms[i].moment * displacement.omega(body.frame).value.norm();
  }
  return size;
}

bool Setting::acts_on(const Load& load, std::size_t body) const {
  return load.body != nullptr ? load.body == &model.bodies[body] : body_of(load.frame) == body;
}

std::optional<std::size_t> Setting::body_of(std::size_t frame) const {
  for (std::size_t at = frame; at != k_space; at = model.frames[at].parent) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      if (model.bodies[i].frame == at) return i;
    }
    if (joint_at(at) || moves(model.frames[at])) return only_body_of(at);
  }
  return std::nullopt;
}

/// Of a part with several bodies beside each other, nobody said which feels what acts on it.
std::optional<std::size_t> Setting::only_body_of(std::size_t part) const {
  std::optional<std::size_t> only;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (part_of(model.bodies[i].frame) != part) continue;
    if (only) return std::nullopt;
    only = i;
  }
  return only;
}

std::size_t Setting::part_of(std::size_t frame) const {
  while (frame != k_space && !joint_at(frame) && !moves(model.frames[frame])) frame = model.frames[frame].parent;
  return frame;
}

std::optional<std::size_t> Setting::joint_at(std::size_t frame) const {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    if (model.joints[j].frame == frame) return j;
  }
  return std::nullopt;
}

std::optional<std::size_t> Setting::link_of(std::size_t frame) const {
  for (std::size_t at = frame; at != k_space; at = model.frames[at].parent) {
    if (const auto joint = joint_at(at)) return joint;
  }
  return std::nullopt;
}

bool Setting::varies(const Ast& ast) const {
  using gaussgen::model::SymbolKind;
  if (ast.kind == gaussgen::model::AstKind::symbol) {
    const SymbolKind kind = model.resolve(ast.name).kind;
    return kind != SymbolKind::parameter && kind != SymbolKind::pi;
  }
  return std::any_of(ast.children.begin(), ast.children.end(), [&](const Ast& child) { return varies(child); });
}

bool Setting::moves(const Frame& frame) const {
  if (std::holds_alternative<gaussgen::model::QuaternionOrientation>(frame.attitude)) return true;
  for (const Ast& component : frame.position) {
    if (varies(component)) return true;
  }
  const auto* turns = std::get_if<gaussgen::model::Turns>(&frame.attitude);
  if (turns == nullptr) return false;
  return std::any_of(turns->begin(), turns->end(), [&](const auto& turn) { return varies(turn.angle); });
}

bool Setting::is_of_joints() const {
  for (std::size_t i = 0; i < model.frames.size(); ++i) {
    if (!joint_at(i) && moves(model.frames[i])) return false;
  }
  const auto is_carried = [&](const auto& thing) { return link_of(thing.frame).has_value(); };
  return !model.joints.empty() && std::all_of(model.bodies.begin(), model.bodies.end(), is_carried) &&
         std::all_of(loads.begin(), loads.end(), is_carried);
}

Sum work_of_loads(const std::vector<Load>& loads, Motion& displaced) {
  Sum sum;
  for (const Load& load : loads) sum.add(work(load, displaced));
  return sum;
}

}  // namespace agreement::newton
