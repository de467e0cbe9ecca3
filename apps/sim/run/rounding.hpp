#pragma once
// What rounding makes of a run: all runs in one number type share that, so tighter ones do not see it.

#include <future>
#include <optional>
#include <string>

#include "sim/run/engines.hpp"
#include "sim/run/error_estimate.hpp"
#include "sim/run/in_rows.hpp"
#include "sim/run/lost_digits.hpp"

namespace gausssim {

struct RoundingError : DeliveredError {
  DeliveredError lost = {};       ///< by rates, outputs or the start, where it is too much beside the errors of the run
  std::string wider = {};         ///< number type that loses far less
  bool is_told_in_wider = false;  ///< by a tighter run there; else of values that differ by their rounding
};

/// Is made beside the run that it looks at. In `float` there is nothing to do: its errors are told in `double`.
class RoundingCheck {
 public:
  /// All of these outlive it.
  RoundingCheck(const PreparedModel& prepared, const Engine& engine, const Setting& setting);

  /// Of the run.
  void note(long sample, long double t, const std::vector<long double>& state) { states_.note(sample, t, state); }

  /// When the run has ended, with an error of `known`: what it differs by from a run whose parameters, inputs and start differ by their rounding, unless that does not arrive. Where formulas and equations lose so many digits that more may come of it: what it differs by from a tighter run
  /// in a wider number type that does not, interpreted for a short time and then compiled for `most_seconds`; if it does not arrive, what is lost at least.
  RoundingError error_of(const Simulated& run, const Rows& rows, const Yardstick& yardstick, double known,
                         Engines& engines, double most_seconds);

  /// Of a run that nothing is compared with: what its rates, outputs or start lose, if that is more than its tolerance.
  DeliveredError lost_in(const Rows& rows) const;

 private:
  std::string wider_than(const LostDigits& digits, double lost) const;
  struct WideRows {
    Rows rows;
    double tolerance;
  };

  /// Of a tighter run there. Nothing: it does not get as far as the run.
  std::optional<WideRows> rows_in(const std::string& wider, double lost, double known, Engines& engines,
                                  const Simulated& run, double most_seconds) const;
  /// What the run takes for constant may move there.
  DeliveredError by_wider(const Rows& rows, const WideRows& wide, const Yardstick& yardstick) const;

  const PreparedModel& prepared_;
  const Engine& engine_;
  const Setting& setting_;
  std::future<RunInRows> nudged_;
  PassedStates states_;
};

}  // namespace gausssim
