#include "strategy/massed_links.hpp"

#include "strategy/spins.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::k_ground;
using kinematics::Link;

MassedLinks::MassedLinks(const kinematics::Linkage& linkage, ir::Graph& graph)
    : linkage_(with_mixed_speeds(linkage)), properties_(mass_properties(linkage_, graph)) {
  find_spins(properties_, linkage_);
  (void)move_masses_to_ends(linkage_.links, properties_);
  const Expr none(graph, graph.constant(0));
  at_origin_.assign(properties_.size(), none);
  for (std::size_t i = 0; i < properties_.size(); ++i) {
    std::size_t first = i;
    while (linkage_.links[first].kind != Link::Kind::shift && linkage_.links[first].parent != k_ground)
      first = linkage_.links[first].parent;
    at_origin_[first] += properties_[i].mass;
    properties_[i].mass = none;
  }
}

}  // namespace gaussgen::strategy
