#pragma once
// What a run knows of its errors: by tighter runs, by the reference of a search, by closed forms.

#include <optional>
#include <string>
#include <vector>

#include "sim/run/closed_form.hpp"
#include "sim/run/engines.hpp"
#include "sim/run/error_estimate.hpp"
#include "sim/run/rounding.hpp"
#include "sim/run/tighter_runs.hpp"

namespace gausssim {

/// How far a run may be off.
struct Estimate : DeliveredError {
  std::vector<std::string> constants = {};  ///< outputs that have no range that this is a part of
  std::optional<DeliveredError> agreement =
      std::nullopt;  ///< of the tighter runs that say so; nothing where there is one of them

  RoundingError rounding = {};  ///< what comes of it
  double by_tighter_runs = 0;   ///< what of it they tell

  /// Whether tighter runs agree far better than this.
  bool is_confirmed() const;
  /// Whether tighter runs do not tell it.
  bool is_by_rounding() const;
  /// Whether more than it says may come of digits that are lost.
  bool is_in_doubt() const { return rounding.lost.value > 0 && !rounding.is_told_in_wider; }
};

struct KnownErrors {
  std::optional<Estimate> estimate;
  WhyNone why_none;     ///< of the estimate
  DeliveredError lost;  ///< where there is none: by rounding, if that is much
  std::optional<DeliveredError> from_closed_forms;
};

/// By rows that are known to be far closer to the motion.
Estimate estimate_by(const Yardstick& yardstick, const Rows& rows, const PreparedModel& prepared,
                     const Setting& setting);

constexpr double k_long_run = 5;  ///< seconds; not made again unless somebody asks

/// By tighter runs, and no less than what these differ by. `rounding`: has begun with the run, or null. Nothing, and `why`: they say nothing, or take too long.
std::optional<Estimate> estimated(const PreparedModel& prepared, const Engine& engine, Engines& engines,
                                  const Setting& setting, const Simulated& run, const Rows& rows,
                                  RoundingCheck* rounding, WhyNone& why);

DeliveredError from_closed_forms(const ClosedForms& forms, const PreparedModel& prepared, const Setting& setting,
                                 const Rows& rows);

}  // namespace gausssim
