#include "strategy/tree_z.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "strategy/axes.hpp"
#include "strategy/fixed_turns.hpp"
#include "strategy/link_axes.hpp"
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

}  // namespace

void Response::add(Expr pivot, Expr coefficient) {
  const Expr square = pow(coefficient, 2);
  squares += square;
  compliance += square / pivot;
  inertia += square * pivot;
}

TreeZ::TreeZ(const TreeProblem& problem, const TreeForm& form, Expr epsilon, Steps& steps)
    : problem_(problem),
      form_(form),
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
      Z_(graph_, first_dual() + most_rows(problem), first_dual(),
         [this](Component i, Component j, bool is_linear) { return is_linear ? name_of(i) : name_of(i, j); }),
      masses_(links_.size(), zero_),
      eliminated_(links_.size()),
      shared_(links_.size()) {
  for (const Link& link : links_) carriers_.push_back(link.parent);
  find_spins(properties_, linkage_);
  children_ = children_of(links_);
  for (const MassProperties& own : properties_) bounds_.push_back(MassBound::of(own));
  moved_ = move_masses_to_ends(links_, properties_);
}

bool TreeZ::minimise() {
  const LinkRowBuilder builder(problem_.constraints, linkage_);
  motion_.find_velocities(steps_);
  rows_ = builder.rows(motion_, steps_);
  own_ = own_components(links_, properties_, acted_on(), rows_.released);
  if (mixes_speeds()) own_ = own_components(links_, properties_, acted_on(), rows_.released);
  const auto& uses = own_.uses;
  if (std::any_of(uses.begin(), uses.end(), [](const auto& links) { return links.empty(); })) return false;
  place_rows();
  place_loops();
  place_loads();
  find_bare_links();
  if (!by_link()) {
    const auto floats = [this](std::size_t i, std::size_t k) {
      return own_.base_at(i) != nullptr && own_.base_at(i)->along[k];
    };
    motion_.accumulate(floats, steps_);
  }
  for (std::size_t i = links_.size(); i-- > 0;) {
    if (!inward(i)) return false;
  }
  return true;
}

// Speeds that move more than their turn, as where a place depends on the attitude, are no components of it: each of them moves all three.
bool TreeZ::mixes_speeds() {
  bool any_mixed = false;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Link& link = links_[i];
    const auto is_owned = [](const OwnComponent& own) { return own.freedom != nullptr; };
    if (!link.to_speeds || std::all_of(own_.of_joint[i].begin(), own_.of_joint[i].end(), is_owned)) continue;
    mix_speeds(link);
    any_mixed = true;
  }
  return any_mixed;
}

Linkage TreeZ::prepared(const Linkage& linkage, const TreeForm& form) {
  Linkage result = in_units(linkage, form.length, form.mass);
  if (form.chooses_axes) choose_axes(result);
  return result;
}

std::size_t TreeZ::most_rows(const TreeProblem& problem) {
  return problem.constraints.kinematics.constraints.size() + problem.constraints.kinematics.idle_slips.size();
}

// Blocks of Z as mechanics names them: mass M, moments of inertia I, and H between them; forces F, moments N; b for rows of
// constraints.
std::string TreeZ::axis_of(Component c) const {
  if (is_dual(c)) return rows_.rows[c - first_dual()].name;
  if (!is_of_link(c)) return problem_.symbols.speeds[kinematics::FreeIndex{c - shared(0)}].label;
  return links_[c / 6].name + "_" + std::string(1, k_axes[c % 3]);
}

std::string TreeZ::name_of(Component c) const {
  const char* const kind = is_dual(c) ? "drift_" : !is_of_link(c) ? "Q_" : is_linear(c) ? "F_" : "N_";
  return problem_.prefix + kind + axis_of(c);
}

std::string TreeZ::name_of(Component i, Component j) const {
  if (is_of_link(j)) {
    const char* const mass = postponed_.count(i / 6) != 0 ? "MI_" : "M_";
    const char* const block = is_linear(i) == is_linear(j) ? (is_linear(i) ? mass : "I_") : "H_";
    return problem_.prefix + block + axis_of(i) + k_axes[j % 3];
  }
  const char* const block = !is_dual(j) ? "Z_" : !is_dual(i) ? "b_" : "S_";
  const char* const which = is_linear(i) ? "a_" : is_of_link(i) ? "alpha_" : "";
  return problem_.prefix + block + (is_dual(j) ? which : "") + axis_of(i) + "_" + axis_of(j);
}

std::vector<char> TreeZ::acted_on() const {
  std::vector<char> result;
  for (const Expr Q : problem_.forces) result.push_back(Q.is_zero() ? 0 : 1);
  for (const LinkRow& row : rows_.rows) {
    for (const SpeedTerm& term : row.speeds) result[term.speed] = 1;
  }
  return result;
}

// A row waits at the last link that carries all it acts on: from there on it is complete.
void TreeZ::place_rows() {
  waiting_.resize(links_.size());
  terms_of_.resize(links_.size());
  for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
    const LinkRow& row = rows_.rows[r];
    Z_.add(dual(r), row.rest);
    if (row.links.empty()) continue;
    std::size_t top = row.links[0].link;
    for (const LinkTerm& term : row.links) {
      top = common_carrier(links_, top, term.link);
      terms_of_[term.link].push_back({r, &term});
    }
    if (top != k_ground) waiting_[top].push_back(r);
  }
}

// A force at a place acts along every speed that moves the place; on the link that carries it, it is two vectors.
void TreeZ::place_loads() {
  if (!form_.puts_loads_on_links) return;
  steps_.begin("forces and moments on links, in their axes");
  LinkAxes axes(links_, graph_);
  for (const kinematics::Part& part : linkage_.parts) {
    const kinematics::BodyLoad& load = problem_.loads[part.body];
    if (is_zero(load.force) && is_zero(load.moment)) continue;
    const ir::Matrix3 inward = transposed(axes.of(part.link, steps_));
    const Vector3 force = scaled(per_force_, ir::multiply(inward, load.force));
    const Vector3 moment =
        scaled(per_force_ * per_length_, ir::multiply(inward, load.moment)) + cross(part.centre, force);
    const auto [known, is_new] = loads_.try_emplace(part.link, Load{force, moment});
    if (!is_new) known->second = {known->second.force + force, known->second.moment + moment};
  }
  for (auto& [link, load] : loads_) {
    load.force = steps_.name(load.force, problem_.prefix + "F_on_" + links_[link].name);
    load.moment = steps_.name(load.moment, problem_.prefix + "N_on_" + links_[link].name);
  }
}

// Where a particle was whose mass went elsewhere, and no row acts.
void TreeZ::find_bare_links() {
  is_bare_.assign(links_.size(), 0);
  for (std::size_t i = links_.size(); i-- > 0;) {
    const auto& children = children_[i];
    is_bare_[i] = static_cast<char>(
        links_[i].freedoms.empty() && has_nothing(properties_[i]) && terms_of_[i].empty() && loads_.count(i) == 0 &&
        std::all_of(children.begin(), children.end(), [this](std::size_t child) { return is_bare_[child] != 0; }));
  }
}

void TreeZ::add_rows(std::size_t i) {
  for (const auto& [row, term] : terms_of_[i]) add_term(*term, row);
}

void TreeZ::add_term(const LinkTerm& term, std::size_t r) {
  const std::size_t i = term.link;
  for (std::size_t k = 0; k < 3; ++k) {
    Z_.add(a(i, k), dual(r), term.linear[k]);
    Z_.add(alpha(i, k), dual(r), term.angular[k]);
  }
  if (!by_link()) Z_.add(dual(r), drift_of(term));
}

// What acts along a speed, on a component of which du/dt has `per` as its part.
void TreeZ::act(Component c, std::size_t speed, Expr per) {
  Z_.add(c, -(force(speed) * per));
  for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
    for (const SpeedTerm& term : rows_.rows[r].speeds) {
      if (term.speed == speed) Z_.add(c, dual(r), term.coefficient * per);
    }
  }
}

// Where a number stands before a component that is free, the row says what this component is, without a division.
void TreeZ::impose_rows(std::size_t i, std::vector<Component>& free) {
  std::vector<std::size_t> rest;
  for (const std::size_t r : waiting_[i]) {
    const std::optional<std::size_t> best = safest(r, free);
    if (!best) {
      rest.push_back(r);
      continue;
    }
    const Component c = free[*best];
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(*best));
    row_margins_.push_back({pow(Z_.entry(dual(r), c), 2), zero_});
    add_bounds(r, c);
    Z_.name({dual(r)}, steps_);
    Z_.add(dual(r),
           -rows_.rows[r].fall);  // apart, so that it cancels where free fall is taken out of what the row says
    imposed_.push_back(Z_.impose(c, dual(r), steps_));
    is_imposed_.insert(c);
    eliminated_[i].push_back(imposed_.back().component);
  }
  const std::size_t parent = links_[i].parent;
  if (parent != k_ground) waiting_[parent].insert(waiting_[parent].end(), rest.begin(), rest.end());
}

std::optional<std::size_t> TreeZ::safest(std::size_t r, const std::vector<Component>& free) const {
  if (!Z_.entry(dual(r), dual(r)).is_zero()) return std::nullopt;
  std::optional<std::size_t> best;
  for (std::size_t at = 0; at < free.size(); ++at) {
    const Expr pivot = Z_.entry(dual(r), free[at]);
    if (safety(pivot) == Safety::unknown || drowns_others(r, free[at])) continue;
    if (!best || safety(pivot) < safety(Z_.entry(dual(r), free[*best]))) best = at;
  }
  return best;
}

Expr TreeZ::largest(Component c) const {
  const MassBound& bound = bounds_[c / 6];
  return is_linear(c) ? bound.mass : bound.inertia.along(c % 3);
}

// w_c = -Σ f_j w_j: ½ P_cc w_c² becomes ½ P_cc f_j² w_j² and more.
std::vector<std::pair<Component, Addition>> TreeZ::additions(std::size_t r, Component c) const {
  std::vector<std::pair<Component, Addition>> result;
  for (const Component j : Z_.neighbours(dual(r))) {
    if (j == c || !is_of_link(j)) continue;
    const std::optional<Expr> entry = bound_of(Z_.entry(dual(r), j));
    if (entry) result.push_back({j, {largest(c) * pow(*entry / Z_.entry(dual(r), c), 2), largest(j)}});
  }
  return result;
}

// Of what was there before, rounding leaves nothing beside something so much larger.
bool TreeZ::drowns_others(std::size_t r, Component c) const {
  const auto all = additions(r, c);
  return std::any_of(all.begin(), all.end(),
                     [this](const auto& each) { return each.second.drowns(problem_.constraints.estimate); });
}

// For parameters that change after the choice was made: half of the digits have to be left.
void TreeZ::add_bounds(std::size_t r, Component c) {
  const bool by_number = safety(Z_.entry(dual(r), c)) == Safety::number;
  for (const auto& [to, addition] : additions(r, c)) {
    const bool is_fixed = ir::is_of_parameters(graph_, addition.added.id());
    if (!addition.is_known() && (is_fixed || !by_number))
      row_margins_.push_back({addition.before, addition.least(epsilon_)});
    if (!is_fixed) continue;
    MassBound& bound = bounds_[to / 6];
    if (is_linear(to)) {
      bound.mass += addition.added;
    } else {
      bound.inertia.add(to % 3, addition.added);
    }
  }
}

void TreeZ::add_body(std::size_t i) {
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
  if (problem_.disturbance != nullptr) {
    force = force + problem_.disturbance->force[i];
    moment = moment + problem_.disturbance->moment[i];
  }
  if (const auto load = loads_.find(i); load != loads_.end()) {
    force = force - load->second.force;
    moment = moment - load->second.moment;
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
void TreeZ::add_mass(std::size_t i) {
  const std::optional<std::size_t> axis = divide_block(i);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!axis || k == *axis) Z_.add(a(i, k), a(i, k), masses_[i]);
    if (!by_link()) Z_.add(a(i, k), masses_[i] * motion_.accumulated(i).linear[k]);
  }
  masses_[i] = zero_;
}

std::vector<Component> TreeZ::components(std::size_t i) const {
  std::vector<Component> all;
  for (std::size_t k = 0; k < 6; ++k) all.push_back(6 * i + k);
  return all;
}

std::vector<Component> TreeZ::own_of_joint(std::size_t i) const {
  std::vector<Component> result;
  for (std::size_t k = 0; k < 3; ++k) {
    if (own_.of_joint[i][k].is_free && own_.base_at(i) == nullptr) result.push_back(first_of_joint(i) + k);
  }
  return result;
}

bool TreeZ::inward(std::size_t i) {
  steps_.begin("Z of all that " + links_[i].name + " carries, at its minimum over the own acceleration of " +
               links_[i].name);
  const FloatingBase* const floating = own_.base_anchored_at(i);
  add_body(i);
  if (is_shift(i) || floating != nullptr) add_mass(i);
  add_rows(i);
  if (!close_loops(i)) return false;
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
void TreeZ::act_on(std::size_t i, int factor) {
  if (factor > 0 && own_.base_at(i) != nullptr) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const OwnComponent& own = own_.of_joint[i][k];
    if (own.freedom == nullptr) continue;
    const Component c = first_of_joint(i) + k;
    if (!links_[i].to_speeds) {
      act(c, own.freedom->speed.value, Rational(factor) * pow(own.freedom->column[k], -1));
      continue;
    }
    for (std::size_t j = 0; j < 3; ++j)
      act(c, links_[i].freedoms[j].speed.value, Rational(factor) * (*links_[i].to_speeds)[j][k]);
  }
}

std::vector<Component> TreeZ::free_to_float(const FloatingBase& floating) {
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
bool TreeZ::has_no_inertia(const Eliminated& e) const {
  return e.pivot.is_zero() || (!rows_.rows.empty() && problem_.constraints.vanishes(e.pivot));
}

Eliminated TreeZ::minimise(std::size_t i, Component c) {
  for (const Component other : Z_.neighbours(c)) {
    if (!is_dual(other)) continue;
    responses_.try_emplace(other, Response{zero_, zero_, zero_}).first->second.add(Z_.entry(c, c), Z_.entry(c, other));
  }
  ++pivots_;
  if (const std::optional<Bar> bar = bar_at(i, c)) return minimise_bar(i, c, *bar);
  const Eliminated result = Z_.minimise(c, steps_);
  margins_.push_back({result.pivot, is_clean_ ? rounding_of_sum(result.pivot) : trusted(c)});
  is_clean_ = false;
  return result;
}

// Nothing was minimised yet, but a difference of parameters can be nothing but rounding.
Expr TreeZ::rounding_of_sum(Expr pivot) const {
  if (!ir::is_of_parameters(graph_, pivot.id())) return zero_;
  const ir::Node* node = &graph_[pivot.id()];
  while (node->kind == ir::Kind::named) node = &graph_[node->children[0]];
  const auto is_negative = [](const Rational& coefficient) { return coefficient < 0; };
  if (std::none_of(node->coefficients.begin(), node->coefficients.end(), is_negative)) return zero_;
  Expr sum(graph_, graph_.constant(cln::abs(node->value)));
  for (std::size_t at = 0; at < node->children.size(); ++at) {
    sum += cln::abs(node->coefficients[at]) * call(ir::Function::abs, Expr(graph_, node->children[at]));
  }
  return Rational(4) * epsilon_ * sum;
}

// Of the sum of all that a pivot is the rest of.
Expr TreeZ::trusted(Component c) const {
  Expr sum = zero_;
  if (is_of_link(c)) {
    sum = largest(c);
  } else {
    for (const std::size_t link : own_.uses[c - shared(0)]) sum += bound_along(link, c - shared(0));
  }
  return trusted_part(static_cast<int>(pivots_), epsilon_) * sum;
}

Expr TreeZ::bound_along(std::size_t i, std::size_t speed) const {
  Expr squares = zero_;
  for (const Freedom& freedom : links_[i].freedoms) {
    if (freedom.speed.value == speed) squares += ir::dot(freedom.column, freedom.column);
  }
  return squares * (is_shift(i) ? bounds_[i].mass : bounds_[i].inertia.sum());
}

// Own components over which Z was minimised are left to themselves.
void TreeZ::pass_bounds(std::size_t i) {
  if (links_[i].parent == k_ground) return;
  MassBound bound = bounds_[i];
  for (const Eliminated& e : eliminated_[i]) {
    if (!is_linear(e.component)) bound.minimise(e.component % 3);
  }
  bounds_[links_[i].parent].add(passed_on(links_[i], bound));
}

// w_i in terms of what is before the link.
void TreeZ::pass_on(std::size_t i) {
  const Link& link = links_[i];
  pass_bounds(i);
  for (std::size_t k = 0; k < 3; ++k) {
    const bool floats = own_.base_at(i) != nullptr && own_.base_at(i)->along[k];
    if (!by_link() && !floats) continue;
    const Component moved = first_of_joint(i) + k;
    if (Z_.holds(moved)) Z_.displace(moved, motion_.drift(i, steps_)[k]);
    if (link.parent == k_ground) Z_.displace(a(i, k), motion_.fall_at(i)[k]);
  }
  if (is_shift(i)) return shift(i);
  disturb_origin(i);
  if (link.parent != k_ground) masses_[link.parent] += masses_[i];
  turn(i);
}

void TreeZ::disturb_origin(std::size_t i) {
  if (problem_.disturbance == nullptr) return;
  for (std::size_t k = 0; k < 3; ++k) {  // where a base floats, nothing is left along these components
    const Expr by = problem_.disturbance->linear[i][k];
    Z_.displace(a(i, k), by);
    Z_.add(a(i, k), masses_[i] * by);
  }
}

void TreeZ::add_shared(std::size_t i, std::size_t k, std::vector<LinearTerm>& terms) const {
  for (const Freedom& freedom : links_[i].freedoms) {
    if (is_own(freedom) || freedom.column[k].is_zero()) continue;
    terms.push_back({shared(freedom.speed.value), freedom.column[k]});
  }
}

void TreeZ::shift(std::size_t i) {
  const Link& link = links_[i];
  const std::size_t parent = link.parent;
  if (form_.postpones) remember_end(i);
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

void TreeZ::turn(std::size_t i) {
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
  pass_block(i);
}

void TreeZ::turn_freely(const Link& link, Component from, Component to) {
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
bool TreeZ::minimise_shared(std::size_t i) {
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

Expr TreeZ::drift_of(const LinkTerm& term) const {
  const auto& [linear, angular] = motion_.accumulated(term.link);
  return dot(term.linear, linear) + dot(term.angular, angular);
}

}  // namespace gaussgen::strategy
