#include "strategy/tree_tangent.hpp"

#include <algorithm>
#include <set>

#include "ir/contract.hpp"
#include "ir/node_table.hpp"
#include "ir/traverse.hpp"
#include "strategy/axes.hpp"
#include "strategy/forces_from_rest.hpp"
#include "strategy/tree.hpp"
#include "strategy/tree_motion.hpp"
#include "support/assert.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::Freedom;
using kinematics::k_ground;
using kinematics::Link;

namespace {

/// Force and moment that a link takes with all that it carries, at its origin and in its axes.
struct LinkWrench {
  Vector3 force;
  Vector3 moment;
};

/// Which nodes have a symbol of some kind in them.
class Reach {
 public:
  Reach(const ir::Graph& graph, bool is_opaque) : graph_(graph), is_opaque_(is_opaque) {}

  bool operator()(ir::NodeId root) {
    const auto is_known = [this](ir::NodeId id) { return found_.contains(id); };
    for (const ir::NodeId id : ir::post_order(graph_, {root}, is_known)) {
      if (is_known(id)) continue;
      const ir::Node& node = graph_[id];
      bool found = node.kind == ir::Kind::symbol && is_opaque_ == is_opaque(node.symbol);
      for (const ir::NodeId child : node.children) found = found || *found_.find(child);
      found_[id] = found;
    }
    return *found_.find(root);
  }

 private:
  bool is_opaque(ir::SymbolId id) const { return graph_.symbol(id).symbol_class == ir::SymbolClass::opaque; }

  const ir::Graph& graph_;
  bool is_opaque_;
  ir::NodeTable<bool> found_;
};

class Builder {
 public:
  Builder(const Dynamics& dynamics, const Solution& solution, Expr epsilon, Steps& steps)
      : kinematics_(*dynamics.kinematics),
        tree_(*solution.motion),
        links_(tree_.linkage.links),
        solution_(solution),
        graph_(epsilon.graph()),
        zero_(graph_, graph_.constant(0)),
        epsilon_(epsilon),
        steps_(steps),
        motion_(links_, tree_.fall, ""),
        result_{{}, {}, {}, ir::Substitution(graph_), {}},
        resting_(at_rest(tree_.linkage, zero_)),
        may_vary_(graph_, false),
        is_disturbed_(graph_, true) {}

  TreeTangent run() {
    motion_.find_velocities(steps_);
    find_ways();
    for (const Expr a : solution_.accelerations) speeds_.push_back(symbol_for(a));
    find_accelerations();
    find_wrenches();
    find_forces();
    solve();
    return std::move(result_);
  }

 private:
  bool is_shift(std::size_t i) const { return links_[i].kind == Link::Kind::shift; }

  Expr symbol_for(Expr value) {
    const ir::SymbolId symbol = graph_.declare(ir::SymbolClass::opaque, "solved_" + std::to_string(count_++));
    result_.solved.replace(symbol, value);
    return {graph_, graph_.use(symbol)};
  }

  Vector3 symbols_for(const Vector3& v) { return {symbol_for(v[0]), symbol_for(v[1]), symbol_for(v[2])}; }

  /// d for a term.
  Expr disturbance_for(Expr term, std::size_t link) {
    if (!may_vary_(term.id())) return zero_;
    disturbed_.push_back(link);
    const ir::SymbolId symbol =
        graph_.declare(ir::SymbolClass::opaque, "disturbance_" + std::to_string(result_.disturbances.size()));
    result_.disturbances.push_back(symbol);
    result_.terms.push_back(term);
    return {graph_, graph_.use(symbol)};
  }

  Vector3 disturbances_for(const Vector3& v, std::size_t link) {
    return {disturbance_for(v[0], link), disturbance_for(v[1], link), disturbance_for(v[2], link)};
  }

  LinkAcceleration outward(std::size_t i, const LinkAcceleration& before, const Vector& speeds) {
    const Link& link = links_[i];
    LinkAcceleration now{motion_.turned(i, before.linear), motion_.turned(i, before.angular)};
    Vector3& moved = is_shift(i) ? now.linear : now.angular;
    if (is_shift(i)) moved = moved + cross(before.angular, link.offset);
    moved = moved + motion_.drift(i, steps_);
    for (const Freedom& freedom : link.freedoms) moved = moved + speeds[freedom.speed.value] * freedom.column;
    return now;
  }

  /// Links behind a floating base up to its anchor: Z has the acceleration of the anchor, from which that of the base follows, and forces
  /// along the speeds of the base act there.
  void find_ways() {
    ways_.assign(links_.size(), nullptr);
    for (const FloatingBase& floating : tree_.bases) {
      for (std::size_t at = floating.anchor; at != floating.base; at = links_[at].parent) ways_[at] = &floating;
    }
  }

  /// Accelerations along the way, back from that of the anchor.
  void find_back(const FloatingBase& floating, std::vector<LinkAcceleration>& values) {
    Vector3 v = tree_.accelerations[floating.anchor].linear;
    for (std::size_t at = floating.anchor; at != floating.base; at = links_[at].parent) {
      const std::size_t parent = links_[at].parent;
      for (std::size_t k = 0; k < 3; ++k) {
        if (floating.along[k]) values[at].linear[k] = v[k];
      }
      v = is_shift(at) ? v - cross(values[parent].angular, links_[at].offset) - motion_.drift(at, steps_)
                       : motion_.turned_back(at, v);
    }
  }

  std::vector<LinkAcceleration> accelerations_of_links() {
    std::vector<LinkAcceleration> values;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const std::size_t parent = links_[i].parent;
      const LinkAcceleration ground{motion_.fall(), ir::zero3(graph_)};
      const LinkAcceleration value = outward(i, parent == k_ground ? ground : values[parent], solution_.accelerations);
      values.push_back(
          {steps_.name(value.linear, "a_" + links_[i].name), steps_.name(value.angular, "alpha_" + links_[i].name)});
      for (const FloatingBase& floating : tree_.bases) {
        if (floating.anchor == i) find_back(floating, values);
      }
    }
    return values;
  }

  void find_accelerations() {
    steps_.begin("accelerations of links against free fall, each in its axes");
    values_ = accelerations_of_links();
    disturbance_.linear.assign(links_.size(), ir::zero3(graph_));
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const std::size_t parent = links_[i].parent;
      const LinkAcceleration ground{motion_.fall(), ir::zero3(graph_)};
      const LinkAcceleration term = outward(i, parent == k_ground ? ground : accelerations_[parent], speeds_);
      accelerations_.push_back({symbols_for(values_[i].linear), symbols_for(values_[i].angular)});
      resting_.links[i].drift = disturbances_for(is_shift(i) ? term.linear : term.angular, i);
      if (is_shift(i)) continue;
      const bool is_found_back = ways_[i] != nullptr;
      disturbance_.linear[i] =
          disturbances_for(is_found_back ? motion_.turned_back(i, accelerations_[i].linear) : term.linear, i);
    }
  }

  // m a + α × f + ω × (ω × f) and f × a + I α + ω × I ω, with f = m times the mass centre (theory section 6).
  LinkWrench own(std::size_t i, const LinkAcceleration& of) const {
    const MassProperties& body = tree_.properties[i];
    const Vector3& omega = motion_.omega(i);
    return {body.mass * of.linear + cross(of.angular, body.first) + cross(omega, cross(omega, body.first)),
            cross(body.first, of.linear) + ir::multiply(body.inertia, of.angular) +
                cross(omega, ir::multiply(body.inertia, omega))};
  }

  LinkWrench at_parent(std::size_t i, LinkWrench wrench) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (ways_[i] != nullptr && ways_[i]->along[k]) wrench.force[k] = zero_;
    }
    if (!is_shift(i)) return {motion_.turned_back(i, wrench.force), motion_.turned_back(i, wrench.moment)};
    return {wrench.force, wrench.moment + cross(links_[i].offset, wrench.force)};
  }

  void find_wrenches() {
    steps_.begin("forces and moments that links take with all that they carry, each in its axes");
    const LinkWrench none{ir::zero3(graph_), ir::zero3(graph_)};
    std::vector<LinkWrench> values(links_.size(), none), terms(links_.size(), none);
    wrenches_ = values;
    const auto add = [](LinkWrench& to, const LinkWrench& more) {
      to.force = to.force + more.force;
      to.moment = to.moment + more.moment;
    };
    for (std::size_t i = links_.size(); i-- > 0;) {
      add(values[i], own(i, values_[i]));
      add(terms[i], own(i, accelerations_[i]));
      values[i] = {steps_.name(values[i].force, "force_" + links_[i].name),
                   steps_.name(values[i].moment, "moment_" + links_[i].name)};
      wrenches_[i] = {symbols_for(values[i].force), symbols_for(values[i].moment)};
      if (links_[i].parent == k_ground) continue;
      add(values[links_[i].parent], at_parent(i, values[i]));
      add(terms[links_[i].parent], at_parent(i, wrenches_[i]));
    }
    for (const FloatingBase& floating : tree_.bases) {
      if (floating.base != floating.anchor)
        terms[floating.anchor].force = terms[floating.anchor].force - at_anchor(floating);
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      disturbance_.force.push_back(disturbances_for(terms[i].force, i));
      disturbance_.moment.push_back(disturbances_for(terms[i].moment, i));
    }
  }

  Expr force_along(std::size_t speed) const {
    const auto A = kinematics_.symbols.full(kinematics::FreeIndex{speed});
    const ir::Rational unit = 1 / (tree_.mass * tree_.length * tree_.length);
    return unit * (kinematics_.body_force[A] + kinematics_.other_force[A]);
  }

  /// What acts along the speeds of a floating base, of fixed size, in the axes of its anchor.
  Vector3 at_anchor(const FloatingBase& floating) {
    Vector3 sum = ir::zero3(graph_);
    for (const Freedom& freedom : links_[floating.base].freedoms) {
      const Expr Q = force_along(freedom.speed.value);
      for (std::size_t k = 0; k < 3; ++k) {
        if (Q.is_zero() || !floating.along[k] || freedom.column[k].is_zero()) continue;
        const Vector3 direction = resolved(links_, floating.base, floating.anchor, ir::unit_vector(graph_, k));
        sum = sum + symbol_for(Q) / freedom.column[k] * direction;
      }
    }
    return sum;
  }

  void find_forces() {
    Vector terms;
    mover_.assign(kinematics_.symbols.speeds.size(), k_ground);
    for (std::size_t u = 0; u < mover_.size(); ++u) terms.push_back(force_along(u));
    for (std::size_t i = 0; i < links_.size(); ++i) {
      for (const Freedom& freedom : links_[i].freedoms) {
        const std::size_t u = freedom.speed.value;
        terms[u] -= dot(freedom.column, is_shift(i) ? wrenches_[i].force : wrenches_[i].moment);
        mover_[u] = mover_[u] == k_ground ? i : common_carrier(links_, mover_[u], i);
      }
    }
    for (std::size_t u = 0; u < terms.size(); ++u) forces_.push_back(disturbance_for(terms[u], mover_[u]));
  }

  void solve() {
    const kinematics::Kinematics unconstrained = without_constraints(kinematics_);
    const auto no_rate = [this](Expr) { return zero_; };
    const auto vanishes = [](Expr e) { return e.is_zero(); };
    const TreeProblem problem{resting_,
                              unconstrained.symbols,
                              ir::zero3(graph_),
                              forces_,
                              {unconstrained, {}, {}, no_rate, vanishes, {}, {}, {}, {}},
                              "",
                              &disturbance_};
    Steps factors;
    const std::optional<Solution> found = solve_tree(problem, {}, epsilon_, factors);
    GAUSS_ASSERT(found, "a tree of {} links was solved, and is not again", links_.size());
    result_.accelerations = found->accelerations;
    find_limbs(*found->motion);
  }

  void find_limbs(const TreeMotion& response) {
    const auto children = children_of(links_);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const std::size_t parent = links_[i].parent;
      if (parent == k_ground || children[parent].size() < 2) continue;
      Limb limb;
      const LinkAcceleration& before = response.accelerations[parent];
      for (const Vector3& v : {before.linear, before.angular}) {
        for (const Expr component : v) {
          const Expr varying = varying_factor(component);
          const bool is_new = std::find(limb.before.begin(), limb.before.end(), varying) == limb.before.end();
          if (is_new && is_disturbed_(varying.id())) limb.before.push_back(varying);
        }
      }
      for (std::size_t u = 0; u < mover_.size(); ++u) {
        if (mover_[u] != k_ground && is_carried(links_, mover_[u], i)) limb.speeds.push_back(u);
      }
      for (std::size_t d = 0; d < disturbed_.size(); ++d) {
        if (disturbed_[d] != k_ground && is_carried(links_, disturbed_[d], i)) limb.disturbances.push_back(d);
      }
      if (is_worth_while(limb, parent) && only_follows(limb)) result_.limbs.push_back(std::move(limb));
    }
  }

  /// The factor of a component that disturbances change: products have no names, and are multiplied out where they are used.
  Expr varying_factor(Expr component) {
    ir::NodeId id = component.id();
    while (graph_[id].kind == ir::Kind::product ||
           (graph_[id].kind == ir::Kind::sum && graph_[id].children.size() == 1)) {
      std::vector<ir::NodeId> varying;
      for (const ir::NodeId child : graph_[id].children) {
        if (is_disturbed_(child)) varying.push_back(child);
      }
      if (varying.size() != 1) break;
      id = varying[0];
    }
    return {graph_, id};
  }

  // Its response is a column of derivatives for each component, and saves something in each column that leaves it undisturbed: not in
  // those by its own coordinates and speeds, and by those that turn it.
  bool is_worth_while(const Limb& limb, std::size_t parent) const {
    std::size_t others = 0;
    for (const std::size_t link : mover_) {
      if (link == k_ground || !is_carried(links_, parent, link)) others += 2;
    }
    return !limb.speeds.empty() && others > 2 * limb.speeds.size() + 2 * limb.before.size();
  }

  /// Whether all that others do to it goes through the accelerations of the link before: values without a name are multiplied out.
  bool only_follows(const Limb& limb) const {
    ir::NodeTable<bool> ends;
    for (const Expr component : limb.before) ends[component.id()] = true;
    std::set<std::uint32_t> own;
    for (const std::size_t d : limb.disturbances) own.insert(result_.disturbances[d].index);
    std::vector<ir::NodeId> roots;
    for (const std::size_t u : limb.speeds) roots.push_back(result_.accelerations[u].id());
    const auto is_end = [&](ir::NodeId id) { return ends.contains(id); };
    const std::vector<ir::NodeId> below = ir::post_order(graph_, roots, is_end);
    return std::none_of(below.begin(), below.end(), [&](ir::NodeId id) {
      const ir::Node& node = graph_[id];
      if (is_end(id) || node.kind != ir::Kind::symbol) return false;
      const bool is_disturbance = graph_.symbol(node.symbol).symbol_class == ir::SymbolClass::opaque;
      return is_disturbance && own.count(node.symbol.index) == 0;
    });
  }

  const kinematics::Kinematics& kinematics_;
  const TreeMotion& tree_;
  const std::vector<Link>& links_;
  const Solution& solution_;
  ir::Graph& graph_;
  Expr zero_, epsilon_;
  Steps& steps_;
  LinkMotion motion_;
  TreeTangent result_;
  kinematics::Linkage resting_;
  Disturbance disturbance_;
  Vector speeds_, forces_;                                ///< symbols and disturbances along the speeds
  std::vector<LinkAcceleration> values_, accelerations_;  ///< of links, and the symbols that stand for them
  std::vector<const FloatingBase*> ways_;  ///< of links: the base behind which they are, up to its anchor
  std::vector<std::size_t> disturbed_;     ///< the link of each disturbance
  std::vector<std::size_t> mover_;         ///< of speeds: the last link that carries all that they move
  std::vector<LinkWrench> wrenches_;       ///< symbols
  std::size_t count_ = 0;
  Reach may_vary_;  ///< with anything that a model has derivatives by
  Reach is_disturbed_;
};

}  // namespace

bool has_tree_tangent(const Dynamics& dynamics, const Solution& solution) {
  if (!solution.motion || dynamics.l() > 0) return false;
  const auto& links = solution.motion->linkage.links;
  return std::none_of(links.begin(), links.end(), [](const Link& link) { return link.to_speeds.has_value(); });
}

TreeTangent tree_tangent(const Dynamics& dynamics, const Solution& solution, Expr epsilon, Steps& steps) {
  return Builder(dynamics, solution, epsilon, steps).run();
}

}  // namespace gaussgen::strategy
