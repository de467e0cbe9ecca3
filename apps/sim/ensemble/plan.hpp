#pragma once
// The values of each trajectory: a function of the seed, its number and the name of the quantity, and of nothing else.

#include <cstdint>
#include <vector>

#include "sim/scene/ensemble.hpp"

namespace gausssim {

class Plan {
 public:
  explicit Plan(const Ensemble& ensemble);

  long count() const { return count_; }
  const std::vector<Varied>& varied() const { return varied_; }

  /// One value for each of `varied`. The last sweep changes fastest, and draws repeat behind the last point of all sweeps: a plan with more of them goes on where
  /// one with fewer ends.
  std::vector<double> values(long trajectory) const;

 private:
  double value(std::size_t which, long trajectory) const;

  std::vector<Varied> varied_;
  std::vector<long> stride_;          ///< of points of a sweep: trajectories until its next point
  std::vector<std::uint64_t> words_;  ///< of a draw: what its name is for the generator
  std::uint64_t seed_ = 0;
  long count_ = 1;
};

/// A value in the middle.
double nominal(const Distribution& distribution);

/// At two numbers of the generator, from 0 to below 1.
double drawn(const Distribution& distribution, double first, double second);

}  // namespace gausssim
