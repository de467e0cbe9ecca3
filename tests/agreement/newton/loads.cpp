#include "newton/loads.hpp"

#include <set>
#include <stdexcept>

namespace agreement::newton {

using gaussgen::model::Ast;
using gaussgen::model::Body;
using gaussgen::model::Constraint;
using gaussgen::model::k_space;
using gaussgen::model::Model;

namespace {

Vector centre(const Body& body, Motion& motion) { return motion.point(body.frame, motion(body.centre)); }

class Loads {
 public:
  Loads(const Model& model, Motion& motion) : model_(model), motion_(motion) {}

  std::vector<Load> all() {
    for (const auto& force : model_.forces) std::visit([&](const auto& law) { apply(law); }, force.law);
    return result_;
  }

 private:
  void apply(const gaussgen::model::Potential&) {}
  void apply(const gaussgen::model::GeneralizedForce&) {}
  void apply(const gaussgen::model::CoordinateSpring&) {}

  /// Of models with regimes, which these equations do not have: nothing may pass for compared.
  void apply(const gaussgen::model::Friction&) { throw std::logic_error("friction is not among these loads"); }

  void apply(const gaussgen::model::UniformField& law) {
    const Vector3 field = motion_(law.field).value;
    for (const Body& body : model_.bodies) {
      const Vector3 weight = motion_(body.mass).value * field;
      result_.push_back({body.frame, centre(body, motion_).value, weight, Vector3::Zero(), true, &body});
    }
  }

  void apply(const gaussgen::model::PointForce& law) {
    const Vector3 point = motion_.point(law.frame, motion_(law.at)).value;
    const Vector3 force = motion_.axes(law.axes).value * motion_(law.components).value;
    add(pushed(law.frame), point, force, Vector3::Zero(), false);
    add(pushed(law.from), point, -force, Vector3::Zero(), false);
  }

  void apply(const gaussgen::model::Torque& law) {
    const Vector3 moment = motion_.axes(law.axes).value * motion_(law.components).value;
    add(law.frame, motion_.origin(law.frame).value, Vector3::Zero(), moment, false);
    add(law.from, motion_.origin(law.from).value, Vector3::Zero(), -moment, false);
  }

  void apply(const gaussgen::model::Spring& law) {
    const Vector gap = motion_.origin(law.second) - motion_.origin(law.first);
    const Real k = motion_(law.stiffness).value;
    const Real c = law.damping ? motion_(*law.damping).value : 0;
    Vector3 elastic = k * gap.value;
    Vector3 damping = c * gap.rate;
    if (law.length) {
      const Real distance = gap.value.norm();
      const Vector3 along = gap.value / distance;
      elastic = k * (distance - motion_(*law.length).value) * along;
      damping = c * (gap.rate.dot(along) - motion_(*law.length).rate) * along;
    }
    for (const auto& [force, has_potential] : {std::pair{elastic, true}, std::pair{damping, false}}) {
      add(law.first, motion_.origin(law.first).value, force, Vector3::Zero(), has_potential);
      add(law.second, motion_.origin(law.second).value, -force, Vector3::Zero(), has_potential);
    }
  }

  std::size_t pushed(std::size_t frame) const { return gaussgen::model::pushed_by_force_on(model_, frame); }

  void add(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment, bool has_potential) {
    if (frame != k_space) result_.push_back({frame, point, force, moment, has_potential, nullptr});
  }

  const Model& model_;
  Motion& motion_;
  std::vector<Load> result_;
};

Number squared(const Vector& v) {
  Number sum = constant(0);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Number x{v.value[i], v.rate[i], v.second[i]};
    sum = sum + x * x;
  }
  return sum;
}

/// Of a spring between places; `motion` says how it is stretched, `law_motion` what its stiffness and length do.
Number energy_of(const gaussgen::model::Spring& law, Motion& motion, Motion& law_motion) {
  const Vector gap = motion.origin(law.second) - motion.origin(law.first);
  Number square = squared(gap);
  if (law.length) {
    const Number stretch = pow(square, 0.5) - law_motion(*law.length);
    square = stretch * stretch;
  }
  return constant(0.5) * law_motion(law.stiffness) * square;
}

Number stretch_of(const gaussgen::model::CoordinateSpring& law, Motion& motion) {
  const Number y = motion.values().at(law.coordinate.text);
  return law.rest ? y - motion(*law.rest) : y;
}

void place_names(const Ast& ast, std::set<std::string>& names) {
  if (ast.kind == gaussgen::model::AstKind::symbol && ast.name.find('.') != std::string::npos) names.insert(ast.name);
  for (const Ast& child : ast.children) place_names(child, names);
}

}  // namespace

std::vector<Load> loads(const Model& model, Motion& motion) { return Loads(model, motion).all(); }

Sum work(const Load& load, Motion& displaced) {
  Sum sum;
  const Vector at = displaced.origin(load.frame);
  const Vector3 turn = displaced.omega(load.frame).value;
  const Vector3 arm = load.point - at.value;
  for (Eigen::Index i = 0; i < 3; ++i) {
    sum.add(load.force[i] * at.rate[i]);
    sum.add(load.moment[i] * turn[i]);
  }
  sum.add(load.force.dot(turn.cross(arm)));
  return sum;
}

Matrix3 inertia(const Body& body, Motion& motion) {
  const auto entry = [&](std::size_t i) { return motion(body.inertia->entries[i]).value; };
  using Shape = gaussgen::model::Inertia::Shape;
  if (body.inertia->shape == Shape::isotropic) return entry(0) * Matrix3::Identity();
  Matrix3 I = Vector3(entry(0), entry(1), entry(2)).asDiagonal();
  if (body.inertia->shape == Shape::diagonal) return I;
  I(0, 1) = I(1, 0) = entry(3);
  I(0, 2) = I(2, 0) = entry(4);
  I(1, 2) = I(2, 1) = entry(5);
  return I;
}

Vector3 rate_of_spin(const Body& body, Motion& motion) {
  const Matrix3 I = inertia(body, motion);
  const Matrix R = motion.axes(body.frame);
  const Vector omega = motion.omega(body.frame);
  const Matrix3 in_space = R.value * I * R.value.transpose();
  const Matrix3 half = R.rate * I * R.value.transpose();
  return in_space * omega.rate + (half + half.transpose()) * omega.value;
}

Sum work_of_inertia(const Body& body, Motion& motion, Motion& displaced) {
  Sum sum;
  const Vector3 force = motion(body.mass).value * centre(body, motion).second;
  const Vector3 along = centre(body, displaced).rate;
  for (Eigen::Index i = 0; i < 3; ++i) sum.add(force[i] * along[i]);
  if (!body.inertia) return sum;
  const Vector3 spin = rate_of_spin(body, motion);
  const Vector3 turn = displaced.omega(body.frame).value;
  for (Eigen::Index i = 0; i < 3; ++i) sum.add(spin[i] * turn[i]);
  return sum;
}

WorkAlong work_along_coordinates(const Model& model, Motion& motion, Motion& displaced) {
  WorkAlong result;
  for (const auto& force : model.forces) {
    if (const auto* potential = std::get_if<gaussgen::model::Potential>(&force.law)) {
      result.of_potentials.add(-displaced(potential->energy).rate);
    } else if (const auto* generalized = std::get_if<gaussgen::model::GeneralizedForce>(&force.law)) {
      for (const auto& [name, component] : generalized->components) {
        const auto found = displaced.values().find(name.text);
        if (found != displaced.values().end()) result.others.add(motion(component).value * found->second.rate);
      }
    } else if (const auto* spring = std::get_if<gaussgen::model::CoordinateSpring>(&force.law)) {
      const Real along = displaced.values().at(spring->coordinate.text).rate;
      const Real rate = stretch_of(*spring, motion).rate;
      result.of_potentials.add(-motion(spring->stiffness).value * stretch_of(*spring, motion).value * along);
      if (spring->damping) result.others.add(-motion(*spring->damping).value * rate * along);
    }
  }
  return result;
}

Energy energy(const Model& model, Motion& motion, Motion& time) {
  Energy result;
  for (const Body& body : model.bodies) {
    const Vector at = centre(body, motion);
    const Real m = motion(body.mass).value;
    result.kinetic.add(m / 2 * at.rate.squaredNorm());
    if (!body.inertia) continue;
    const Matrix3 R = motion.axes(body.frame).value;
    const Vector3 omega = R.transpose() * motion.omega(body.frame).value;
    result.kinetic.add(omega.dot(inertia(body, motion) * omega) / 2);
  }
  for (const auto& force : model.forces) {
    if (const auto* field = std::get_if<gaussgen::model::UniformField>(&force.law)) {
      for (const Body& body : model.bodies) {
        const Real m = motion(body.mass).value;
        const Vector3 at = centre(body, motion).value;
        const Vector strength = time(field->field);
        result.potential.add(-m * strength.value.dot(at));
        result.potential.size += m * strength.value.norm() * at.norm();
        result.explicit_power.add(-m * strength.rate.dot(at));
      }
    } else if (const auto* potential = std::get_if<gaussgen::model::Potential>(&force.law)) {
      const Number V = time(potential->energy);
      result.potential.add(V.value);
      result.explicit_power.add(V.rate);
    } else if (const auto* spring = std::get_if<gaussgen::model::Spring>(&force.law)) {
      result.potential.add(energy_of(*spring, motion, motion).value);
      // Through its law alone: what its ends do is the power of its forces.
      Motion resting(model, at_rest(motion.values()));
      result.explicit_power.add(energy_of(*spring, resting, time).rate);
    } else if (const auto* along = std::get_if<gaussgen::model::CoordinateSpring>(&force.law)) {
      const Number stretch = stretch_of(*along, time);
      const Number V = constant(0.5) * time(along->stiffness) * stretch * stretch;
      result.potential.add(V.value);
      result.explicit_power.add(V.rate);
    }
  }
  return result;
}

Number phi(const Constraint& constraint, Motion& motion) {
  if (const auto* velocity = std::get_if<gaussgen::model::VelocityLaw>(&constraint.law)) return motion(velocity->phi);
  if (const auto* position = std::get_if<gaussgen::model::PositionLaw>(&constraint.law)) {
    // Of what closes along axes, the velocity as the common carrier sees it: df/dt where it is closed.
    if (position->phi) return motion(*position->phi);
    const Number f = motion(position->f);
    return {f.rate, f.second, 0};
  }
  const auto& slip = std::get<gaussgen::model::SlipLaw>(constraint.law);
  const auto* frame = std::get_if<std::size_t>(&slip.at);
  const Vector place = frame != nullptr ? motion.origin(*frame) : motion(std::get<std::array<Ast, 3>>(slip.at));
  const Vector direction = motion.axes(slip.axes) * motion(slip.direction);
  const auto velocity_of = [&](std::size_t i) {
    const Vector zero{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    return i == k_space ? zero : motion.velocity_at(i, place);
  };
  const Vector slipping = velocity_of(slip.frame) - velocity_of(slip.surface);
  return {direction.value.dot(slipping.value), direction.rate.dot(slipping.value) + direction.value.dot(slipping.rate),
          0};
}

// The acceleration of a place enters dφ/dt with the factor with which its velocity enters φ.
std::vector<Load> actions(const Model& model, const Constraint& constraint, Motion& motion) {
  std::vector<Load> result;
  if (const auto* slip = std::get_if<gaussgen::model::SlipLaw>(&constraint.law)) {
    const auto* frame = std::get_if<std::size_t>(&slip->at);
    const Vector3 place =
        (frame != nullptr ? motion.origin(*frame) : motion(std::get<std::array<Ast, 3>>(slip->at))).value;
    const Vector3 direction = motion.axes(slip->axes).value * motion(slip->direction).value;
    result.push_back({slip->frame, place, direction, Vector3::Zero(), false, nullptr});
    result.push_back({slip->surface, place, -direction, Vector3::Zero(), false, nullptr});
  } else {
    const auto* velocity = std::get_if<gaussgen::model::VelocityLaw>(&constraint.law);
    std::set<std::string> names;
    place_names(velocity != nullptr ? velocity->phi : std::get<gaussgen::model::PositionLaw>(constraint.law).f, names);
    for (const std::string& name : names) {
      const gaussgen::model::SymbolRef ref = model.resolve(name);
      const Vector at = motion.origin(ref.index / 3);
      const auto i = static_cast<Eigen::Index>(ref.index % 3);
      const auto with = [&](Real second) {
        Values values = motion.values();
        values[name] = {at.value[i], at.rate[i], second};
        Motion pushed(model, std::move(values));
        return phi(constraint, pushed).rate;
      };
      result.push_back(
          {ref.index / 3, at.value, (with(1) - with(0)) * Vector3::Unit(i), Vector3::Zero(), false, nullptr});
    }
  }
  std::vector<Load> felt;
  for (const Load& load : result) {
    if (load.frame != k_space) felt.push_back(load);
  }
  return felt;
}

}  // namespace agreement::newton
