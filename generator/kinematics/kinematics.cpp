#include "kinematics/kinematics.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/substitute.hpp"
#include "ir/traverse.hpp"
#include "kinematics/hold.hpp"
#include "kinematics/place_symbols.hpp"
#include "model/rate.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;
using model::Axes;
using support::Indexed;

namespace {

bool is_zero(const Vector3& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

class Builder {
 public:
  Builder(const model::Model& model, ir::Graph& graph, Expressions& expressions, const Symbols& symbols)
      : model_(model),
        graph_(graph),
        expressions_(expressions),
        symbols_(symbols),
        rates_in_(graph, rates_of(symbols)) {
    for (std::size_t i = 0; i < symbols.full_count(); ++i) {
      along_rate_.emplace_back(graph);
      along_rate_.back().seed(symbols.rate(FullIndex{i}), number(1));
      along_rate_.back().skip_others(rates_in_, i);
    }
  }

  Kinematics run() {
    Kinematics result{symbols_,
                      {},
                      {},
                      {},
                      {},
                      expressions_.configuration_rates(),
                      speeds_at_rest(),
                      number(0),
                      {},
                      {symbols_.full_count(), number(0)},
                      {symbols_.full_count(), number(0)},
                      {symbols_.full_count(), number(0)},
                      {},
                      {},
                      {},
                      {}};
    for (const model::Body& body : model_.bodies) result.bodies.push_back(body_motion(body));
    for (const model::Constraint& constraint : model_.constraints) {
      result.constraints.push_back(constraint_row(constraint));
      ConstraintRow& row = result.constraints[ConstraintIndex{result.constraints.size() - 1}];
      find_carried(row, result);
      find_wandering(row, result);
    }
    for (const model::Frame& frame : model_.frames) result.frame_names.push_back(frame.name.text);
    for (const model::Joint& joint : model_.joints) {
      result.joints.push_back({joint.name.text, joint.frame, expressions_.frames().origin(joint.frame)});
    }
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
    for (const model::NamedQuantity& quantity : model_.quantities) {
      result.quantities.emplace_back();
      for (const model::Ast& value : quantity.values) result.quantities.back().push_back(expressions_(value));
    }
    return result;
  }

 private:
  using Components = support::Indexed<FullIndex, Expr>;

  static std::vector<ir::SymbolId> rates_of(const Symbols& symbols) {
    std::vector<ir::SymbolId> rates;
    for (std::size_t i = 0; i < symbols.full_count(); ++i) rates.push_back(symbols.rate(FullIndex{i}));
    return rates;
  }

  /// What forces add to.
  static std::vector<ir::NodeId> felt(const Kinematics& result) {
    std::vector<ir::NodeId> sums;
    for (const Expr Q : result.body_force) sums.push_back(Q.id());
    for (const Expr Q : result.other_force) sums.push_back(Q.id());
    for (const BodyMotion& body : result.bodies) {
      for (const Expr component : body.force) sums.push_back(component.id());
      if (!body.is_rigid) continue;
      for (const Expr component : body.moment) sums.push_back(component.id());
    }
    return sums;
  }

  template <class Law>
  bool is_inner(const Law&) const {
    return false;
  }

  /// The opposite acts at the same place.
  bool is_inner(const model::PointForce& law) const { return are_fixed_together(law.frame, law.from); }
  bool is_inner(const model::Torque& law) const { return are_fixed_together(law.frame, law.from); }

  /// Along the line through its ends. Without a length the damper is across it when the part turns, and brakes this.
  bool is_inner(const model::Spring& law) const {
    return (law.length || !law.damping) && are_fixed_together(law.first, law.second);
  }

  bool are_fixed_together(std::size_t a, std::size_t b) const { return root_of(a) == root_of(b); }

  /// Whether a joint carries something on which one of the forces from `begin` on acts.
  bool reaches_joint(const Kinematics& result, std::size_t begin) const {
    return std::any_of(result.applied.begin() + static_cast<std::ptrdiff_t>(begin), result.applied.end(),
                       [&](const AppliedForce& applied) {
                         if (is_zero(applied.force) && is_zero(applied.moment)) return false;
                         std::size_t at = applied.frame;
                         while (at != model::k_space && !is_carried_by_joint(at)) at = model_.frames[at].parent;
                         return at != model::k_space;
                       });
  }

  Expr number(int value) const { return expressions_.number(value); }

  Expr partial(Expr function, FullIndex i) { return along_rate_[i.value](function); }

  /// ∂v/∂ẏ^A for all A
  Indexed<FullIndex, Vector3> jacobian(const Vector3& v) {
    Indexed<FullIndex, Vector3> columns;
    for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) {
      columns.push_back({partial(v[0], i), partial(v[1], i), partial(v[2], i)});
    }
    return columns;
  }

  BodyMotion body_motion(const model::Body& body) {
    const Vector3 position = expressions_.frames().point(body.frame, expressions_(body.centre));
    const Vector3 velocity = expressions_.rate(position);
    const Vector3 zero = ir::zero3(graph_);
    BodyMotion motion{body.name.text,
                      expressions_(body.mass),
                      position,
                      velocity,
                      jacobian(velocity),
                      expressions_.rate(velocity),
                      zero,
                      zero,
                      false,
                      false,
                      {zero, zero, zero},
                      {{zero, zero, zero}, zero, Axes::space},
                      {},
                      zero};
    if (body.inertia) add_rotation(body, motion);
    return motion;
  }

  // An isotropic tensor has the same components in every frame, so ω may stay in the frame where it is simplest; any
  // other tensor is constant in body axes only.
  void add_rotation(const model::Body& body, BodyMotion& motion) {
    motion.is_rigid = true;
    motion.is_isotropic = body.inertia->shape == model::Inertia::Shape::isotropic;
    motion.inertia = inertia_matrix(*body.inertia);
    motion.rotation =
        expressions_.frames().rotation(body.frame, motion.is_isotropic ? preferred_axes(body.frame) : Axes::body);
    motion.W = jacobian(motion.rotation.omega);
    motion.eta = expressions_.rate(motion.rotation.omega);
  }

  Axes preferred_axes(std::size_t frame) const {
    const auto* quaternion = std::get_if<model::QuaternionOrientation>(&model_.frames[frame].attitude);
    if (quaternion == nullptr) return Axes::space;
    const Axes own = model_.orientations[quaternion->index].axes;
    return own == Axes::space && model_.frames[frame].parent != model::k_space ? Axes::body : own;
  }

  ir::Matrix3 inertia_matrix(const model::Inertia& inertia) {
    const auto entry = [&](std::size_t i) { return expressions_(inertia.entries[i]); };
    const Expr zero = number(0);
    switch (inertia.shape) {
      case model::Inertia::Shape::isotropic:
        return {Vector3{entry(0), zero, zero}, Vector3{zero, entry(0), zero}, Vector3{zero, zero, entry(0)}};
      case model::Inertia::Shape::diagonal:
        return {Vector3{entry(0), zero, zero}, Vector3{zero, entry(1), zero}, Vector3{zero, zero, entry(2)}};
      default:
        return {Vector3{entry(0), entry(3), entry(4)}, Vector3{entry(3), entry(1), entry(5)},
                Vector3{entry(4), entry(5), entry(2)}};
    }
  }

  ConstraintRow constraint_row(const model::Constraint& constraint) {
    ConstraintRow row{
        constraint.name.text, constraint.multiplier_unit, {}, number(0), {}, number(0), {}, true, {}, {}, {}};
    std::visit([&](const auto& law) { state(law, row); }, constraint.law);
    for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) {
      row.beta.push_back(partial(row.phi, i));
    }
    for (const FullIndex i : row.beta.indices()) {
      if (row.beta[i].is_zero()) continue;
      for (const FullIndex j : row.beta.indices()) row.is_linear = row.is_linear && partial(row.beta[i], j).is_zero();
    }
    if (row.actions.empty()) row.beside = row.beta;
    row.beta_drift = expressions_.rate(row.phi);
    if (constraint.point) row.point = expressions_(*constraint.point);
    return row;
  }

  void state(const model::VelocityLaw& law, ConstraintRow& row) {
    row.phi = expressions_(law.phi);
    find_actions([&] { return expressions_(law.phi); }, row);
  }

  void state(const model::PositionLaw& law, ConstraintRow& row) {
    row.f = expressions_(law.f);
    const model::Ast phi = model::rate_of(law);
    row.phi = expressions_(phi);
    find_actions([&] { return expressions_(phi); }, row);
  }

  // φ once more with the places in it as symbols: its derivatives by their rates are the forces on them per multiplier.
  template <class Phi>
  void find_actions(Phi phi, ConstraintRow& row) {
    PlaceSymbols places(graph_);
    expressions_.watch(&places);
    const Expr watched = phi();
    expressions_.watch(nullptr);
    if (places.all().empty()) return;
    ir::Substitution put_in(graph_);
    for (const auto& [frame, symbols] : places.all()) {
      const Vector3 origin = expressions_.frames().origin(frame);
      for (std::size_t i = 0; i < 3; ++i) {
        put_in.replace(symbols[i].place, origin[i]);
        put_in.replace(symbols[i].rate, expressions_.rate(origin[i]));
      }
    }
    for (const auto& [frame, symbols] : places.all()) {
      Vector3 direction = ir::zero3(graph_);
      for (std::size_t i = 0; i < 3; ++i) direction[i] = put_in(ir::partial(watched, symbols[i].rate));
      row.actions.push_back({frame, expressions_.frames().origin(frame), direction});
    }
    for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) {
      row.beside.push_back(put_in(partial(watched, i)));
    }
  }

  void state(const model::SlipLaw& law, ConstraintRow& row) {
    Frames& frames = expressions_.frames();
    const auto* place = std::get_if<std::size_t>(&law.at);
    const Vector3 point =
        place != nullptr ? frames.origin(*place) : expressions_(std::get<std::array<model::Ast, 3>>(law.at));
    const Vector3 direction = ir::multiply(frames.axes(law.axes), expressions_(law.direction));
    row.phi = dot(direction, velocity_at(law.frame, point) - velocity_at(law.surface, point));
    row.actions.push_back({law.frame, point, direction});
    row.actions.push_back({law.surface, point, -direction});
    row.beside = Components(symbols_.full_count(), number(0));
  }

  /// Of the point of a frame that is at `place` now: v + ω × r.
  Vector3 velocity_at(std::size_t frame, const Vector3& place) {
    if (frame == model::k_space) return ir::zero3(graph_);
    Frames& frames = expressions_.frames();
    const Vector3 origin = frames.origin(frame);
    return expressions_.rate(origin) + cross(frames.omega(frame, Axes::space), place - origin);
  }

  // Q_A = m field·J_A and V = -m field·r (theory section 6)
  void apply(const model::UniformField& law, Kinematics& result) {
    const Vector3 field = expressions_(law.field);
    for (BodyMotion& body : result.bodies) {
      body.force = body.force + body.mass * field;
      result.potential -= body.mass * dot(field, body.position);
      for (const FullIndex i : body.J.indices()) result.body_force[i] += body.mass * dot(field, body.J[i]);
    }
  }

  // Q_A = -∂(dV/dt)/∂ẏ^A, which is -∂V/∂y^A for a coordinate and the right moment for an angular velocity.
  void apply(const model::Potential& law, Kinematics& result) {
    const Expr energy = expressions_(law.energy);
    const Expr power = expressions_.rate(energy);
    result.potential += energy;
    for (const FullIndex i : result.other_force.indices()) result.other_force[i] -= partial(power, i);
  }

  void apply(const model::GeneralizedForce& law, Kinematics& result) {
    for (const auto& [name, value] : law.components) act_along(velocity_of(name.text), expressions_(value), result);
  }

  void apply(const model::PointForce& law, Kinematics& result) {
    const Vector3 point = expressions_.frames().point(law.frame, expressions_(law.at));
    const Vector3 force = resolved(law.axes, law.components);
    push(pushed(law.frame), point, force, ir::zero3(graph_), result);
    push(pushed(law.from), point, -force, ir::zero3(graph_), result);
  }

  void apply(const model::Torque& law, Kinematics& result) {
    const Vector3 moment = resolved(law.axes, law.components);
    for (const auto& [frame, sense] : {std::pair{law.frame, 1}, std::pair{law.from, -1}}) {
      push(frame, expressions_.frames().origin(frame), ir::zero3(graph_), number(sense) * moment, result);
    }
  }

  /// Of points that are fixed, the motion is that of their frame, too.
  std::size_t pushed(std::size_t frame) const {
    const std::size_t carrier = model::pushed_by_force_on(model_, frame);
    for (std::size_t at = frame; at != carrier; at = model_.frames[at].parent) {
      if (!is_fixed(model_.frames[at])) return carrier;
    }
    return frame;
  }

  // k s + c ds/dt along the line, where s = d - L is the stretch, or k d + c v for a spring without length.
  void apply(const model::Spring& law, Kinematics& result) {
    Frames& frames = expressions_.frames();
    const Vector3 gap = frames.origin(law.second) - frames.origin(law.first);
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
    result.potential += support::Rational(1) / 2 * k * stretch_squared;
    push(law.first, frames.origin(law.first), pull, ir::zero3(graph_), result);
    push(law.second, frames.origin(law.second), -pull, ir::zero3(graph_), result);
  }

  void apply(const model::CoordinateSpring& law, Kinematics& result) {
    const Expr y = expressions_(law.coordinate.text);
    const Expr k = expressions_(law.stiffness);
    const Expr stretch = law.rest ? y - expressions_(*law.rest) : y;
    const Expr c = law.damping ? expressions_(*law.damping) : number(0);
    result.potential += support::Rational(1) / 2 * k * ir::pow(stretch, 2);
    act_along(expressions_.rate(y), -(k * stretch + c * expressions_.rate(stretch)), result);
  }

  Vector3 resolved(std::size_t axes, const std::array<model::Ast, 3>& components) {
    return ir::multiply(expressions_.frames().axes(axes), expressions_(components));
  }

  /// Q_A = F·∂v_P/∂ẏ^A + M·∂ω/∂ẏ^A (theory section 6)
  Components generalized(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment) {
    Components Q(symbols_.full_count(), number(0));
    const Vector3 velocity = velocity_at(frame, point);
    const Vector3 omega = expressions_.frames().omega(frame, Axes::space);
    for (const FullIndex i : Q.indices()) {
      for (std::size_t x = 0; x < 3; ++x) {
        Q[i] += force[x] * partial(velocity[x], i);
        Q[i] += moment[x] * partial(omega[x], i);
      }
    }
    return Q;
  }

  /// What acts at a place does this along the coordinates. At a place that wanders over a body the body feels it where the place is
  /// now; what it does along the way of the place no body feels, on a part without mass nothing of it, and a particle no moment.
  struct Effect {
    Components felt, unfelt;
  };

  Effect effect(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment,
                const BodyMotion* body) {
    const Components all = generalized(frame, point, force, moment);
    const Components none(symbols_.full_count(), number(0));
    if (body == nullptr) return {none, all};
    const std::size_t carrier = pushed(frame);
    const bool has_unfelt_moment = !body->is_rigid && !is_zero(moment_about(*body, point, force, moment));
    if (carrier == frame && !has_unfelt_moment) return {all, none};
    Effect result{has_unfelt_moment ? at_centre(*body, force) : generalized(carrier, point, force, moment), all};
    for (const FullIndex i : all.indices()) result.unfelt[i] -= result.felt[i];
    return result;
  }

  static Vector3 moment_about(const BodyMotion& body, const Vector3& point, const Vector3& force,
                              const Vector3& moment) {
    return moment + cross(point - body.position, force);
  }

  Components at_centre(const BodyMotion& body, const Vector3& force) const {
    Components Q(symbols_.full_count(), number(0));
    for (const FullIndex i : Q.indices()) Q[i] = dot(force, body.J[i]);
    return Q;
  }

  void push(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment, Kinematics& result) {
    if (frame == model::k_space) return;
    BodyMotion* body = body_of(pushed(frame), result);
    result.applied.push_back(applied_at(frame, point, force, moment, body));
    if (body != nullptr) {
      body->force = body->force + force;
      body->moment = body->moment + moment_about(*body, point, force, moment);
    }
    const auto [felt, unfelt] = effect(frame, point, force, moment, body);
    for (const FullIndex i : felt.indices()) {
      result.body_force[i] += felt[i];
      result.other_force[i] += unfelt[i];
      result.carried_force[i] += unfelt[i];
    }
  }

  AppliedForce applied_at(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment,
                          const BodyMotion* body) const {
    const Vector3 nothing = ir::zero3(graph_);
    AppliedForce applied{frame, point, force, moment, force, moment};
    if (body != nullptr) {
      applied.unfelt_force = nothing;
      applied.unfelt_moment = body->is_rigid ? nothing : moment_about(*body, point, force, moment);
    }
    return applied;
  }

  void find_carried(ConstraintRow& row, Kinematics& result) {
    row.carried = Components(symbols_.full_count(), number(0));
    for (const ConstraintAction& action : row.actions) {
      if (action.frame == model::k_space) continue;
      const BodyMotion* body = body_of(pushed(action.frame), result);
      const Components unfelt = effect(action.frame, action.point, action.direction, ir::zero3(graph_), body).unfelt;
      for (const FullIndex i : unfelt.indices()) row.carried[i] += unfelt[i];
    }
  }

  // A held coordinate takes this itself, as part of what it carries; along one that moves no body, no body feels it.
  void find_wandering(ConstraintRow& row, const Kinematics& result) {
    for (const ConstraintAction& action : row.actions) {
      const Expr power = dot(action.direction, velocity_over(pushed(action.frame), action.frame));
      for (const FreeIndex a : symbols_.speeds.indices()) {
        const FullIndex i = symbols_.full(a);
        if (moves_body(i, result)) row.beside[i] += partial(power, i);
      }
    }
  }

  static bool moves_body(FullIndex i, const Kinematics& result) {
    return std::any_of(result.bodies.begin(), result.bodies.end(), [&](const BodyMotion& body) {
      return !is_zero(body.J[i]) || (body.is_rigid && !is_zero(body.W[i]));
    });
  }

  /// Of a place against what is there of its carrier, in space.
  Vector3 velocity_over(std::size_t carrier, std::size_t place) {
    Vector3 velocity = ir::zero3(graph_);
    for (std::size_t at = place; at != carrier; at = model_.frames[at].parent) {
      const Vector3 local = expressions_.rate(expressions_(model_.frames[at].position));
      velocity = velocity + ir::multiply(expressions_.frames().axes(model_.frames[at].parent), local);
    }
    return velocity;
  }

  /// The body that feels what acts on a frame: on it, or on one to which it is fixed, though not by a joint, whose reaction is
  /// asked for. Else the only one that is fixed to the same frame: of several, nobody said which.
  BodyMotion* body_of(std::size_t frame, Kinematics& result) const {
    for (std::size_t at = frame; at != model::k_space; at = model_.frames[at].parent) {
      for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
        if (model_.bodies[i].frame == at) return &result.bodies[BodyIndex{i}];
      }
      if (!is_fixed_to_parent(at)) return only_body_on(at, result);
    }
    return nullptr;
  }

  BodyMotion* only_body_on(std::size_t root, Kinematics& result) const {
    BodyMotion* only = nullptr;
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      if (root_of(model_.bodies[i].frame) != root) continue;
      if (only != nullptr) return nullptr;
      only = &result.bodies[BodyIndex{i}];
    }
    return only;
  }

  /// The first frame below space, or below a motion or a joint, that a frame is fixed to.
  std::size_t root_of(std::size_t frame) const {
    while (frame != model::k_space && is_fixed_to_parent(frame)) frame = model_.frames[frame].parent;
    return frame;
  }

  bool is_fixed_to_parent(std::size_t frame) const {
    return !is_carried_by_joint(frame) && is_fixed(model_.frames[frame]);
  }

  bool is_carried_by_joint(std::size_t frame) const {
    return std::any_of(model_.joints.begin(), model_.joints.end(),
                       [&](const model::Joint& joint) { return joint.frame == frame; });
  }

  bool is_fixed(const model::Frame& frame) const {
    if (std::holds_alternative<model::QuaternionOrientation>(frame.attitude)) return false;
    const auto is_constant = [&](const model::Ast& ast) {
      const Expr value = expressions_(ast);
      return ir::is_of_parameters(graph_, value.id());
    };
    if (!std::all_of(frame.position.begin(), frame.position.end(), is_constant)) return false;
    const auto* turns = std::get_if<model::Turns>(&frame.attitude);
    return turns == nullptr ||
           std::all_of(turns->begin(), turns->end(), [&](const model::Turn& turn) { return is_constant(turn.angle); });
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

  const model::Model& model_;
  ir::Graph& graph_;
  Expressions& expressions_;
  const Symbols& symbols_;
  ir::SymbolSets rates_in_;  ///< of the nodes that are differentiated
  std::vector<ir::Directional> along_rate_;
};

}  // namespace

Vector3 BodyMotion::inertia_times(const Vector3& a) const {
  return is_isotropic ? inertia[0][0] * a : ir::multiply(inertia, a);
}

Kinematics build_kinematics(const model::Model& model, ir::Graph& graph, Expressions& expressions,
                            const Symbols& symbols) {
  Kinematics result = Builder(model, graph, expressions, symbols).run();
  hold_coordinates(model, expressions, graph, result);
  return result;
}

}  // namespace gaussgen::kinematics
