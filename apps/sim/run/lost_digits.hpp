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

/// What a number type loses: the largest difference from a wider one of any rate, relative to the largest one of that component, of an output, relative to its scale, or of the start, relative to the range of the component. Of
/// a component that rests, relative to what has its unit. `output` may be a component of the state.
struct Lost : DeliveredError {
  double in_time = 0;  ///< what differences of rates that have one sign make of a component, in parts of its range
};

class LostDigits {
 public:
  /// Of states of a run. All of these outlive it.
  LostDigits(const PreparedModel& prepared, const Engine& engine, const Setting& setting, const PassedStates& states,
             const Yardstick& yardstick);

  /// `double` or `long-double`. Both may lose all of what is less than either can tell, so some states are looked at in `float128`, which takes as long as some thousand operations.
  Lost in(const std::string& number) const;

 private:
  /// Of the states, one out of so many: rates of all of them take about as many operations.
  std::size_t stride_for(double operations) const;

  const PreparedModel& prepared_;
  const Engine& engine_;
  const PassedStates& states_;
  const Yardstick& yardstick_;
  double resolved_;  ///< of sizes
};

/// A run whose samples are close enough to tell what happens between those of the table; it takes some seconds at most, however far it gets then.
struct Passage {
  PassedStates states;
  Rows rows;
};
constexpr long k_close_samples = 129;
Passage passage(const PreparedModel& prepared, const Engine& engine, const Setting& setting, double seconds);

/// Of rows that nothing is compared with, beside their own ranges.
Yardstick of_themselves(const Rows& rows, const PreparedModel& prepared, const Setting& setting);

}  // namespace gausssim
