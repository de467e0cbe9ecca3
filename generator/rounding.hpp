#pragma once
// What rounding does to a solution of the equations of motion, to tell one that loses digits from one that does not.

#include <vector>

#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// At states where a tree is hardest on numbers, with the parameters of the model: each angle near a multiple of a right angle, where
/// axes and links are nearly aligned; speeds up to 1. Constraints on positions need not hold there, as accelerations follow from linear
/// equations at any state.
class Rounding {
 public:
  explicit Rounding(Mechanics& mechanics);

  /// The largest difference between accelerations and multipliers in double and in long double, of the largest one that is measured
  /// in the same unit; 0 where they have no values.
  double operator()(const strategy::Solution& solution);

 private:
  struct State {
    evaluate::Evaluator<double> rounded;
    evaluate::Evaluator<long double> precise;
  };

  State state(std::uint32_t number);
  void bind_parameters_of(State& state);

  Mechanics& mechanics_;
  std::vector<State> states_;
};

}  // namespace gaussgen
