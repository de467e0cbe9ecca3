#pragma once
// x' = A x + B u near a motion, over independent coordinates and speeds, with its modes: `gauss-gen linearize`.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/modes.hpp"
#include "reduction.hpp"

namespace gaussgen {

/// Near which motion.
enum class LinearisedAt { initial, equilibrium, steady };

/// A coordinate (or a small turn of an orientation about one of its axes) or a speed.
struct LinearState {
  std::string name;
  std::string unit;
  bool is_coordinate = false;
  std::size_t index = 0;     ///< among displacements, then speeds
  analysis::Real value = 0;  ///< of a turn 0: it is counted from where it is
  analysis::Real rate = 0;
};

struct Linearisation {
  std::string failure;  ///< why there is none; else empty
  std::vector<LinearState> states;
  std::vector<std::string> inputs;
  std::vector<std::string> dependent;  ///< coordinates and speeds that constraints give
  analysis::Matrix A, B;
  std::vector<analysis::Mode> modes;
  std::vector<std::size_t> cyclic;    ///< of `states`: coordinates on which nothing else depends
  std::vector<std::size_t> changing;  ///< of `states`: what is not constant, as in steady motion it is
  bool is_at_rest = false;            ///< and no coordinate moves
  std::vector<std::string> doubts;    ///< as of an Evaluation
  std::vector<std::string> warnings;

  bool is_steady() const { return changing.empty(); }
};

struct LinearisationOptions {
  Preferences preferences;  ///< of the model as it was read: at an equilibrium that was found everything is stated
  LinearisedAt at = LinearisedAt::initial;
  support::Rational time = 0;
  std::set<std::string>
      fixed;  ///< coordinates, speeds, components of quaternions: a search for steady motion leaves them
};

/// At the initial state of `mechanics.model`, which an equilibrium has been put into before, or at a steady motion near it.
Linearisation linearise(Mechanics& mechanics, const LinearisationOptions& options);

}  // namespace gaussgen
