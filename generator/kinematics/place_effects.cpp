#include "kinematics/place_effects.hpp"

#include "ir/contract.hpp"
#include "kinematics/slip.hpp"

namespace gaussgen::kinematics {

using ir::Vector3;
using model::Axes;

PlaceEffect PlaceEffects::operator()(const Push& push, std::optional<BodyIndex> body) const {
  const Components all = generalized(push);
  const Components none(symbols_.full_count(), number(0));
  if (!body) return {none, all};
  if (is_felt_whole(push, *body)) return {all, none};
  Push on_carrier = push;
  on_carrier.frame = carriers_.pushed(push.frame);
  PlaceEffect result{has_unfelt_moment(push, *body) ? at_centre(*body, push.force) : generalized(on_carrier), all};
  for (const FullIndex i : all.indices()) result.unfelt[i] -= result.felt[i];
  return result;
}

bool PlaceEffects::is_felt_whole(const Push& push, BodyIndex body) const {
  return carriers_.pushed(push.frame) == push.frame && !has_unfelt_moment(push, body);
}

Vector3 PlaceEffects::moment_about(BodyIndex body, const Push& push) const {
  return push.moment + cross(push.point - motions_.position(body), push.force);
}

/// Q_A = F·∂v_P/∂ẏ^A + M·∂ω/∂ẏ^A (theory section 6)
Components PlaceEffects::generalized(const Push& push) const {
  Components Q(symbols_.full_count(), number(0));
  const Vector3 velocity = velocity_at(expressions_, push.frame, push.point);
  const Vector3 omega = expressions_.frames().omega(push.frame, Axes::space);
  for (const FullIndex i : Q.indices()) {
    for (std::size_t x = 0; x < 3; ++x) {
      Q[i] += push.force[x] * partials_(velocity[x], i);
      Q[i] += push.moment[x] * partials_(omega[x], i);
    }
  }
  return Q;
}

Components PlaceEffects::at_centre(BodyIndex body, const Vector3& force) const {
  Components Q(symbols_.full_count(), number(0));
  for (const FullIndex i : Q.indices()) Q[i] = dot(force, motions_[body].J[i]);
  return Q;
}

bool PlaceEffects::has_unfelt_moment(const Push& push, BodyIndex body) const {
  return !motions_.is_rigid(body) && !is_zero(moment_about(body, push));
}

}  // namespace gaussgen::kinematics
