#include "sim/run/known_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/run/interruption.hpp"
#include "sim/run/lost_digits.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

/// Why no tighter run is made; empty: one is.
std::string why_not_estimated(const Simulated& run) {
  if (run.was_interrupted) return "the run was interrupted";
  if (run.samples <= 1) return "the motion stopped before the second row";
  if (run.wall_seconds >= k_long_run) return fmt::format("runs of more than {} s are not made again", k_long_run);
  return "";
}

/// Times are rounded, whatever two runs have in common.
DeliveredError of_times(const Yardstick& yardstick, const PreparedModel& prepared, const Setting& setting) {
  const Span& span = prepared.span;
  const double between = span.duration / static_cast<double>(span.samples - 1);
  const double latest = std::max(std::abs(span.start), std::abs(span.start + span.duration));
  return yardstick.change_within(rounding_unit(setting.number) / 2 * latest / between);
}

const DeliveredError& larger(const DeliveredError& one, const DeliveredError& other) {
  return other.value > one.value ? other : one;
}

}  // namespace

bool Estimate::is_confirmed() const { return agreement && agreement->value <= k_agree * value; }

bool Estimate::is_by_rounding() const {
  // What is rounded otherwise is another bound; what is rounded less comes to the same, where it is not most of it.
  constexpr double k_most = 2;
  return rounding.value > 0 && rounding.value >= value &&
         (!rounding.is_told_in_wider || rounding.value > k_most * by_tighter_runs);
}

Estimate estimate_by(const Yardstick& yardstick, const Rows& rows, const PreparedModel& prepared,
                     const Setting& setting) {
  return {larger(yardstick.error_of(rows), of_times(yardstick, prepared, setting)), yardstick.constants()};
}

namespace {

/// Where tighter runs say nothing, as they may take far longer to lose the same digits: by a run in a type that does not lose them.
std::optional<Estimate> estimated_in_wider(const PreparedModel& prepared, Engines& engines, const Setting& setting,
                                           const Simulated& run, const Rows& rows, RoundingCheck& rounding) {
  const DeliveredError lost = rounding.lost_in(rows);
  if (lost.value == 0 || Interruption::is_asked_for()) return std::nullopt;
  const Yardstick own = of_themselves(rows, prepared, setting);
  const RoundingError told = rounding.error_of(run, rows, own, lost.value, engines, most_seconds_beside(run));
  if (!told.is_told_in_wider) return std::nullopt;
  return Estimate{told, own.constants(), std::nullopt, told};
}

}  // namespace

std::optional<Estimate> estimated(const PreparedModel& prepared, const Engine& engine, Engines& engines,
                                  const Setting& setting, const Simulated& run, const Rows& rows,
                                  RoundingCheck* rounding, WhyNone& why) {
  why = {why_not_estimated(run)};
  if (!why.text.empty()) return std::nullopt;
  const auto tight = tighter_runs(prepared, engine, engines, setting, run, rows, why);
  if (!tight) {
    auto by_wider =
        rounding == nullptr ? std::nullopt : estimated_in_wider(prepared, engines, setting, run, rows, *rounding);
    if (by_wider) why = {};
    return by_wider;
  }
  DeliveredError largest = larger(tight->error, of_times(tight->yardstick, prepared, setting));
  if (tight->agreement) largest = larger(largest, *tight->agreement);
  const double by_tighter_runs = largest.value;
  RoundingError rounded;
  if (rounding != nullptr)
    rounded = rounding->error_of(run, rows, tight->yardstick, largest.value, engines, most_seconds_beside(run));
  if (Interruption::is_asked_for()) return why = {"interrupted while a tighter run was made"}, std::nullopt;
  largest = larger(largest, rounded);
  return Estimate{std::move(largest), tight->yardstick.constants(), tight->agreement, rounded, by_tighter_runs};
}

DeliveredError from_closed_forms(const ClosedForms& forms, const PreparedModel& prepared, const Setting& setting,
                                 const Rows& rows) {
  const Rows exact = forms.instead_of(rows, prepared);
  const double rounding = least_tolerance(setting.number);
  return Yardstick(exact, exact, prepared.columns.columns, rounding, rounding).error_of(rows);
}

}  // namespace gausssim
