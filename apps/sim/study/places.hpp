#pragma once
// Places and forces of a motion as vectors.

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "sim/study/motion.hpp"

namespace gausssim {

inline Eigen::Vector3d vector_of(const Place& place) { return {place[0], place[1], place[2]}; }

inline double largest_of(const std::vector<Place>& vectors) {
  double most = 0;
  for (const Place& one : vectors) most = std::max(most, vector_of(one).norm());
  return most;
}

}  // namespace gausssim
