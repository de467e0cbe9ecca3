#include "strategy/tree.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/cost.hpp"
#include "strategy/axes.hpp"
#include "strategy/margins.hpp"
#include "strategy/safety.hpp"
#include "strategy/tree_motion.hpp"
#include "strategy/tree_z.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Rational;
using ir::Vector3;
using kinematics::Freedom;
using kinematics::k_ground;
using kinematics::Link;

namespace {

/// How many times an inertia may be another one for multipliers to be right without a correction, up to the digits of this number.
constexpr double k_widest_range = 1e4;

/// Operations of a constraint's row over speeds that are few.
constexpr int k_short_row = 40;

/// From the ground to the leaves: multipliers, accelerations of links, accelerations along the speeds.
class Tree : private TreeZ {
 public:
  Tree(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps)
      : TreeZ(problem, form, epsilon, steps),
        w_(first_dual() + most_rows(problem), zero_),
        given_(links_.size(), ir::zero3(graph_)),
        moving_(links_.size(), {ir::zero3(graph_), ir::zero3(graph_)}),
        dependent_(zero_),
        lost_(zero_) {}

  std::optional<Solution> run() {
    if (!minimise() || !factorise_rows()) return std::nullopt;
    find_accelerations();
    find_solved_rows();
    if (!solved_rows_.empty() && needs_correction()) correct();
    find_imposed();
    return solution();
  }

 private:
  std::string name_of_acceleration(Component c) const {
    const char* const kind = is_linear(c) ? "a_" : "alpha_";
    return problem_.prefix + (is_correcting_ ? "correction_" : "") + kind + axis_of(c);
  }

  // What is left of Z: -½ λ·S λ + λ·p. At its stationary point S λ = p; the multipliers of (3.4) have the other sign.
  bool factorise_rows() {
    std::vector<std::string> labels;
    for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
      const bool is_gone =
          std::any_of(imposed_.begin(), imposed_.end(), [&](const Imposed& i) { return i.dual == dual(r); });
      if (is_gone || is_closed(r)) continue;
      left_.push_back(r);
      labels.push_back(rows_.rows[r].name);
    }
    if (left_.empty()) return true;
    steps_.begin("how the accelerations along the constraints respond: S = L D L^T");
    Matrix S;
    for (const std::size_t r : left_) {
      Z_.name({dual(r)}, steps_);
      S.emplace_back();
      for (const std::size_t other : left_) {
        const Expr entry = Z_.entry(dual(r), dual(other));
        S.back().push_back(entry.is_zero() ? entry : -entry);
      }
    }
    schur_.emplace(S, labels, problem_.prefix + "S", epsilon_, steps_, Dependent::drop);
    if (!schur_->vanishing().empty()) return false;
    dependent_ = schur_->dependent(problem_.least_response);
    return true;
  }

  /// From what the rows are without the multipliers.
  void solve_rows(const Vector& defect, const std::string& name) {
    const Vector lambda = schur_->solve(defect, problem_.prefix + name, steps_);
    for (std::size_t at = 0; at < left_.size(); ++at) w_[dual(left_[at])] = -lambda[at];
  }

  /// At the ground and where loops close.
  void find_solved_rows() {
    solved_rows_ = left_;
    for (const auto& [link, loop] : loops_) solved_rows_.insert(solved_rows_.end(), loop.rows.begin(), loop.rows.end());
  }

  void find_accelerations() {
    if (schur_) {
      Vector defect;
      for (const std::size_t r : left_) defect.push_back(rows_.rows[r].fall - Z_.linear(dual(r)));
      steps_.begin("multipliers, in the axes and units of these rows");
      solve_rows(defect, "force");
    }
    spread();
  }

  void spread() {
    for (std::size_t i = 0; i < links_.size(); ++i) outward(i);
    find_speeds();
  }

  // Accelerations without constraints may be large where something is light, and leave their rounding: then rows are not what
  // they should be. With parameters that anybody may change it can be so; numbers show it.
  bool needs_correction() {
    return std::any_of(solved_rows_.begin(), solved_rows_.end(), [&](std::size_t r) {
      if (!problem_.constraints.value_of) return true;
      const Response& response = responses_.at(dual(r));
      return !(problem_.constraints.value_of(response.spread()) <= k_widest_range);
    });
  }

  // Correcting once squares the relative error of a solve: as in the multiplier form.
  Expr lost_inertia() {
    std::vector<Expr> conditions;
    for (const std::size_t r : solved_rows_) {
      const Response& response = responses_.at(dual(r));
      const Expr inertia =
          steps_.name(response.inertia / response.squares, problem_.prefix + "inertia_" + rows_.rows[r].name);
      conditions.push_back(less(response.squares, epsilon_ * inertia * response.compliance));
    }
    return any(graph_, conditions);
  }

  bool is_forced() const {
    return !is_zero(problem_.field) ||
           std::any_of(problem_.forces.begin(), problem_.forces.end(), [](Expr Q) { return !Q.is_zero(); });
  }

  void correct() {
    if (is_forced()) lost_ = lost_inertia();
    steps_.begin("corrected once, by what rounding has left of the rows");
    Vector defect;
    for (const std::size_t r : left_) defect.push_back(-named_defect_of(r));
    for (const auto& [link, loop] : loops_) find_corrections(loop);
    const Vector rough = w_;
    w_.assign(w_.size(), zero_);
    is_correcting_ = true;
    if (schur_) solve_rows(defect, "correction");
    spread();
    for (std::size_t c = 0; c < w_.size(); ++c) w_[c] = rough[c] + w_[c];
  }

  Expr named_defect_of(std::size_t r) {
    return steps_.name(defect_of(r), problem_.prefix + "defect_" + rows_.rows[r].name);
  }

  // With what carries the loop as it is: its acceleration is not in these rows.
  void find_corrections(const ClosedLoop& loop) {
    Vector defect;
    for (const std::size_t r : loop.rows) defect.push_back(named_defect_of(r));
    for (std::size_t at = 0; at < loop.rows.size(); ++at) {
      const Eliminated& e = loop.multipliers[at];
      corrections_.insert_or_assign(e.component, defect[at] * loop.inverses[at]);
      for (std::size_t later = at + 1; later < loop.rows.size(); ++later) {
        for (const LinearTerm& term : e.factors) {
          if (term.component == dual(loop.rows[later])) defect[later] -= term.coefficient * defect[at];
        }
      }
    }
  }

  // Accelerations of links are larger than those of coordinates where turns between them cancel again: the row of the model sees
  // what is left then. Many terms of it would cost more than they see.
  Expr defect_of(std::size_t r) const {
    const LinkRow& row = rows_.rows[r];
    if (const auto mu = constraint_of(r); mu && !row.links.empty() && is_short(*mu)) {
      Expr sum = problem_.constraints.b_drift[*mu];
      for (std::size_t u = 0; u < problem_.forces.size(); ++u) sum += problem_.constraints.b[*mu][u] * w_[shared(u)];
      return per_length_ * sum;
    }
    Expr sum = row.rest - row.fall;
    for (const LinkTerm& term : row.links) {
      sum += dot(term.linear, of(a(term.link, 0))) + dot(term.angular, of(alpha(term.link, 0)));
      if (!by_link()) sum += drift_of(term);
    }
    for (const SpeedTerm& term : row.speeds) sum += term.coefficient * w_[shared(term.speed)];
    return sum;
  }

  /// The constraint that a row is, and no other.
  std::optional<std::size_t> constraint_of(std::size_t r) const {
    std::optional<std::size_t> found;
    for (std::size_t mu = 0; mu < rows_.multipliers.size(); ++mu) {
      for (const Share& share : rows_.multipliers[mu]) {
        if (share.row != r) continue;
        if (found || !share.factor.is_one()) return std::nullopt;
        found = mu;
      }
    }
    return found;
  }

  bool is_short(std::size_t mu) const {
    std::vector<ir::NodeId> ids{problem_.constraints.b_drift[mu].id()};
    for (const Expr e : problem_.constraints.b[mu]) ids.push_back(e.id());
    return ir::operations(graph_, ids) <= k_short_row;
  }

  /// The last ones first: their rows have multipliers of later ones in them.
  void find_imposed() {
    for (auto imposed = imposed_.rbegin(); imposed != imposed_.rend(); ++imposed) {
      Expr sum = imposed->linear;
      for (const LinearTerm& term : imposed->row) sum += term.coefficient * w_[term.component];
      w_[imposed->dual] = -(sum / imposed->component.pivot);
    }
  }

  /// A speed that no other constraint knows, behind a number.
  std::optional<std::size_t> own_speed(std::size_t mu) const {
    const Matrix& b = problem_.constraints.b;
    for (std::size_t u = 0; u < b[mu].size(); ++u) {
      if (safety(b[mu][u]) != Safety::number) continue;
      const auto users = std::count_if(b.begin(), b.end(), [&](const Vector& row) { return !row[u].is_zero(); });
      if (users == 1) return u;
    }
    return std::nullopt;
  }

  // The released direction bears the weight, of which nothing must be left in the others: there A - Q = λ b (3.4) is free of it.
  Vector multipliers(const Vector& accelerations) {
    steps_.begin("multipliers (3.4)");
    Vector result;
    for (std::size_t mu = 0; mu < rows_.multipliers.size(); ++mu) {
      Expr sum = zero_;
      for (const Share& share : rows_.multipliers[mu]) {
        const Rational unit = rows_.rows[share.row].links.empty() ? per_power_ : per_force_;
        sum -= (1 / unit) * (share.factor * w_[dual(share.row)]);
      }
      if (const auto u = own_speed(mu); u && !rows_.released.empty() && problem_.constraints.excess) {
        sum = problem_.constraints.excess(*u, accelerations) / problem_.constraints.b[mu][*u];
      }
      const kinematics::ConstraintIndex index{mu};
      const std::string& name = problem_.constraints.kinematics.constraints[index].name;
      result.push_back(steps_.name(sum, problem_.prefix + "lambda_" + name));
    }
    return result;
  }

  Expr at_minimum(const Eliminated& e) const {
    const auto correction = corrections_.find(e.component);
    Expr w = !is_correcting_ ? e.offset : correction == corrections_.end() ? zero_ : correction->second;
    for (const LinearTerm& term : e.factors) w -= term.coefficient * w_[term.component];
    return w;
  }

  Vector3 of(Component first) const { return {w_[first], w_[first + 1], w_[first + 2]}; }

  void outward(std::size_t i) {
    const Link& link = links_[i];
    steps_.begin("acceleration of " + link.name);
    for (auto e = shared_[i].rbegin(); e != shared_[i].rend(); ++e) w_[e->component] = at_minimum(*e);
    const bool is_first = link.parent == k_ground;
    const Vector3 none = ir::zero3(graph_);
    const bool falls = by_link() && !is_correcting_;
    const Vector3 a_before = !is_first ? of(a(link.parent, 0)) : falls ? motion_.fall() : none;
    const Vector3 alpha_before = is_first ? none : of(alpha(link.parent, 0));
    Vector3 linear = motion_.turned(i, a_before);
    Vector3 angular = motion_.turned(i, alpha_before);
    Vector3& moved = is_shift(i) ? linear : angular;
    if (is_shift(i)) linear = at_end(i, linear, alpha_before);
    if (falls) moved = moved + motion_.drift(i, steps_);
    if (!is_shift(i) && floats(i) == nullptr) linear = linear + disturbance(i);
    const Vector3 given = moved;
    moved = moved + by_shared(i);
    for (std::size_t k = 0; k < 3; ++k) {
      w_[a(i, k)] = linear[k];
      w_[alpha(i, k)] = angular[k];
    }
    name_given(i);
    find_own(i, given);
    if (const auto loop = loops_.find(i); loop != loops_.end()) find_multipliers(loop->second);
  }

  // The last one first, as the others depend on it.
  void find_multipliers(const ClosedLoop& loop) {
    for (auto e = loop.multipliers.rbegin(); e != loop.multipliers.rend(); ++e) {
      const std::string name = problem_.prefix + (is_correcting_ ? "correction_" : "force_") + axis_of(e->component);
      w_[e->component] = steps_.name(at_minimum(*e), name);
    }
  }

  /// Of the end of a link by that of its origin; what was found there before it said how the link turns stays what it is.
  Vector3 at_end(std::size_t i, Vector3 linear, Vector3 alpha) const {
    if (const auto led = led_.find(links_[i].parent); led != led_.end()) {
      linear[led->second.component % 3] = led->second.coefficient;
      alpha[links_[led->first].axis] = zero_;
    }
    return linear + cross(alpha, links_[i].offset);
  }

  /// The end first, and how the link turns from that.
  Expr by_end(const Eliminated& e) {
    const Lever& lever = *e.lever;
    Expr rest = is_correcting_ ? zero_ : e.offset;
    for (const LinearTerm& term : e.factors) {
      if (term.component != lever.along) rest -= term.coefficient * w_[term.component];
    }
    const std::string name =
        problem_.prefix + (is_correcting_ ? "correction_" : "") + "a_end_of_" + axis_of(lever.along);
    const Expr end = steps_.name(lever.ratio * w_[lever.along] + lever.arm * rest, name);
    led_.insert_or_assign(e.component / 6, LinearTerm{lever.along, end});
    return (end - w_[lever.along]) / lever.arm;
  }

  /// What the joint adds by speeds that no component is free by.
  Vector3 by_shared(std::size_t i) const {
    Vector3 sum = ir::zero3(graph_);
    for (const Freedom& freedom : links_[i].freedoms) {
      if (!is_own(freedom)) sum = sum + w_[shared(freedom.speed.value)] * freedom.column;
    }
    return sum;
  }

  void name_given(std::size_t i) {
    const FloatingBase* const floating = floats(i);
    for (std::size_t k = 0; k < 6; ++k) {
      const Component c = 6 * i + k;
      const std::size_t first = first_of_joint(i);
      const bool is_open = c >= first && c < first + 3 && own_.of_joint[i][c - first].is_free;
      if (is_open || (k < 3 && floating != nullptr && floating->along[k])) continue;
      w_[c] = steps_.name(w_[c], name_of_acceleration(c));
    }
  }

  /// The base on whose way to its anchor a link is, with both.
  const FloatingBase* floats(std::size_t i) const {
    for (const FloatingBase& floating : own_.bases) {
      if (is_carried(links_, floating.anchor, i)) return &floating;
    }
    return nullptr;
  }

  // The last one that was minimised first, as the others depend on it.
  void find_own(std::size_t i, const Vector3& given) {
    const FloatingBase* const floating = own_.base_anchored_at(i);
    bool is_said = true;
    Vector3 said = ir::zero3(graph_);
    for (auto e = eliminated_[i].rbegin(); e != eliminated_[i].rend(); ++e) {
      const Component c = e->component;
      const Expr w = e->lever ? by_end(*e) : at_minimum(*e);
      w_[c] = steps_.name(w, name_of_acceleration(c));
      if (floating == nullptr || !is_linear(c)) continue;
      is_said = is_said && is_imposed_.count(c) != 0;
      said[c % 3] = w;
    }
    if (own_.base_at(i) == nullptr) given_[i] = given;
    moving_[i] = {moving_[i].linear + of(a(i, 0)), moving_[i].angular + of(alpha(i, 0))};
    if (floating == nullptr) return;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!floating->along[k]) continue;
      // What rows say has free fall taken out: then it need not be put in, turned, and taken out again.
      said[k] = is_said && !is_correcting_ ? said[k] - motion_.fall_at(i)[k] : w_[a(i, k)];
    }
    find_base(*floating, said, is_said);
  }

  /// Of the origin of a link that turns; on the way back from where a base floats, in the axes before it.
  Vector3 disturbance(std::size_t i) const {
    return problem_.disturbance == nullptr || is_correcting_ ? ir::zero3(graph_) : problem_.disturbance->linear[i];
  }

  // Back along the way to the link that floats.
  void find_base(const FloatingBase& floating, Vector3 v, bool is_without_fall) {
    for (std::size_t at = floating.anchor; at != floating.base; at = links_[at].parent) {
      const std::size_t parent = links_[at].parent;
      if (is_shift(at)) {
        v = v - cross(of(alpha(parent, 0)), links_[at].offset);
        if (by_link() && !is_correcting_) v = v - motion_.drift(at, steps_);
      } else {
        v = motion_.turned_back(at, v) + disturbance(at);
      }
    }
    Vector3 given = ir::zero3(graph_);
    if (!is_correcting_) given = given + motion_.drift(floating.base, steps_);
    if (!is_correcting_) given = given + motion_.fall();
    for (std::size_t k = 0; k < 3; ++k) {
      if (floating.along[k])
        w_[a(floating.base, k)] = is_without_fall && !is_correcting_ ? v[k] + motion_.fall()[k] : v[k];
    }
    given_[floating.base] = given;
  }

  // A component is free by the first speed that has it alone; those found later move along it, too, and are known before.
  void find_speeds() {
    for (auto owned = own_.in_order.rbegin(); owned != own_.in_order.rend(); ++owned) {
      const auto& [i, k] = *owned;
      if (links_[i].to_speeds) {
        find_turned_speeds(i);
        continue;
      }
      const Freedom& own = *own_.of_joint[i][k].freedom;
      Expr along = w_[first_of_joint(i) + k] - given_[i][k];
      for (const Freedom& other : links_[i].freedoms) {
        if (&other != &own) along -= other.column[k] * w_[shared(other.speed.value)];
      }
      w_[shared(own.speed.value)] = along / own.column[k];
    }
    if (!is_correcting_) find_speeds_of_one_row();
  }

  void find_turned_speeds(std::size_t i) {
    const Vector3 own = ir::multiply(*links_[i].to_speeds, of(alpha(i, 0)) - given_[i]);
    for (std::size_t j = 0; j < 3; ++j) w_[shared(links_[i].freedoms[j].speed.value)] = own[j];
  }

  // What a constraint says of one speed alone holds to the last digit, also where it is zero.
  void find_speeds_of_one_row() {
    const ConstraintProblem& constraints = problem_.constraints;
    for (std::size_t mu = 0; mu < constraints.b.size(); ++mu) {
      const Vector& b = constraints.b[mu];
      const auto has_entry = [](Expr e) { return !e.is_zero(); };
      const auto first = std::find_if(b.begin(), b.end(), has_entry);
      if (first == b.end() || std::any_of(first + 1, b.end(), has_entry) || safety(*first) == Safety::unknown) continue;
      w_[shared(static_cast<std::size_t>(first - b.begin()))] = -(constraints.b_drift[mu] / *first);
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
    Margins rows(graph_);
    for (const auto& [value, bound] : row_margins_) rows.require(value, bound);
    Margins loops(graph_);
    for (const auto& [pivot, bound] : loop_margins_) loops.require(pivot, bound);
    const Expr dependent = any(graph_, {dependent_, rows.violated("least_coefficient"),
                                        loops.violated("least_" + problem_.prefix + "S_pivot_of_loops")});
    const Expr singular = any(graph_, {margins.violated("least_pivot"), lost_});
    return {accelerations, multipliers(accelerations), singular, dependent, "", {}, {}, {}, false, motion()};
  }

  std::shared_ptr<const TreeMotion> motion() const {
    TreeMotion result{linkage_,    carriers_, sole_freedoms(problem_.linkage.links),
                      properties_, moved_,    moving_,
                      {},          {},        motion_.fall(),
                      {},          {}};
    result.length = 1 / per_length_;
    result.mass = per_length_ / per_force_;
    result.bases = own_.bases;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      LinkAcceleration& a = result.accelerations[i];
      if (!by_link()) {
        a.linear = a.linear + motion_.accumulated(i).linear;
        a.angular = a.angular + motion_.accumulated(i).angular;
      }
      result.omega.push_back(motion_.omega(i));
      result.origins.push_back(origin(i));
    }
    return std::make_shared<const TreeMotion>(std::move(result));
  }

  /// The first link with the same origin of which the acceleration is known; none where this is fixed.
  std::size_t origin(std::size_t i) const {
    while (i != k_ground && !is_shift(i) && own_.base_anchored_at(i) == nullptr) i = links_[i].parent;
    return i;
  }

  Vector w_;                               ///< by component
  std::map<std::size_t, LinearTerm> led_;  ///< by the link that turns: the acceleration of its end
  std::vector<Vector3> given_;  ///< of links: what their joints do not decide of the components that are moved
  std::vector<LinkAcceleration> moving_;   ///< of links: where they have mass, the accelerations that were found
  std::vector<std::size_t> left_;          ///< rows that were not imposed, and do not close before the ground
  std::vector<std::size_t> solved_rows_;   ///< these, and those that do
  std::map<Component, Expr> corrections_;  ///< of multipliers of loops, with what carries them as it is
  std::optional<Ldl> schur_;
  bool is_correcting_ = false;
  Expr dependent_, lost_;
};

}  // namespace

std::optional<Solution> solve_tree(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps) {
  return Tree(problem, form, epsilon, steps).run();
}

}  // namespace gaussgen::strategy
