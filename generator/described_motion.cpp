#include "described_motion.hpp"

#include "ir/differentiate.hpp"

namespace gaussgen {

namespace {

/// Of the largest entry. Lever arms differ by less, and a position that a search has found is better.
constexpr int k_digits = 12;

}  // namespace

bool describes_all_motion(Mechanics& mechanics, ModelValues& values) {
  kinematics::Frames& frames = mechanics.expressions.frames();
  strategy::Matrix motion;
  const auto add = [&](const ir::Vector3& velocity) {
    for (const ir::Expr component : velocity) {
      motion.emplace_back();
      for (const auto& speed : mechanics.symbols.speeds) motion.back().push_back(ir::partial(component, speed.symbol));
    }
  };
  for (std::size_t frame = 0; frame < mechanics.model.frames.size(); ++frame) {
    add(mechanics.expressions.rate(frames.origin(frame)));
    add(frames.omega(frame, model::Axes::body));
  }
  for (const kinematics::BodyMotion& body : *mechanics.kinematics.bodies) add(body.velocity);
  if (motion.empty() || motion[0].empty()) return true;
  const auto here = values(motion);
  const cln::cl_F part = values.number(cln::expt(support::Rational(10), -k_digits));
  return !here || evaluate::rank(*here, part) == here->columns();
}

}  // namespace gaussgen
