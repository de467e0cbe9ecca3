#pragma once
// Which number types have the digits for an error at all.

#include <string>

#include "sim/run/engines.hpp"

namespace gausssim {

/// What formulas and equations lose to rounding along a motion.
class Loss {
 public:
  /// In `double`, of a loose run that takes a second at most, however far that gets. Nothing is known where the scene names more digits.
  Loss(const PreparedModel& prepared, Engines& engines, double error);

  /// Whether the rounding of `double` or of a wider number type is more than `part`, relative to what rates and outputs range over.
  bool is_above(double part, const std::string& number) const;

 private:
  double in_double_ = 0, in_long_double_ = 0;
};

}  // namespace gausssim
