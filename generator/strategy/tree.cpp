#include "strategy/tree.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ir/contract.hpp"
#include "ir/cost.hpp"
#include "strategy/axes.hpp"
#include "strategy/fixed_turns.hpp"
#include "strategy/link_motion.hpp"
#include "strategy/margins.hpp"
#include "strategy/own_components.hpp"
#include "strategy/quadratic_form.hpp"
#include "strategy/safety.hpp"
#include "strategy/spins.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Rational;
using ir::Vector3;
using kinematics::Freedom;
using kinematics::k_ground;
using kinematics::Link;
using kinematics::Linkage;

namespace {

const char* const k_axes = "xyz";

/// How many times its rounding error the response of a constraint exceeds where it says something of its own.
constexpr int k_lost_in_rows = 1000;

/// How many times an inertia may be another one for multipliers to be right without a correction, up to the digits of this number.
constexpr double k_widest_range = 1e4;

/// How components with inertia follow a multiplier.
struct Response {
  Expr squares, compliance, inertia;

  void add(Expr pivot, Expr coefficient) {
    const Expr square = pow(coefficient, 2);
    squares += square;
    compliance += square / pivot;
    inertia += square * pivot;
  }

  /// The largest inertia over the least, or nearly.
  Expr spread() const { return compliance * inertia / pow(squares, 2); }
};

/// Operations of a constraint's row over speeds that are few.
constexpr int k_short_row = 40;

class Tree {
 public:
  Tree(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps)
      : problem_(problem),
        drift_(form.drift),
        steps_(steps),
        graph_(epsilon.graph()),
        epsilon_(epsilon),
        zero_(graph_, graph_.constant(0)),
        linkage_(prepared(problem.linkage, form)),
        links_(linkage_.links),
        properties_(mass_properties(linkage_, graph_)),
        motion_(links_, scaled(-1 / form.length, problem.field), problem.prefix),
        per_power_(1 / (form.mass * form.length * form.length)),
        per_force_(1 / (form.mass * form.length)),
        per_length_(1 / form.length),
        Z_(graph_, first_dual() + most_rows(problem),
           [this](Component i, Component j, bool is_linear) { return is_linear ? name_of(i) : name_of(i, j); }),
        masses_(links_.size(), zero_),
        eliminated_(links_.size()),
        shared_(links_.size()),
        w_(first_dual() + most_rows(problem), zero_),
        given_(links_.size(), ir::zero3(graph_)),
        dependent_(zero_),
        lost_(zero_) {
    find_spins(properties_, linkage_);
    bounds_ = mass_bounds(links_, properties_);
    move_masses_to_ends(links_, properties_);
  }

  std::optional<Solution> run() {
    const LinkRowBuilder builder(problem_.constraints, linkage_);
    motion_.find_velocities(steps_);
    rows_ = builder.rows(motion_, steps_);
    own_ = own_components(links_, properties_, acted_on(), rows_.released);
    const auto& uses = own_.uses;
    if (std::any_of(uses.begin(), uses.end(), [](const auto& links) { return links.empty(); })) return std::nullopt;
    place_rows();
    if (drift_ == Drift::accumulated) {
      motion_.accumulate(
          [this](std::size_t i, std::size_t k) { return own_.base_at(i) != nullptr && own_.base_at(i)->along[k]; },
          steps_);
    }
    for (std::size_t i = links_.size(); i-- > 0;) {
      if (!inward(i)) return std::nullopt;
    }
    if (!factorise_rows()) return std::nullopt;
    find_accelerations();
    if (schur_ && needs_correction()) correct();
    find_imposed();
    return solution();
  }

 private:
  static Linkage prepared(const Linkage& linkage, const TreeForm& form) {
    Linkage result = in_units(linkage, form.length, form.mass);
    if (form.chooses_axes) choose_axes(result);
    return result;
  }

  static std::size_t most_rows(const TreeProblem& problem) {
    return problem.constraints.kinematics.constraints.size() + problem.constraints.kinematics.idle_slips.size();
  }

  static Component a(std::size_t link, std::size_t k) { return 6 * link + k; }
  static Component alpha(std::size_t link, std::size_t k) { return 6 * link + 3 + k; }
  Component shared(std::size_t speed) const { return 6 * links_.size() + speed; }
  Component first_dual() const { return 6 * links_.size() + problem_.forces.size(); }
  Component dual(std::size_t row) const { return first_dual() + row; }

  bool is_of_link(Component c) const { return c < 6 * links_.size(); }
  bool is_dual(Component c) const { return c >= first_dual(); }
  bool is_linear(Component c) const { return is_of_link(c) && c % 6 < 3; }
  bool by_link() const { return drift_ == Drift::by_link; }
  bool is_shift(std::size_t i) const { return links_[i].kind == Link::Kind::shift; }
  Component first_of_joint(std::size_t i) const { return is_shift(i) ? a(i, 0) : alpha(i, 0); }

  // Blocks of Z as mechanics names them: mass M, moments of inertia I, and H between them; forces F, moments N; b for rows of
  // constraints.
  std::string axis_of(Component c) const {
    if (is_dual(c)) return rows_.rows[c - first_dual()].name;
    if (!is_of_link(c)) return problem_.symbols.speeds[kinematics::FreeIndex{c - shared(0)}].label;
    return links_[c / 6].name + "_" + std::string(1, k_axes[c % 3]);
  }

  std::string name_of(Component c) const {
    const char* const kind = is_dual(c) ? "drift_" : !is_of_link(c) ? "Q_" : is_linear(c) ? "F_" : "N_";
    return problem_.prefix + kind + axis_of(c);
  }

  std::string name_of(Component i, Component j) const {
    if (is_of_link(j)) {
      const char* const block = is_linear(i) == is_linear(j) ? (is_linear(i) ? "M_" : "I_") : "H_";
      return problem_.prefix + block + axis_of(i) + k_axes[j % 3];
    }
    const char* const block = !is_dual(j) ? "Z_" : !is_dual(i) ? "b_" : "S_";
    const char* const which = is_linear(i) ? "a_" : is_of_link(i) ? "alpha_" : "";
    return problem_.prefix + block + (is_dual(j) ? which : "") + axis_of(i) + "_" + axis_of(j);
  }

  std::string name_of_acceleration(Component c) const {
    const char* const kind = is_linear(c) ? "a_" : "alpha_";
    return problem_.prefix + (is_correcting_ ? "correction_" : "") + kind + axis_of(c);
  }

  Expr one() const { return {graph_, graph_.constant(1)}; }
  Expr force(std::size_t speed) const { return per_power_ * problem_.forces[speed]; }

  std::vector<char> acted_on() const {
    std::vector<char> result;
    for (const Expr Q : problem_.forces) result.push_back(Q.is_zero() ? 0 : 1);
    for (const LinkRow& row : rows_.rows) {
      for (const SpeedTerm& term : row.speeds) result[term.speed] = 1;
    }
    return result;
  }

  // --- constraints --------------------------------------------------------------------------------------------

  // Rows over links are about accelerations in space, without the free fall that Z has in it. A row waits at the last link that carries all it acts on: from there on it is complete.
  void place_rows() {
    waiting_.resize(links_.size());
    for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
      const LinkRow& row = rows_.rows[r];
      Z_.add(dual(r), row.rest - row.fall);
      if (row.links.empty()) continue;
      std::size_t top = row.links[0].link;
      for (const LinkTerm& term : row.links) top = common_carrier(links_, top, term.link);
      if (top != k_ground) waiting_[top].push_back(r);
    }
  }

  void add_rows(std::size_t i) {
    for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
      for (const LinkTerm& term : rows_.rows[r].links) {
        if (term.link == i) add_term(term, r);
      }
    }
  }

  void add_term(const LinkTerm& term, std::size_t r) {
    const std::size_t i = term.link;
    for (std::size_t k = 0; k < 3; ++k) {
      Z_.add(a(i, k), dual(r), term.linear[k]);
      Z_.add(alpha(i, k), dual(r), term.angular[k]);
    }
    if (!by_link()) Z_.add(dual(r), drift_of(term));
  }

  // What acts along a speed, on a component of which du/dt has `per` as its part.
  void act(Component c, std::size_t speed, Expr per) {
    Z_.add(c, -(force(speed) * per));
    for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
      for (const SpeedTerm& term : rows_.rows[r].speeds) {
        if (term.speed == speed) Z_.add(c, dual(r), term.coefficient * per);
      }
    }
  }

  // Where a number stands before a component that is free, the row says what this component is, without a division.
  void impose_rows(std::size_t i, std::vector<Component>& free) {
    std::vector<std::size_t> rest;
    for (const std::size_t r : waiting_[i]) {
      const std::optional<std::size_t> best = safest(r, free);
      if (!best) {
        rest.push_back(r);
        continue;
      }
      const Component c = free[*best];
      free.erase(free.begin() + static_cast<std::ptrdiff_t>(*best));
      imposed_.push_back(Z_.impose(c, dual(r), steps_));
      is_imposed_.insert(c);
      eliminated_[i].push_back(imposed_.back().component);
    }
    const std::size_t parent = links_[i].parent;
    if (parent != k_ground) waiting_[parent].insert(waiting_[parent].end(), rest.begin(), rest.end());
  }

  std::optional<std::size_t> safest(std::size_t r, const std::vector<Component>& free) const {
    if (!Z_.entry(dual(r), dual(r)).is_zero()) return std::nullopt;
    std::optional<std::size_t> best;
    for (std::size_t at = 0; at < free.size(); ++at) {
      const Expr pivot = Z_.entry(dual(r), free[at]);
      if (safety(pivot) == Safety::unknown) continue;
      if (!best || safety(pivot) < safety(Z_.entry(dual(r), free[*best]))) best = at;
    }
    return best;
  }

  // --- from the leaves to the ground --------------------------------------------------------------------------

  /// Of the body itself (theory section 6): ½ a·m a + a·(α × f) + ½ α·I α, with what velocities and the drift do.
  void add_body(std::size_t i) {
    const MassProperties& body = properties_[i];
    const Vector3& omega = motion_.omega(i);
    masses_[i] += body.mass;
    Vector3 force = cross(omega, cross(omega, body.first));
    Vector3 moment = cross(omega, ir::multiply(body.inertia, omega));
    if (!by_link()) {
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

  // Where the origin is shifted or free, the mass that was carried along with it counts.
  void add_mass(std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Z_.add(a(i, k), a(i, k), masses_[i]);
      if (!by_link()) Z_.add(a(i, k), masses_[i] * motion_.accumulated(i).linear[k]);
    }
    masses_[i] = zero_;
  }

  std::vector<Component> components(std::size_t i) const {
    std::vector<Component> all;
    for (std::size_t k = 0; k < 6; ++k) all.push_back(6 * i + k);
    return all;
  }

  /// Its own components of the joint, where nothing else minimises over them.
  std::vector<Component> own_of_joint(std::size_t i) const {
    std::vector<Component> result;
    for (std::size_t k = 0; k < 3; ++k) {
      if (own_.of_joint[i][k].is_free && own_.base_at(i) == nullptr) result.push_back(first_of_joint(i) + k);
    }
    return result;
  }

  bool inward(std::size_t i) {
    steps_.begin("Z of all that " + links_[i].name + " carries, at its minimum over the own acceleration of " +
                 links_[i].name);
    const FloatingBase* const floating = own_.base_anchored_at(i);
    add_body(i);
    if (is_shift(i) || floating != nullptr) add_mass(i);
    add_rows(i);
    std::vector<Component> free;
    if (floating != nullptr) free = free_to_float(*floating);
    const std::vector<Component> own = own_of_joint(i);
    free.insert(free.end(), own.begin(), own.end());
    act_on(i, 1);
    Z_.name(components(i), steps_);
    impose_rows(i, free);
    for (const Component c : free) {
      eliminated_[i].push_back(minimise(i, c));
      if (has_no_inertia(eliminated_[i].back())) return false;
    }
    act_on(i, -1);
    pass_on(i);
    if (links_[i].parent != k_ground) Z_.name(components(links_[i].parent), steps_);
    return minimise_shared(i);
  }

  // Q du/dt with du/dt = (w - w_given)/s: what acts on the link, and its opposite on what is before it. What floats was
  // minimised elsewhere.
  void act_on(std::size_t i, int factor) {
    if (factor > 0 && own_.base_at(i) != nullptr) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const OwnComponent& own = own_.of_joint[i][k];
      if (own.freedom == nullptr) continue;
      act(first_of_joint(i) + k, own.freedom->speed.value, Rational(factor) * pow(own.freedom->column[k], -1));
    }
  }

  std::vector<Component> free_to_float(const FloatingBase& floating) {
    std::vector<Component> free;
    const std::size_t i = floating.anchor;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!floating.along[k]) continue;
      free.push_back(a(i, k));
      const Freedom* const freedom = own_.of_joint[floating.base][k].freedom;
      if (freedom == nullptr) continue;
      const Vector3 direction = resolved(links_, floating.base, i, ir::unit_vector(graph_, k));
      for (std::size_t l = 0; l < 3; ++l) act(a(i, l), freedom->speed.value, direction[l] / freedom->column[k]);
    }
    return free;
  }

  // Rows may say then what inertia does not: Z over all speeds at once, completed by them, knows how.
  bool has_no_inertia(const Eliminated& e) const {
    return e.pivot.is_zero() || (!rows_.rows.empty() && problem_.constraints.vanishes(e.pivot));
  }

  Eliminated minimise(std::size_t i, Component c) {
    for (const Component other : Z_.neighbours(c)) {
      if (!is_dual(other)) continue;
      responses_.try_emplace(other, Response{zero_, zero_, zero_})
          .first->second.add(Z_.entry(c, c), Z_.entry(c, other));
    }
    const Eliminated result = Z_.minimise(c, steps_);
    margins_.push_back({result.pivot, is_clean_ ? zero_ : rounding(i, c)});
    is_clean_ = false;
    ++pivots_;
    return result;
  }

  // Of the sum of all that a pivot is the rest of.
  Expr rounding(std::size_t i, Component c) const {
    Expr sum = zero_;
    if (is_of_link(c)) {
      sum = is_linear(c) ? bounds_[i].mass : greatest_inertia(i);
    } else {
      for (const std::size_t link : own_.uses[c - shared(0)]) sum += bound_along(link, c - shared(0));
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
    return squares * (is_shift(i) ? bounds_[i].mass : greatest_inertia(i));
  }

  // w_i in terms of what is before the link.
  void pass_on(std::size_t i) {
    const Link& link = links_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const bool floats = own_.base_at(i) != nullptr && own_.base_at(i)->along[k];
      if (!by_link() && !floats) continue;
      const Component moved = first_of_joint(i) + k;
      if (Z_.holds(moved)) Z_.displace(moved, motion_.drift(i, steps_)[k]);
      if (link.parent == k_ground) Z_.displace(a(i, k), motion_.fall_at(i)[k]);
    }
    if (is_shift(i)) return shift(i);
    if (link.parent != k_ground) masses_[link.parent] += masses_[i];
    turn(i);
  }

  void add_shared(std::size_t i, std::size_t k, std::vector<LinearTerm>& terms) const {
    for (const Freedom& freedom : links_[i].freedoms) {
      if (is_own(freedom) || freedom.column[k].is_zero()) continue;
      terms.push_back({shared(freedom.speed.value), freedom.column[k]});
    }
  }

  bool is_own(const Freedom& freedom) const { return own_.is_owned[freedom.speed.value] != 0; }

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
      const std::size_t u = freedom.speed.value;
      if (is_own(freedom) || own_.uses[u].front() != i) continue;
      const Component c = shared(u);
      act(c, u, one());
      shared_[i].push_back(minimise(i, c));
      if (has_no_inertia(shared_[i].back())) return false;
    }
    return true;
  }

  // --- multipliers --------------------------------------------------------------------------------------------

  // What is left of Z: -½ λ·S λ + λ·p. At its stationary point S λ = p; the multipliers of (3.4) have the other sign.
  bool factorise_rows() {
    std::vector<std::string> labels;
    for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
      const bool is_gone =
          std::any_of(imposed_.begin(), imposed_.end(), [&](const Imposed& i) { return i.dual == dual(r); });
      if (is_gone) continue;
      left_.push_back(r);
      labels.push_back(rows_.rows[r].name);
    }
    if (left_.empty()) return true;
    Matrix S;
    for (const std::size_t r : left_) {
      S.emplace_back();
      for (const std::size_t other : left_) S.back().push_back(-Z_.entry(dual(r), dual(other)));
    }
    steps_.begin("how the accelerations along the constraints respond: S = L D L^T");
    schur_.emplace(S, labels, problem_.prefix + "S", epsilon_, steps_, Dependent::drop);
    if (!schur_->vanishing().empty()) return false;
    dependent_ = schur_->breakdown(k_lost_in_rows);
    return true;
  }

  /// From what the rows are without the multipliers.
  void solve_rows(const Vector& defect, const std::string& name) {
    const Vector lambda = schur_->solve(defect, problem_.prefix + name, steps_);
    for (std::size_t at = 0; at < left_.size(); ++at) w_[dual(left_[at])] = -lambda[at];
  }

  void find_accelerations() {
    if (schur_) {
      Vector defect;
      for (const std::size_t r : left_) defect.push_back(-Z_.linear(dual(r)));
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
    return std::any_of(left_.begin(), left_.end(), [&](std::size_t r) {
      if (!problem_.constraints.value_of) return true;
      const Response& response = responses_.at(dual(r));
      return !(problem_.constraints.value_of(response.spread()) <= k_widest_range);
    });
  }

  // Correcting once squares the relative error of a solve: as in the multiplier form.
  Expr lost_inertia() {
    std::vector<Expr> conditions;
    for (const std::size_t r : left_) {
      const Response& response = responses_.at(dual(r));
      const Expr inertia =
          steps_.name(response.inertia / response.squares, problem_.prefix + "inertia_" + rows_.rows[r].name);
      const Expr ratio = pow(epsilon_, 2) * inertia * response.compliance;
      conditions.push_back(less(response.squares, Rational(1'000'000) * ratio));
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
    for (const std::size_t r : left_) {
      defect.push_back(-steps_.name(defect_of(r), problem_.prefix + "defect_" + rows_.rows[r].name));
    }
    const Vector rough = w_;
    w_.assign(w_.size(), zero_);
    is_correcting_ = true;
    solve_rows(defect, "correction");
    spread();
    for (std::size_t c = 0; c < w_.size(); ++c) w_[c] = rough[c] + w_[c];
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

  Expr drift_of(const LinkTerm& term) const {
    const auto& [linear, angular] = motion_.accumulated(term.link);
    return dot(term.linear, linear) + dot(term.angular, angular);
  }

  /// The last ones first: their rows have multipliers of later ones in them.
  void find_imposed() {
    for (auto imposed = imposed_.rbegin(); imposed != imposed_.rend(); ++imposed) {
      Expr sum = imposed->linear;
      for (const LinearTerm& term : imposed->row) sum += term.coefficient * w_[term.component];
      w_[imposed->dual] = -(sum / imposed->component.pivot);
    }
  }

  Vector multipliers() {
    steps_.begin("multipliers (3.4)");
    Vector result;
    for (std::size_t mu = 0; mu < rows_.multipliers.size(); ++mu) {
      Expr sum = zero_;
      for (const Share& share : rows_.multipliers[mu]) {
        const Rational unit = rows_.rows[share.row].links.empty() ? per_power_ : per_force_;
        sum -= (1 / unit) * (share.factor * w_[dual(share.row)]);
      }
      const kinematics::ConstraintIndex index{mu};
      const std::string& name = problem_.constraints.kinematics.constraints[index].name;
      result.push_back(steps_.name(sum, problem_.prefix + "lambda_" + name));
    }
    return result;
  }

  // --- from the ground to the leaves --------------------------------------------------------------------------

  Expr at_minimum(const Eliminated& e) const {
    Expr w = is_correcting_ ? zero_ : e.offset;
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
    if (is_shift(i)) linear = linear + cross(alpha_before, link.offset);
    if (falls) moved = moved + motion_.drift(i, steps_);
    const Vector3 given = moved;
    moved = moved + by_shared(i);
    for (std::size_t k = 0; k < 3; ++k) {
      w_[a(i, k)] = linear[k];
      w_[alpha(i, k)] = angular[k];
    }
    name_given(i);
    find_own(i, given);
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
      const Expr w = at_minimum(*e);
      w_[c] = steps_.name(w, name_of_acceleration(c));
      if (floating == nullptr || !is_linear(c)) continue;
      is_said = is_said && is_imposed_.count(c) != 0;
      said[c % 3] = w;
    }
    if (own_.base_at(i) == nullptr) given_[i] = given;
    if (floating == nullptr) return;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!floating->along[k]) continue;
      // What rows say has free fall taken out: then it need not be put in, turned, and taken out again.
      said[k] = is_said && !is_correcting_ ? said[k] - motion_.fall_at(i)[k] : w_[a(i, k)];
    }
    find_base(*floating, said, is_said);
  }

  // Back along the way to the link that floats.
  void find_base(const FloatingBase& floating, Vector3 v, bool is_without_fall) {
    for (std::size_t at = floating.anchor; at != floating.base; at = links_[at].parent) {
      const std::size_t parent = links_[at].parent;
      if (is_shift(at)) {
        v = v - cross(of(alpha(parent, 0)), links_[at].offset);
        if (by_link() && !is_correcting_) v = v - motion_.drift(at, steps_);
      } else {
        v = motion_.turned_back(at, v);
      }
    }
    Vector3 given = ir::zero3(graph_);
    if (!is_correcting_) given = given + motion_.drift(floating.base, steps_);
    if (!is_correcting_ && !is_without_fall) given = given + motion_.fall();
    for (std::size_t k = 0; k < 3; ++k) {
      if (floating.along[k]) w_[a(floating.base, k)] = v[k];
    }
    given_[floating.base] = given;
  }

  // A component is free by the first speed that has it alone; those found later move along it, too, and are known before.
  void find_speeds() {
    for (auto owned = own_.in_order.rbegin(); owned != own_.in_order.rend(); ++owned) {
      const auto& [i, k] = *owned;
      const Freedom& own = *own_.of_joint[i][k].freedom;
      Expr along = w_[first_of_joint(i) + k] - given_[i][k];
      for (const Freedom& other : links_[i].freedoms) {
        if (&other != &own) along -= other.column[k] * w_[shared(other.speed.value)];
      }
      w_[shared(own.speed.value)] = along / own.column[k];
    }
    if (!is_correcting_) find_speeds_of_one_row();
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
    for (const Imposed& imposed : imposed_) rows.require(pow(imposed.component.pivot, 2), zero_);
    const Expr dependent = any(graph_, {dependent_, rows.violated("least_coefficient")});
    const Expr singular = any(graph_, {margins.violated("least_pivot"), lost_});
    return {accelerations, multipliers(), singular, dependent, "", {}, {}, {}, false};
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
  Rational per_power_, per_force_, per_length_;
  LinkRows rows_;
  OwnComponents own_;
  QuadraticForm Z_;
  Vector masses_;                                             ///< at the origins, where they are the same in all axes
  std::vector<std::vector<Eliminated>> eliminated_, shared_;  ///< by link, in order
  std::vector<std::vector<std::size_t>> waiting_;             ///< rows, by link
  std::vector<Imposed> imposed_;
  std::set<Component> is_imposed_;
  Vector w_;                    ///< by component
  std::vector<Vector3> given_;  ///< of links: what their joints do not decide of the components that are moved
  std::vector<std::pair<Expr, Expr>> margins_;
  std::map<Component, Response> responses_;  ///< of multipliers
  std::vector<std::size_t> left_;            ///< rows that were not imposed
  std::optional<Ldl> schur_;
  bool is_correcting_ = false;
  Expr dependent_, lost_;
  bool is_clean_ = true;  ///< nothing was minimised yet, so nothing has cancelled
  std::size_t pivots_ = 0;
};

}  // namespace

std::optional<Solution> solve_tree(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps) {
  return Tree(problem, form, epsilon, steps).run();
}

}  // namespace gaussgen::strategy
