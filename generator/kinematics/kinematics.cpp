#include "kinematics/kinematics.hpp"

#include <algorithm>
#include <memory>

#include "ir/contract.hpp"
#include "kinematics/constraint_rows.hpp"
#include "kinematics/held_frames.hpp"
#include "kinematics/hold.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;
using support::Indexed;

namespace {

class Builder {
 public:
  Builder(const model::Model& model, ir::Graph& graph, Expressions& expressions, const Symbols& symbols)
      : model_(model),
        graph_(graph),
        expressions_(expressions),
        symbols_(symbols),
        partials_(graph, symbols),
        motions_(model, expressions, partials_),
        carriers_(model, expressions),
        effects_(symbols, expressions, partials_, motions_, carriers_),
        rows_(model, symbols, expressions, partials_, motions_, carriers_, effects_),
        loads_(model.bodies.size(), BodyLoad{ir::zero3(graph), ir::zero3(graph)}) {}

  Kinematics run() {
    const Components none(symbols_.full_count(), number(0));
    Kinematics result{symbols_,
                      {},
                      {},
                      {},
                      {},
                      {},
                      {},
                      expressions_.configuration_rates(),
                      speeds_at_rest(),
                      {},
                      {},
                      none,
                      ir::zero3(graph_),
                      {},
                      none,
                      none,
                      {},
                      {},
                      {},
                      {},
                      {},
                      {},
                      {},
                      {},
                      {}};
    for (const model::Constraint& constraint : model_.constraints) result.constraints.push_back(rows_(constraint));
    for (const model::Constraint& constraint : model_.idle_slips)
      result.idle_slips.push_back(rows_.of_idle_slip(constraint));
    for (const model::Frame& frame : model_.frames) result.frame_names.push_back(frame.name.text);
    expressions_.carry_velocities(symbols_.full_count() > k_few_rates);
    for (std::size_t i = 0; i < model_.forces.size(); ++i) {
      const std::vector<ir::NodeId> before = felt(result);
      const std::size_t applied = result.applied.size();
      std::visit([&](const auto& law) { apply(law, result); }, model_.forces[i].law);
      if (felt(result) == before && !reaches_joint(result, applied)) {
        result.idle_forces.push_back(i);
      } else if (std::visit([&](const auto& law) { return is_inner(law); }, model_.forces[i].law)) {
        result.inner_forces.push_back(i);
      }
    }
    result.loads = loads_.values();
    for (const model::NamedQuantity& quantity : model_.quantities) {
      result.quantities.emplace_back();
      for (const model::Ast& value : quantity.values) result.quantities.back().push_back(expressions_(value));
    }
    for (const model::Guard& guard : model_.guards) {
      result.guards.push_back(expressions_(guard.value));
      result.guard_limits.push_back(guard.limit ? over_reactions(*guard.limit) : number(0));
    }
    expressions_.carry_velocities(false);
    if (model_.is_ground) result.switches = switch_rows();
    return result;
  }

  Indexed<BodyIndex, BodyMotion> bodies(const Vector3& field) {
    Indexed<BodyIndex, BodyMotion> result;
    for (const BodyIndex i : loads_.indices()) {
      BodyMotion body = motions_[i];
      body.force = loads_[i].force + body.mass * field;
      body.moment = loads_[i].moment;
      result.push_back(std::move(body));
    }
    return result;
  }

  std::vector<Cut> joints() {
    std::vector<Cut> result;
    for (const model::Joint& joint : model_.joints) {
      result.push_back({joint.name.text, joint.frame, expressions_.frames().origin(joint.frame), true});
    }
    return result;
  }

  std::vector<HeldFrame> held_frames() { return kinematics::held_frames(model_, symbols_, expressions_, partials_); }

  // Q_A = m field·J_A and V = -m field·r (theory section 6)
  Indexed<FullIndex, Expr> field_force(const Vector3& field) {
    Components Q(symbols_.full_count(), number(0));
    for (const BodyIndex b : loads_.indices()) {
      const BodyMotion& body = motions_[b];
      for (const FullIndex i : Q.indices()) Q[i] += body.mass * dot(field, body.J[i]);
    }
    return Q;
  }

  Expr other_potential() const { return potential_; }

  Expr potential(const Vector3& field) {
    Expr sum = potential_;
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      sum -= expressions_(model_.bodies[i].mass) * dot(field, motions_.position(BodyIndex{i}));
    }
    return sum;
  }

 private:
  /// What forces add to.
  std::vector<ir::NodeId> felt(const Kinematics& result) const {
    std::vector<ir::NodeId> sums;
    for (const Expr Q : result.body_force) sums.push_back(Q.id());
    for (const Expr Q : result.other_force) sums.push_back(Q.id());
    for (const BodyIndex i : loads_.indices()) {
      for (const Expr component : loads_[i].force) sums.push_back(component.id());
      if (!motions_.is_rigid(i)) continue;
      for (const Expr component : loads_[i].moment) sums.push_back(component.id());
    }
    if (has_mass()) {
      for (const Expr component : result.field) sums.push_back(component.id());
    }
    return sums;
  }

  template <class Law>
  bool is_inner(const Law&) const {
    return false;
  }

  /// The opposite acts at the same place.
  bool is_inner(const model::PointForce& law) const { return carriers_.are_fixed_together(law.frame, law.from); }
  bool is_inner(const model::Torque& law) const { return carriers_.are_fixed_together(law.frame, law.from); }

  /// Along the line through its ends. Without a length the damper is across it when the part turns, and brakes this.
  bool is_inner(const model::Spring& law) const {
    return (law.length || !law.damping) && carriers_.are_fixed_together(law.first, law.second);
  }

  /// Whether a joint carries something on which one of the forces from `begin` on acts.
  bool reaches_joint(const Kinematics& result, std::size_t begin) const {
    return std::any_of(result.applied.begin() + static_cast<std::ptrdiff_t>(begin), result.applied.end(),
                       [&](const AppliedForce& applied) {
                         if (is_zero(applied.force) && is_zero(applied.moment)) return false;
                         std::size_t at = applied.frame;
                         while (at != model::k_space && !carriers_.is_carried_by_joint(at))
                           at = model_.frames[at].parent;
                         return at != model::k_space;
                       });
  }

  Expr number(int value) const { return expressions_.number(value); }
  Vector3 none3() const { return ir::zero3(graph_); }

  Expr partial(Expr function, FullIndex i) { return partials_(function, i); }

  SwitchRows switch_rows() {
    SwitchRows rows;
    for (const model::Contact& contact : model_.contacts) rows.contacts.push_back(rows_.of_contact(contact));
    for (const model::DryFriction& friction : model_.frictions) {
      rows.frictions.push_back(rows_.of_slips(friction.law));
      rows.limits.push_back(limits_per_reaction(friction));
    }
    return rows;
  }

  std::vector<Expr> limits_per_reaction(const model::DryFriction& friction) {
    const Expr limit = over_reactions(friction.law.limit);
    std::vector<Expr> limits;
    for (const model::Contact& contact : model_.contacts) {
      const auto known = model_.symbols.find(contact.name.text + ".reaction");
      limits.push_back(known == model_.symbols.end() ? number(0)
                                                     : ir::partial(limit, symbols_.reactions[known->second.index]));
    }
    return limits;
  }

  Expr over_reactions(const model::Ast& limit) {
    expressions_.show_reactions(true);
    const Expr result = expressions_(limit);
    expressions_.show_reactions(false);
    return result;
  }

  void apply(const model::UniformField& law, Kinematics& result) {
    const Vector3 field = expressions_(law.field);
    result.field = result.field + field;
  }

  // Q_A = -∂(dV/dt)/∂ẏ^A, which is -∂V/∂y^A for a coordinate and the right moment for an angular velocity.
  void apply(const model::Potential& law, Kinematics& result) {
    const Expr energy = expressions_(law.energy);
    const Expr power = expressions_.rate(energy);
    potential_ += energy;
    for (const FullIndex i : result.other_force.indices()) result.other_force[i] -= partial(power, i);
  }

  void apply(const model::GeneralizedForce& law, Kinematics& result) {
    for (const auto& [name, value] : law.components) act_along(velocity_of(name.text), expressions_(value), result);
  }

  void apply(const model::PointForce& law, Kinematics& result) {
    const Vector3 point = expressions_.frames().point(law.frame, expressions_(law.at));
    const Vector3 force = resolved(law.axes, law.components);
    act({carriers_.pushed(law.frame), point, force, none3()}, result);
    act({carriers_.pushed(law.from), point, -force, none3()}, result);
  }

  void apply(const model::Torque& law, Kinematics& result) {
    const Vector3 moment = resolved(law.axes, law.components);
    for (const auto& [frame, sense] : {std::pair{law.frame, 1}, std::pair{law.from, -1}}) {
      act({frame, expressions_.frames().origin(frame), none3(), number(sense) * moment}, result);
    }
  }

  // k s + c ds/dt along the line, where s = d - L is the stretch, or k d + c v for a spring without length.
  void apply(const model::Spring& law, Kinematics& result) {
    // A damper across the line knows how the line turns in space.
    const bool is_along_line = law.length || !law.damping;
    const std::size_t base = is_along_line ? expressions_.carrier_of({law.first, law.second}) : model::k_space;
    Frames& seen = expressions_.frames_from(base);
    const Vector3 gap = seen.origin(law.second) - seen.origin(law.first);
    const Vector3 opening = expressions_.rate(gap);
    const Expr k = expressions_(law.stiffness);
    const Expr c = law.damping ? expressions_(*law.damping) : number(0);
    Vector3 pull = k * gap + c * opening;
    Expr stretch_squared = dot(gap, gap);
    if (law.length) {
      const Expr distance = ir::pow(stretch_squared, support::Rational(1) / 2);
      const Expr length = expressions_(*law.length);
      const Expr stretch = distance - length;
      const Expr stretching = dot(gap, opening) * ir::pow(distance, -1) - expressions_.rate(length);
      pull = ((k * stretch + c * stretching) * ir::pow(distance, -1)) * gap;
      stretch_squared = ir::pow(stretch, 2);
    }
    potential_ += support::Rational(1) / 2 * k * stretch_squared;
    Frames& frames = expressions_.frames();
    if (base != model::k_space) pull = ir::multiply(frames.axes(base), pull);
    act({law.first, frames.origin(law.first), pull, none3()}, result);
    act({law.second, frames.origin(law.second), -pull, none3()}, result);
  }

  void apply(const model::CoordinateSpring& law, Kinematics& result) {
    const Expr y = expressions_(law.coordinate.text);
    const Expr k = expressions_(law.stiffness);
    const Expr stretch = law.rest ? y - expressions_(*law.rest) : y;
    const Expr c = law.damping ? expressions_(*law.damping) : number(0);
    potential_ += support::Rational(1) / 2 * k * ir::pow(stretch, 2);
    act_along(expressions_.rate(y), -(k * stretch + c * expressions_.rate(stretch)), result);
  }

  // λ_i = -limit φ_i/|φ|, where friction would be the multiplier of φ_i if it stuck. Along one direction φ/|φ| is the sense that a regime
  // knows, so that nothing jumps in it.
  void apply(const model::Friction& law, Kinematics& result) {
    std::vector<ConstraintRow> rows = rows_.of_slips(law);
    rows.erase(std::remove_if(rows.begin(), rows.end(), [](const auto& row) { return row.phi.is_zero(); }), rows.end());
    Expr square = law.smooth ? ir::pow(expressions_(*law.smooth), 2) : number(0);
    for (const ConstraintRow& row : rows) square += ir::pow(row.phi, 2);
    const Expr limit = expressions_(law.limit);
    for (const ConstraintRow& row : rows) {
      const bool has_sense = law.sense != 0 && rows.size() == 1;
      const Expr part = has_sense ? number(law.sense) : row.phi * ir::pow(square, support::Rational(-1) / 2);
      act_as(row, -limit * part, result);
    }
  }

  /// As the reaction of a constraint with this multiplier does.
  void act_as(const ConstraintRow& row, Expr multiplier, Kinematics& result) {
    for (const ConstraintAction& action : row.actions)
      act({action.frame, action.point, multiplier * action.direction, none3()}, result);
    for (const FullIndex i : row.beside.indices()) result.other_force[i] += multiplier * row.beside[i];
  }

  Vector3 resolved(std::size_t axes, const std::array<model::Ast, 3>& components) {
    return ir::multiply(expressions_.frames().axes(axes), expressions_(components));
  }

  void act(const Push& push, Kinematics& result) {
    if (push.frame == model::k_space) return;
    const std::optional<BodyIndex> body = carriers_.body_of(carriers_.pushed(push.frame));
    result.applied.push_back(applied(push, body));
    if (body) {
      BodyLoad& load = loads_[*body];
      load.force = load.force + push.force;
      load.moment = load.moment + effects_.moment_about(*body, push);
    }
    const auto [felt, unfelt] = effects_(push, body);
    for (const FullIndex i : felt.indices()) {
      result.body_force[i] += felt[i];
      result.other_force[i] += unfelt[i];
      result.carried_force[i] += unfelt[i];
    }
  }

  AppliedForce applied(const Push& push, std::optional<BodyIndex> body) {
    AppliedForce result{push.frame, push.point, push.force, push.moment, push.force, push.moment};
    if (body) {
      result.unfelt_force = none3();
      result.unfelt_moment = motions_.is_rigid(*body) ? none3() : effects_.moment_about(*body, push);
    }
    return result;
  }

  support::Indexed<FreeIndex, Expr> speeds_at_rest() const {
    support::Indexed<FreeIndex, Expr> result;
    std::size_t own = 0;
    for (const Speed& speed : symbols_.speeds)
      result.push_back(speed.replaces_rate ? expressions_.speeds_at_rest()[own++] : number(0));
    return result;
  }

  /// The rate of a coordinate, an angular velocity or a speed: what times the generalized force is power.
  Expr velocity_of(const std::string& name) {
    const bool is_coordinate = model_.resolve(name).kind == model::SymbolKind::coordinate;
    return is_coordinate ? expressions_.rate(expressions_(name)) : expressions_(name);
  }

  /// Q_A = Q ∂v/∂ẏ^A
  void act_along(Expr velocity, Expr force, Kinematics& result) {
    for (const FullIndex i : result.other_force.indices()) result.other_force[i] += force * partial(velocity, i);
  }

  bool has_mass() const {
    return std::any_of(model_.bodies.begin(), model_.bodies.end(),
                       [&](const model::Body& body) { return !expressions_(body.mass).is_zero(); });
  }

  const model::Model& model_;
  ir::Graph& graph_;
  Expressions& expressions_;
  const Symbols& symbols_;
  Partials partials_;
  BodyMotions motions_;
  Carriers carriers_;
  PlaceEffects effects_;
  ConstraintRows rows_;
  Indexed<BodyIndex, BodyLoad> loads_;
  Expr potential_ = number(0);  ///< without fields
};

}  // namespace

bool Kinematics::has_positions() const {
  return std::any_of(constraints.begin(), constraints.end(), [](const auto& row) { return row.f.has_value(); });
}

Kinematics build_kinematics(const model::Model& model, ir::Graph& graph, Expressions& expressions,
                            const Symbols& symbols) {
  const auto builder = std::make_shared<Builder>(model, graph, expressions, symbols);
  Kinematics result = builder->run();
  const auto hold = std::make_shared<Holder>(model, expressions, symbols);
  const Vector3 field = result.field;
  const auto held = [hold](auto value) {
    (*hold)(value);
    return value;
  };
  result.bodies = support::Lazy<Indexed<BodyIndex, BodyMotion>>([=] { return held(builder->bodies(field)); });
  result.joints = support::Lazy<std::vector<Cut>>([=] { return held(builder->joints()); });
  result.held_frames = support::Lazy<std::vector<HeldFrame>>([=] { return held(builder->held_frames()); });
  result.field_force = support::Lazy<Indexed<FullIndex, Expr>>([=] { return held(builder->field_force(field)); });
  result.other_potential = support::Lazy<Expr>([=] { return held(builder->other_potential()); });
  result.potential = support::Lazy<Expr>([=] { return held(builder->potential(field)); });
  hold_coordinates(*hold, result);
  return result;
}

}  // namespace gaussgen::kinematics
