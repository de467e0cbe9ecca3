#include "strategy/tree.hpp"

#include <algorithm>
#include <map>

#include "ir/contract.hpp"
#include "strategy/link_motion.hpp"
#include "strategy/margins.hpp"
#include "strategy/mass_properties.hpp"
#include "strategy/quadratic_form.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Vector3;
using kinematics::Freedom;
using kinematics::k_ground;
using kinematics::Link;
using kinematics::Linkage;

namespace {

const char* const k_axes = "xyz";

class Tree {
 public:
  Tree(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps)
      : problem_(problem),
        drift_(form.drift),
        steps_(steps),
        graph_(epsilon.graph()),
        epsilon_(epsilon),
        zero_(graph_, graph_.constant(0)),
        linkage_(in_units(problem.linkage, form.length, form.mass)),
        links_(linkage_.links),
        properties_(mass_properties(linkage_, graph_)),
        bounds_(mass_bounds(links_, properties_)),
        motion_(links_, scaled(-1 / form.length, problem.field), problem.prefix),
        per_power_(1 / (form.mass * form.length * form.length)),
        Z_(graph_, 6 * links_.size() + problem.forces.size(),
           [this](Component i, Component j, bool is_linear) { return is_linear ? name_of(i) : name_of(i, j); }),
        masses_(links_.size(), zero_),
        eliminated_(links_.size()),
        shared_(links_.size()),
        own_(links_.size()),
        w_(6 * links_.size() + problem.forces.size(), zero_),
        uses_(problem.forces.size()) {
    find_spins(properties_, links_);
    move_masses_to_ends(links_, properties_);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      for (const Freedom& freedom : links_[i].freedoms) uses_[freedom.speed.value].push_back(i);
    }
  }

  std::optional<Solution> run() {
    if (std::any_of(uses_.begin(), uses_.end(), [](const auto& links) { return links.empty(); })) return std::nullopt;
    motion_.find_velocities(steps_);
    if (drift_ == Drift::accumulated) motion_.accumulate(steps_);
    for (std::size_t i = 0; i < links_.size(); ++i) find_own_freedoms(i);
    for (std::size_t i = links_.size(); i-- > 0;) {
      if (!inward(i)) return std::nullopt;
    }
    for (std::size_t i = 0; i < links_.size(); ++i) outward(i);
    return solution();
  }

 private:
  static Component a(std::size_t link, std::size_t k) { return 6 * link + k; }
  static Component alpha(std::size_t link, std::size_t k) { return 6 * link + 3 + k; }
  Component shared(std::size_t speed) const { return 6 * links_.size() + speed; }
  bool is_shared(Component c) const { return c >= 6 * links_.size(); }

  // Blocks of Z as mechanics names them: mass M, moments of inertia I, and H between them; forces F, moments N.
  std::string axis_of(Component c) const {
    return is_shared(c) ? problem_.symbols.speeds[kinematics::FreeIndex{c - shared(0)}].label
                        : std::string(1, k_axes[c % 3]);
  }

  const std::string& link_of(Component c) const {
    static const std::string k_none;
    return is_shared(c) ? k_none : links_[c / 6].name;
  }

  static bool is_linear(Component c) { return c % 6 < 3; }

  std::string name_of(Component c) const {
    if (is_shared(c)) return problem_.prefix + "Q_" + axis_of(c);
    return problem_.prefix + (is_linear(c) ? "F_" : "N_") + link_of(c) + "_" + axis_of(c);
  }

  std::string name_of(Component i, Component j) const {
    if (is_shared(i)) return problem_.prefix + "Z_" + axis_of(i) + "_" + axis_of(j);
    const char* block = is_shared(j) ? "Z_" : is_linear(i) == is_linear(j) ? (is_linear(i) ? "M_" : "I_") : "H_";
    return problem_.prefix + block + link_of(i) + "_" + axis_of(i) + axis_of(j);
  }

  /// A speed with which this component of the link's acceleration grows, and nothing else does: then that component is free
  /// itself, whatever the links before do.
  void find_own_freedoms(std::size_t i) {
    own_[i].assign(3, nullptr);
    for (const Freedom& freedom : links_[i].freedoms) {
      if (uses_[freedom.speed.value].size() != 1) continue;
      std::size_t k = 3;
      int count = 0;
      for (std::size_t at = 0; at < 3; ++at) {
        if (freedom.column[at].is_zero()) continue;
        ++count;
        k = at;
      }
      const bool is_number = count == 1 && graph_[freedom.column[k].id()].kind == ir::Kind::constant;
      if (is_number && own_[i][k] == nullptr) own_[i][k] = &freedom;
    }
  }

  bool is_own(std::size_t i, const Freedom& freedom) const {
    return std::find(own_[i].begin(), own_[i].end(), &freedom) != own_[i].end();
  }

  Expr force(const Freedom& freedom) const { return per_power_ * problem_.forces[freedom.speed.value]; }

  /// Of the body itself (theory section 6): ½ a·m a + a·(α × f) + ½ α·I α, with what velocities and the drift do.
  void add_body(std::size_t i) {
    const MassProperties& body = properties_[i];
    const Vector3& omega = motion_.omega(i);
    masses_[i] += body.mass;
    Vector3 force = cross(omega, cross(omega, body.first));
    Vector3 moment = cross(omega, ir::multiply(body.inertia, omega));
    if (drift_ == Drift::accumulated) {
      const auto& [linear, angular] = motion_.accumulated(i);
      force = force + cross(angular, body.first);
      moment = moment + cross(body.first, linear) + ir::multiply(body.inertia, angular);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
      Z_.add(alpha(i, p), a(i, q), -body.first[k]);
      Z_.add(alpha(i, q), a(i, p), body.first[k]);
      for (std::size_t l = k; l < 3; ++l) Z_.add(alpha(i, k), alpha(i, l), body.inertia[k][l]);
      Z_.add(a(i, k), force[k]);
      Z_.add(alpha(i, k), moment[k]);
    }
  }

  std::vector<Component> components(std::size_t i) const {
    std::vector<Component> all;
    for (std::size_t k = 0; k < 6; ++k) all.push_back(6 * i + k);
    return all;
  }

  bool inward(std::size_t i) {
    const Link& link = links_[i];
    steps_.begin("Z of all that " + link.name + " carries, at its minimum over the own acceleration of " + link.name);
    add_body(i);
    if (link.kind == Link::Kind::shift) add_mass(i);
    Z_.name(components(i), steps_);
    const Component first = link.kind == Link::Kind::shift ? a(i, 0) : alpha(i, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      if (own_[i][k] != nullptr && !minimise_own(i, first + k, *own_[i][k])) return false;
    }
    pass_on(i, first);
    if (link.parent != k_ground) Z_.name(components(link.parent), steps_);
    return minimise_shared(i);
  }

  // Where the origin is shifted, the mass that was carried along with it has a lever.
  void add_mass(std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Z_.add(a(i, k), a(i, k), masses_[i]);
      if (drift_ == Drift::accumulated) Z_.add(a(i, k), masses_[i] * motion_.accumulated(i).linear[k]);
    }
  }

  bool minimise_own(std::size_t i, Component c, const Freedom& freedom) {
    // Q du/dt with du/dt = (w - w_given)/s: what acts on the link, and its opposite on what is before it.
    const Expr Q = force(freedom) / freedom.column[c % 3];
    Z_.add(c, -Q);
    eliminated_[i].push_back(minimise(i, c));
    Z_.add(c, Q);
    return !eliminated_[i].back().pivot.is_zero();
  }

  Eliminated minimise(std::size_t i, Component c) {
    const Eliminated result = Z_.minimise(c, steps_);
    margins_.push_back({result.pivot, is_clean_ ? zero_ : rounding(i, c)});
    is_clean_ = false;
    ++pivots_;
    return result;
  }

  // Of the sum of all that a pivot is the rest of.
  Expr rounding(std::size_t i, Component c) const {
    Expr sum = zero_;
    if (is_shared(c)) {
      for (const std::size_t link : uses_[c - shared(0)]) sum += bound_along(link, c - shared(0));
    } else {
      sum = is_linear(c) ? bounds_[i].mass : greatest_inertia(i);
    }
    return ir::Rational(4 * static_cast<int>(pivots_ + 1)) * epsilon_ * sum;
  }

  Expr greatest_inertia(std::size_t i) const {
    const MassBound& bound = bounds_[i];
    return ir::Rational(2) * (bound.inertia + bound.mass * bound.reach * bound.reach);
  }

  Expr bound_along(std::size_t i, std::size_t speed) const {
    Expr squares = zero_;
    for (const Freedom& freedom : links_[i].freedoms) {
      if (freedom.speed.value == speed) squares += ir::dot(freedom.column, freedom.column);
    }
    return squares * (links_[i].kind == Link::Kind::shift ? bounds_[i].mass : greatest_inertia(i));
  }

  // w_i in terms of what is before the link. A component that is free itself was minimised with its drift in it.
  void pass_on(std::size_t i, Component first) {
    const Link& link = links_[i];
    const bool is_first = link.parent == k_ground;
    if (drift_ == Drift::by_link) {
      const Vector3& drift = motion_.drift(i, steps_);
      const Vector3 fall = motion_.turned(i, motion_.fall());
      for (std::size_t k = 0; k < 3; ++k) {
        if (own_[i][k] == nullptr) Z_.displace(first + k, drift[k]);
        if (is_first) Z_.displace(a(i, k), fall[k]);
      }
    }
    if (link.kind == Link::Kind::shift) return shift(i);
    if (!is_first) masses_[link.parent] += masses_[i];
    turn(i);
  }

  void add_shared(std::size_t i, std::size_t k, std::vector<LinearTerm>& terms) const {
    for (const Freedom& freedom : links_[i].freedoms) {
      if (is_own(i, freedom) || freedom.column[k].is_zero()) continue;
      terms.push_back({shared(freedom.speed.value), freedom.column[k]});
    }
  }

  void shift(std::size_t i) {
    const Link& link = links_[i];
    const std::size_t parent = link.parent;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
      std::vector<LinearTerm> terms, same;
      if (parent != k_ground) {
        terms.push_back({a(parent, k), one()});
        if (!link.offset[q].is_zero()) terms.push_back({alpha(parent, p), link.offset[q]});
        if (!link.offset[p].is_zero()) terms.push_back({alpha(parent, q), -link.offset[p]});
        same.push_back({alpha(parent, k), one()});
      }
      Z_.substitute(alpha(i, k), same);
      add_shared(i, k, terms);
      Z_.substitute(a(i, k), terms);
    }
  }

  Expr one() const { return {graph_, graph_.constant(1)}; }

  void turn(std::size_t i) {
    const Link& link = links_[i];
    const std::size_t parent = link.parent;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<LinearTerm> terms;
      add_shared(i, k, terms);
      for (const LinearTerm& term : terms) Z_.couple(alpha(i, k), term);
    }
    for (const Component first : {a(i, 0), alpha(i, 0)}) {
      const Component to = parent == k_ground ? first : first - 6 * i + 6 * parent;
      if (parent == k_ground) {
        for (std::size_t k = 0; k < 3; ++k) Z_.substitute(first + k, {});
      } else if (link.kind == Link::Kind::turn) {
        const std::size_t p = (link.axis + 1) % 3, q = (link.axis + 2) % 3;
        Z_.turn(first + p, first + q, to + p, to + q, motion_.sine(i), motion_.cosine(i));
        Z_.substitute(first + link.axis, {{to + link.axis, one()}});
      } else {
        turn_freely(link, first, to);
      }
    }
  }

  void turn_freely(const Link& link, Component from, Component to) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<LinearTerm> terms;
      for (std::size_t l = 0; l < 3; ++l) {
        const Expr entry = link.kind == Link::Kind::free ? link.matrix[l][k] : l == k ? one() : zero_;
        if (!entry.is_zero()) terms.push_back({to + l, entry});
      }
      Z_.substitute(from + k, terms);
    }
  }

  // Speeds of several links: each as soon as the last link that has it is passed.
  bool minimise_shared(std::size_t i) {
    for (const Freedom& freedom : links_[i].freedoms) {
      if (is_own(i, freedom) || uses_[freedom.speed.value].front() != i) continue;
      const Component c = shared(freedom.speed.value);
      Z_.add(c, -force(freedom));
      shared_[i].push_back(minimise(i, c));
      if (shared_[i].back().pivot.is_zero()) return false;
    }
    return true;
  }

  Expr at_minimum(const Eliminated& e) const {
    Expr w = e.offset;
    for (const LinearTerm& term : e.factors) w -= term.coefficient * w_[term.component];
    return w;
  }

  Vector3 of(Component first) const { return {w_[first], w_[first + 1], w_[first + 2]}; }

  void outward(std::size_t i) {
    const Link& link = links_[i];
    steps_.begin("acceleration of " + link.name);
    for (auto e = shared_[i].rbegin(); e != shared_[i].rend(); ++e) w_[e->component] = at_minimum(*e);
    const bool accumulates = drift_ == Drift::accumulated;
    const bool is_first = link.parent == k_ground;
    const Vector3 none = ir::zero3(graph_);
    const Vector3 a_before = !is_first ? of(a(link.parent, 0)) : accumulates ? none : motion_.fall();
    const Vector3 alpha_before = is_first ? none : of(alpha(link.parent, 0));
    Vector3 linear = motion_.turned(i, a_before);
    Vector3 angular = motion_.turned(i, alpha_before);
    Vector3& moved = link.kind == Link::Kind::shift ? linear : angular;
    if (link.kind == Link::Kind::shift) linear = linear + cross(alpha_before, link.offset);
    if (!accumulates) moved = moved + motion_.drift(i, steps_);
    for (std::size_t k = 0; k < 3; ++k) moved[k] += of_shared(i, k);
    for (std::size_t k = 0; k < 3; ++k) {
      w_[a(i, k)] = linear[k];
      w_[alpha(i, k)] = angular[k];
    }
    name_given(i);
    find_own(i, moved);
  }

  Expr of_shared(std::size_t i, std::size_t k) const {
    Expr sum = zero_;
    for (const Freedom& freedom : links_[i].freedoms) {
      if (!is_own(i, freedom)) sum += freedom.column[k] * w_[shared(freedom.speed.value)];
    }
    return sum;
  }

  std::string name_of_acceleration(Component c) const {
    return problem_.prefix + (is_linear(c) ? "a_" : "alpha_") + link_of(c) + "_" + axis_of(c);
  }

  void name_given(std::size_t i) {
    const std::size_t first = links_[i].kind == Link::Kind::shift ? 0 : 3;
    for (std::size_t k = 0; k < 6; ++k) {
      const bool is_open = k >= first && k < first + 3 && own_[i][k - first] != nullptr;
      if (!is_open) w_[6 * i + k] = steps_.name(w_[6 * i + k], name_of_acceleration(6 * i + k));
    }
  }

  // The last one that was minimised first, as the others depend on it.
  void find_own(std::size_t i, const Vector3& given) {
    for (auto e = eliminated_[i].rbegin(); e != eliminated_[i].rend(); ++e) {
      const std::size_t k = e->component % 3;
      w_[e->component] = steps_.name(at_minimum(*e), name_of_acceleration(e->component));
      const Freedom& freedom = *own_[i][k];
      w_[shared(freedom.speed.value)] = (w_[e->component] - given[k]) / freedom.column[k];
    }
  }

  Solution solution() {
    steps_.begin("accelerations along the speeds");
    Vector accelerations;
    for (std::size_t u = 0; u < problem_.forces.size(); ++u) {
      const std::string& label = problem_.symbols.speeds[kinematics::FreeIndex{u}].label;
      accelerations.push_back(steps_.name(w_[shared(u)], problem_.prefix + "a_" + label));
    }
    Margins margins(graph_);
    for (const auto& [pivot, bound] : margins_) margins.require(pivot, bound);
    return {accelerations, {}, margins.violated("least_pivot"), zero_, "", {}, {}, {}, false};
  }

  const TreeProblem& problem_;
  Drift drift_;
  Steps& steps_;
  ir::Graph& graph_;
  Expr epsilon_;
  Expr zero_;
  Linkage linkage_;
  std::vector<Link>& links_;
  std::vector<MassProperties> properties_;
  std::vector<MassBound> bounds_;
  LinkMotion motion_;
  ir::Rational per_power_;
  QuadraticForm Z_;
  Vector masses_;                                             ///< at the origins, where they are the same in all axes
  std::vector<std::vector<Eliminated>> eliminated_, shared_;  ///< by link, in order
  std::vector<std::vector<const Freedom*>> own_;
  Vector w_;                                    ///< by component
  std::vector<std::vector<std::size_t>> uses_;  ///< of speeds: their links, in order
  std::vector<std::pair<Expr, Expr>> margins_;
  bool is_clean_ = true;  ///< nothing was minimised yet, so nothing has cancelled
  std::size_t pivots_ = 0;
};

}  // namespace

std::optional<Solution> solve_tree(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps) {
  return Tree(problem, form, epsilon, steps).run();
}

}  // namespace gaussgen::strategy
