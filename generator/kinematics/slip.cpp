#include "kinematics/slip.hpp"

#include "ir/contract.hpp"
#include "ir/cost.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;
using model::Axes;

namespace {

/// In space, rows of several wheels share what moves their axles.
constexpr int k_times_shared = 2;

/// Who moves along with the axes in which the direction is given. What turns with them, too, has constant places and axes there, where in
/// space each is a product of sines and cosines, which cancel in ways that no simplification is sure to find.
class Observer {
 public:
  Observer(Expressions& expressions, std::size_t frame, std::size_t place)
      : expressions_(expressions), frame_(frame), place_frame_(place), place_(place_seen()) {}

  /// Of the point of a frame that is at the place now, in the observer's axes: with δ from the observer's origin to that of the frame,
  /// v_B - v_O + ω_B × (r - δ) - ω_O × r.
  Vector3 velocity(std::size_t frame) {
    if (frame == frame_) return ir::zero3(expressions_.graph());
    Frames& frames = from_carrier_of(frame);
    const Vector3 away = turned(frames, frames.origin(frame) - frames.origin(frame_));
    const Vector3 shift =
        turned(frames, expressions_.rate(frames.origin(frame)) - expressions_.rate(frames.origin(frame_)));
    return shift + cross(turned(frames, frames.omega(frame, Axes::space)), place_ - away) -
           cross(frames.omega(frame_, Axes::body), place_);
  }

 private:
  Frames& from_carrier_of(std::size_t frame) {
    return expressions_.frames_from(expressions_.carrier_of({frame_, place_frame_, frame}));
  }

  Vector3 place_seen() {
    Frames& frames = from_carrier_of(place_frame_);
    return turned(frames, frames.origin(place_frame_) - frames.origin(frame_));
  }

  Vector3 turned(Frames& frames, const Vector3& v) const { return ir::multiply(transposed(frames.axes(frame_)), v); }

  Expressions& expressions_;
  std::size_t frame_;
  std::size_t place_frame_;
  Vector3 place_;
};

}  // namespace

Vector3 velocity_at(Expressions& expressions, std::size_t frame, const Vector3& place) {
  if (frame == model::k_space) return ir::zero3(expressions.graph());
  Frames& frames = expressions.frames();
  const Vector3 origin = frames.origin(frame);
  return expressions.rate(origin) + cross(frames.omega(frame, Axes::space), place - origin);
}

ContactLine contact_line(Expressions& expressions, const model::SlipLaw& law) {
  Frames& frames = expressions.frames();
  const auto* const place = std::get_if<std::size_t>(&law.at);
  const Vector3 point =
      place != nullptr ? frames.origin(*place) : expressions(std::get<std::array<model::Ast, 3>>(law.at));
  return {point, ir::multiply(frames.axes(law.axes), expressions(law.direction))};
}

Expr slip(Expressions& expressions, const model::SlipLaw& law, const ContactLine& line) {
  const Expr in_space = dot(line.direction, velocity_at(expressions, law.frame, line.point) -
                                                velocity_at(expressions, law.surface, line.point));
  const auto* const frame = std::get_if<std::size_t>(&law.at);
  if (frame == nullptr || expressions.carrier_of({law.axes}) == model::k_space) return in_space;
  Observer observer(expressions, law.axes, *frame);
  const Expr observed = dot(expressions(law.direction), observer.velocity(law.frame) - observer.velocity(law.surface));
  const auto count = [&](Expr e) { return ir::count_operations(expressions.graph(), {e.id()}); };
  const ir::OperationCount seen = count(observed), before = count(in_space);
  const bool has_no_angle_left = seen.functions == 0 && before.functions > 0;
  return has_no_angle_left || k_times_shared * seen.total() < before.total() ? observed : in_space;
}

}  // namespace gaussgen::kinematics
