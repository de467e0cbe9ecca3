#pragma once

#include <random>

namespace gaussgen {

/// Numbers without a pattern that a model could have, from -1 to 1; the same ones in every run.
class RepeatedNumbers {
 public:
  static constexpr std::mt19937::result_type k_usual_seed = 20'26;

  explicit RepeatedNumbers(std::mt19937::result_type seed = k_usual_seed) : engine_(seed) {}

  double operator()() { return static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max()) * 2 - 1; }

 private:
  std::mt19937 engine_;
};

}  // namespace gaussgen
