#include "strategy/tree_motion.hpp"

#include <map>

namespace gaussgen::strategy {

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

}  // namespace gaussgen::strategy
