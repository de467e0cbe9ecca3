#pragma once
// Functions of a solution that somebody else has found.

#include "mechanics.hpp"

namespace gaussgen {

/// While it lasts, accelerations and multipliers of `mechanics` are those that a caller of emitted code hands over: symbols.
class GivenSolution {
 public:
  explicit GivenSolution(Mechanics& mechanics);
  ~GivenSolution();
  GivenSolution(const GivenSolution&) = delete;
  GivenSolution& operator=(const GivenSolution&) = delete;

 private:
  Mechanics& mechanics_;
  strategy::Solution solution_;
  strategy::Vector held_reactions_;
};

}  // namespace gaussgen
