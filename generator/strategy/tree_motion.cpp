#include "strategy/tree_motion.hpp"

#include <algorithm>
#include <map>

namespace gaussgen::strategy {

namespace {

constexpr std::size_t k_few_speeds = 6;

}  // namespace

using kinematics::Freedom;
using kinematics::Link;

std::vector<std::optional<SoleFreedom>> sole_freedoms(const std::vector<Link>& links) {
  std::map<std::size_t, int> uses;
  for (const Link& link : links) {
    for (const Freedom& freedom : link.freedoms) ++uses[freedom.speed.value];
  }
  std::vector<std::optional<SoleFreedom>> result;
  for (const Link& link : links) {
    result.emplace_back();
    if (link.kind != Link::Kind::turn || link.freedoms.size() != 1) continue;
    const Freedom& freedom = link.freedoms[0];
    const ir::Expr factor = freedom.column[link.axis];
    const bool is_number = factor.graph()[factor.id()].kind == ir::Kind::constant;
    if (is_number && uses.at(freedom.speed.value) == 1) result.back() = SoleFreedom{freedom.speed.value, factor};
  }
  return result;
}

bool are_moved_by_few_speeds(const TreeMotion& motion) {
  const std::vector<kinematics::Link>& links = motion.linkage.links;
  std::vector<std::size_t> count;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::size_t before = motion.carriers[i];
    count.push_back(links[i].freedoms.size() + (before == kinematics::k_ground ? 0 : count[before]));
  }
  return std::all_of(motion.linkage.parts.begin(), motion.linkage.parts.end(),
                     [&](const kinematics::Part& part) { return count[part.link] <= k_few_speeds; });
}

}  // namespace gaussgen::strategy
