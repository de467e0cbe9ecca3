#include <algorithm>

#include "ir/traverse.hpp"
#include "strategy/axes.hpp"
#include "strategy/tree_z.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::k_ground;

namespace {

/// The links of which a speed is a component; none where it moves others, too.
std::vector<std::size_t> owners_of(const std::vector<kinematics::Link>& links, const OwnComponents& own,
                                   std::size_t speeds) {
  std::vector<std::size_t> owners(speeds, k_ground);
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const OwnComponent& component : own.of_joint[i]) {
      if (component.freedom == nullptr) continue;
      owners[component.freedom->speed.value] = i;
      if (!links[i].to_speeds) continue;
      for (const kinematics::Freedom& freedom : links[i].freedoms) owners[freedom.speed.value] = i;
    }
  }
  return owners;
}

}  // namespace

// A row over speeds is about what the links of these speeds do against each other: what carries all of them is carried along.
void TreeZ::place_loops() {
  closing_.resize(links_.size());
  is_closed_.assign(rows_.rows.size(), 0);
  const std::vector<std::size_t> owners = owners_of(links_, own_, problem_.forces.size());
  for (std::size_t r = 0; r < rows_.rows.size(); ++r) {
    const LinkRow& row = rows_.rows[r];
    if (!row.links.empty() || row.speeds.empty()) continue;
    std::optional<std::size_t> carrier;
    for (const SpeedTerm& term : row.speeds) {
      const std::size_t owner = owners[term.speed];
      const std::size_t before = owner == k_ground ? k_ground : links_[owner].parent;
      carrier = !carrier ? before : common_carrier(links_, *carrier, before);
    }
    if (*carrier != k_ground) closing_[*carrier].push_back(r);
  }
}

/// Of the rows that wait here, those that nothing couples to others: what S has of them is complete.
std::vector<std::size_t> TreeZ::closing_at(std::size_t i) const {
  std::vector<std::size_t> rows = closing_[i];
  const auto is_coupled = [&](std::size_t r) {
    const std::vector<Component> beside = Z_.neighbours(dual(r));
    return std::any_of(beside.begin(), beside.end(), [&](Component c) {
      return is_dual(c) && std::find(rows.begin(), rows.end(), c - first_dual()) == rows.end();
    });
  };
  for (auto coupled = rows.begin(); coupled != rows.end();) {
    coupled = std::find_if(rows.begin(), rows.end(), is_coupled);
    if (coupled != rows.end()) rows.erase(coupled);
  }
  return rows;
}

// Z less λ times the rows is stationary over λ. Rows that change with nothing before this link say so much of what it carries that S is
// regular here where it is at the ground: from here on the link is heavier, and nothing of the loop is passed on.
bool TreeZ::close_loops(std::size_t i) {
  if (closing_[i].empty()) return true;
  const std::vector<std::size_t> rows = closing_at(i);
  const std::size_t parent = links_[i].parent;
  for (const std::size_t r : closing_[i]) {
    const bool is_left = std::find(rows.begin(), rows.end(), r) == rows.end();
    if (is_left && parent != k_ground) closing_[parent].push_back(r);
  }
  if (rows.empty()) return true;
  steps_.begin("how the accelerations along the constraints respond on " + links_[i].name + ", where loops close");
  for (const std::size_t r : rows) Z_.name({dual(r)}, steps_);
  Vector diagonal;
  for (const std::size_t r : rows) diagonal.push_back(-Z_.entry(dual(r), dual(r)));
  ClosedLoop& loop = loops_[i];
  loop.rows = rows;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    if (!resolve(loop, at, diagonal[at])) return false;
  }
  return true;
}

// A pivot of S = L D Lᵀ, as in Ldl; what comes with it are the factors of what stays.
bool TreeZ::resolve(ClosedLoop& loop, std::size_t at, Expr diagonal) {
  const std::size_t r = loop.rows[at];
  const std::string& name = rows_.rows[r].name;
  Z_.name({dual(r)}, steps_);
  const Expr entry = -Z_.entry(dual(r), dual(r));
  if (entry.is_zero()) return false;
  const bool is_original = entry == diagonal;
  const Expr pivot = steps_.name(entry, problem_.prefix + "S_pivot_" + name);
  const Expr unit = is_original ? zero_ : ir::Rational(static_cast<int>(loop.rows.size())) * epsilon_ * diagonal;
  const Expr kept = is_original ? least_response(pivot, epsilon_)
                                : kept_by_rows(epsilon_) * diagonal + problem_.least_response * diagonal;
  loop_margins_.push_back({pivot, kept});
  const bool is_fixed = is_original && ir::is_of_parameters(graph_, pivot.id());
  const Expr inverse = pow(pivot, -1);
  loop.inverses.push_back(is_fixed ? inverse
                                   : select(at_most(pivot, ir::Rational(k_lost_to_rounding) * unit), zero_, inverse));
  loop.multipliers.push_back(Z_.resolve(dual(r), loop.inverses.back(), problem_.prefix + "S_factor_" + name));
  is_closed_[r] = 1;
  return true;
}

}  // namespace gaussgen::strategy
