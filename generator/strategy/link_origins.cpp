#include "strategy/link_origins.hpp"

#include "ir/contract.hpp"

namespace gaussgen::strategy {

LinkOrigins::LinkOrigins(const TreeMotion& motion, ir::Graph& graph, Steps& steps)
    : motion_(motion), steps_(steps), axes_(motion.linkage.links, graph), in_space_(motion.linkage.links.size()) {}

const ir::Vector3& LinkOrigins::acceleration(std::size_t link) {
  const std::size_t at = motion_.origins[link];
  if (at == kinematics::k_ground) return motion_.fall;
  if (!in_space_[at]) {
    const ir::Vector3 a = ir::multiply(axes(at), motion_.accelerations[at].linear);
    in_space_[at] = steps_.name(a, "a_space_" + motion_.linkage.links[at].name);
  }
  return *in_space_[at];
}

}  // namespace gaussgen::strategy
