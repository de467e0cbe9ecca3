#include "kinematics/kinematics.hpp"

#include <algorithm>
#include <memory>

#include "ir/contract.hpp"
#include "ir/reverse.hpp"
#include "ir/substitute.hpp"
#include "ir/traverse.hpp"
#include "kinematics/body_motions.hpp"
#include "kinematics/held_frames.hpp"
#include "kinematics/hold.hpp"
#include "kinematics/place_symbols.hpp"
#include "kinematics/slip.hpp"
#include "model/rate.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Vector3;
using model::Axes;
using support::Indexed;

namespace {

/// Up to this number of rates derivatives by each of them are short.
constexpr std::size_t k_few_rates = 6;

class Builder {
 public:
  Builder(const model::Model& model, ir::Graph& graph, Expressions& expressions, const Symbols& symbols)
      : model_(model),
        graph_(graph),
        expressions_(expressions),
        symbols_(symbols),
        partials_(graph, symbols),
        motions_(model, expressions, partials_),
        loads_(model.bodies.size(), BodyLoad{ir::zero3(graph), ir::zero3(graph)}) {}

  using Components = support::Indexed<FullIndex, Expr>;

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
    for (const model::Constraint& constraint : model_.constraints) {
      result.constraints.push_back(constraint_row(constraint));
      ConstraintRow& row = result.constraints[ConstraintIndex{result.constraints.size() - 1}];
      find_carried(row);
      find_wandering(row);
    }
    for (const model::Constraint& constraint : model_.idle_slips) {
      result.idle_slips.push_back(empty_row(constraint));
      state(std::get<model::SlipLaw>(constraint.law), result.idle_slips.back());
    }
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

  Expr partial(Expr function, FullIndex i) { return partials_(function, i); }

  SwitchRows switch_rows() {
    SwitchRows rows;
    for (const model::Contact& contact : model_.contacts) {
      model::Constraint row;
      row.law = model::PositionLaw{contact.gap};
      rows.contacts.push_back(constraint_row(row));
    }
    for (const model::DryFriction& friction : model_.frictions) {
      rows.frictions.push_back(slip_rows(friction.law));
      rows.limits.push_back(limits_per_reaction(friction));
    }
    return rows;
  }

  /// What would be constraints if it stuck.
  std::vector<ConstraintRow> slip_rows(const model::Friction& law) {
    std::vector<ConstraintRow> rows;
    for (const auto& slip : law.slips) {
      model::Constraint row;
      std::visit([&](const auto& of_slip) { row.law = of_slip; }, slip);
      rows.push_back(constraint_row(row));
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

  ConstraintRow empty_row(const model::Constraint& constraint) const {
    return {constraint.name.text,
            constraint.multiplier_unit,
            {},
            number(0),
            {},
            number(0),
            {},
            true,
            {},
            {},
            {},
            number(0)};
  }

  ConstraintRow constraint_row(const model::Constraint& constraint) {
    ConstraintRow row = empty_row(constraint);
    std::visit([&](const auto& law) { state(law, row); }, constraint.law);
    row.beta = gradient(row);
    for (const FullIndex i : row.beta.indices()) {
      if (row.beta[i].is_zero()) continue;
      for (const FullIndex j : row.beta.indices()) row.is_linear = row.is_linear && partial(row.beta[i], j).is_zero();
    }
    if (row.actions.empty()) row.beside = row.beta;
    row.beta_drift = expressions_.rate(row.phi);
    if (constraint.point) row.point = expressions_(*constraint.point);
    return row;
  }

  // Of many rates, from φ back along the links to each of them: forwards, every rate goes the whole way to φ by itself.
  Components gradient(const ConstraintRow& row) {
    Components beta;
    if (symbols_.full_count() <= k_few_rates) {
      for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) beta.push_back(partial(row.phi, i));
      return beta;
    }
    std::vector<ir::SymbolId> rates;
    for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) rates.push_back(symbols_.rate(i));
    return Components(ir::Reverse(graph_, rates)({{row.phi, number(1)}}, "beta_" + row.name));
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
    ir::Substitution put_in(graph_), put_in_at_rest(graph_);
    for (const auto& [frame, symbols] : places.all()) {
      const Vector3 origin = expressions_.frames().origin(frame);
      for (std::size_t i = 0; i < 3; ++i) {
        for (ir::Substitution* const put : {&put_in, &put_in_at_rest}) put->replace(symbols[i].place, origin[i]);
        put_in.replace(symbols[i].rate, expressions_.rate(origin[i]));
        put_in_at_rest.replace(symbols[i].rate, number(0));
      }
    }
    row.phi_beside = put_in_at_rest(watched);
    for (const auto& [frame, symbols] : places.all()) {
      Vector3 direction = ir::zero3(graph_);
      for (std::size_t i = 0; i < 3; ++i) direction[i] = put_in(ir::partial(watched, symbols[i].rate));
      row.actions.push_back({frame, expressions_.frames().origin(frame), direction,
                             LocalDirection{frame, model::k_space, direction, pushed(frame)}});
    }
    for (const FullIndex i : support::indices<FullIndex>(symbols_.full_count())) {
      const Expr along = partial(watched, i);
      row.beside.push_back(along.is_zero() ? along : put_in(along));
    }
  }

  void state(const model::SlipLaw& law, ConstraintRow& row) {
    const ContactLine line = contact_line(expressions_, law);
    row.phi = slip(expressions_, law, line);
    row.actions.push_back({law.frame, line.point, line.direction});
    row.actions.push_back({law.surface, line.point, -line.direction});
    if (const auto* const place = std::get_if<std::size_t>(&law.at)) {
      const Vector3 components = expressions_(law.direction);
      row.actions[0].local = {*place, law.axes, components, law.frame};
      row.actions[1].local = {*place, law.axes, -components, law.surface};
    }
    row.beside = Components(symbols_.full_count(), number(0));
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
    push(law.first, frames.origin(law.first), pull, ir::zero3(graph_), result);
    push(law.second, frames.origin(law.second), -pull, ir::zero3(graph_), result);
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
    std::vector<ConstraintRow> rows = slip_rows(law);
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
      push(action.frame, action.point, multiplier * action.direction, ir::zero3(graph_), result);
    for (const FullIndex i : row.beside.indices()) result.other_force[i] += multiplier * row.beside[i];
  }

  Vector3 resolved(std::size_t axes, const std::array<model::Ast, 3>& components) {
    return ir::multiply(expressions_.frames().axes(axes), expressions_(components));
  }

  /// Q_A = F·∂v_P/∂ẏ^A + M·∂ω/∂ẏ^A (theory section 6)
  Components generalized(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment) {
    Components Q(symbols_.full_count(), number(0));
    const Vector3 velocity = velocity_at(expressions_, frame, point);
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
                std::optional<BodyIndex> body) {
    const Components all = generalized(frame, point, force, moment);
    const Components none(symbols_.full_count(), number(0));
    if (!body) return {none, all};
    if (is_felt_whole(frame, point, force, moment, *body)) return {all, none};
    const bool at_particle = has_unfelt_moment(point, force, moment, *body);
    Effect result{at_particle ? at_centre(*body, force) : generalized(pushed(frame), point, force, moment), all};
    for (const FullIndex i : all.indices()) result.unfelt[i] -= result.felt[i];
    return result;
  }

  bool has_unfelt_moment(const Vector3& point, const Vector3& force, const Vector3& moment, BodyIndex body) {
    return !motions_.is_rigid(body) && !is_zero(moment_about(body, point, force, moment));
  }

  bool is_felt_whole(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment,
                     BodyIndex body) {
    return pushed(frame) == frame && !has_unfelt_moment(point, force, moment, body);
  }

  Vector3 moment_about(BodyIndex body, const Vector3& point, const Vector3& force, const Vector3& moment) {
    return moment + cross(point - motions_.position(body), force);
  }

  Components at_centre(BodyIndex body, const Vector3& force) {
    Components Q(symbols_.full_count(), number(0));
    for (const FullIndex i : Q.indices()) Q[i] = dot(force, motions_[body].J[i]);
    return Q;
  }

  void push(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment, Kinematics& result) {
    if (frame == model::k_space) return;
    const std::optional<BodyIndex> body = body_of(pushed(frame));
    result.applied.push_back(applied_at(frame, point, force, moment, body));
    if (body) {
      BodyLoad& load = loads_[*body];
      load.force = load.force + force;
      load.moment = load.moment + moment_about(*body, point, force, moment);
    }
    const auto [felt, unfelt] = effect(frame, point, force, moment, body);
    for (const FullIndex i : felt.indices()) {
      result.body_force[i] += felt[i];
      result.other_force[i] += unfelt[i];
      result.carried_force[i] += unfelt[i];
    }
  }

  AppliedForce applied_at(std::size_t frame, const Vector3& point, const Vector3& force, const Vector3& moment,
                          std::optional<BodyIndex> body) {
    const Vector3 nothing = ir::zero3(graph_);
    AppliedForce applied{frame, point, force, moment, force, moment};
    if (body) {
      applied.unfelt_force = nothing;
      applied.unfelt_moment = motions_.is_rigid(*body) ? nothing : moment_about(*body, point, force, moment);
    }
    return applied;
  }

  void find_carried(ConstraintRow& row) {
    row.carried = Components(symbols_.full_count(), number(0));
    for (const ConstraintAction& action : row.actions) {
      if (action.frame == model::k_space) continue;
      const std::optional<BodyIndex> body = body_of(pushed(action.frame));
      const Vector3 none = ir::zero3(graph_);
      // Its effect along every rate is not asked for then.
      if (body && is_felt_whole(action.frame, action.point, action.direction, none, *body)) continue;
      const Components unfelt = effect(action.frame, action.point, action.direction, none, body).unfelt;
      for (const FullIndex i : unfelt.indices()) row.carried[i] += unfelt[i];
    }
  }

  // A held coordinate takes this itself, as part of what it carries; along one that moves no body, no body feels it.
  void find_wandering(ConstraintRow& row) {
    for (ConstraintAction& action : row.actions) {
      const Expr power = dot(action.direction, velocity_over(pushed(action.frame), action.frame));
      action.along_way = power;
      for (const FreeIndex a : symbols_.speeds.indices()) {
        const FullIndex i = symbols_.full(a);
        const Expr along = partial(power, i);
        if (!along.is_zero() && moves_body(i)) row.beside[i] += along;
      }
    }
  }

  bool moves_body(FullIndex i) {
    const auto bodies = loads_.indices();
    return std::any_of(bodies.begin(), bodies.end(), [&](BodyIndex b) {
      const BodyMotion& body = motions_[b];
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
  std::optional<BodyIndex> body_of(std::size_t frame) const {
    for (std::size_t at = frame; at != model::k_space; at = model_.frames[at].parent) {
      for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
        if (model_.bodies[i].frame == at) return BodyIndex{i};
      }
      if (!is_fixed_to_parent(at)) return only_body_on(at);
    }
    return std::nullopt;
  }

  std::optional<BodyIndex> only_body_on(std::size_t root) const {
    std::optional<BodyIndex> only;
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      if (root_of(model_.bodies[i].frame) != root) continue;
      if (only) return std::nullopt;
      only = BodyIndex{i};
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
