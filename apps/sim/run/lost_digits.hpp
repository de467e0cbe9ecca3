#pragma once
// What the functions of a model round: the same states, in two number types.

#include <string>
#include <vector>

#include "sim/run/error_estimate.hpp"

namespace gausssim {

/// Some of a run's, from its start to its end.
class PassedStates {
 public:
  struct One {
    long double t;
    std::vector<long double> state;
  };

  explicit PassedStates(long samples);

  void note(long sample, long double t, const std::vector<long double>& state);
  const std::vector<One>& all() const { return states_; }

 private:
  long every_;  ///< of these samples is one of them
  std::vector<One> states_;
};

/// Empty: there is none that the functions of a model are run in by interpreters.
std::string wider_than(const std::string& number);

/// By how much rates, outputs and the start in a number type differ from those in the next wider one, which there is: the largest difference of any of them, relative to the largest rate of that component, the scale of the
/// output, or the range of the component. Of a component that rests, relative to what has its unit. Its `output` is a component of the state, too.
DeliveredError lost_digits(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                           const PassedStates& states, const Yardstick& yardstick);

}  // namespace gausssim
