#include "sim/run/rounding.hpp"

#include <algorithm>

#include "sim/run/interruption.hpp"
#include "sim/run/known_errors.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

constexpr double k_nudged_seconds = 1.5 * k_long_run;
constexpr double k_most_interpreted = 2;  ///< s

/// So much closer to the motion that what it differs by from a run is the error of that.
Setting in_wider(const Setting& setting, const std::string& number, double error, const PreparedModel& prepared) {
  constexpr double k_tighter = 1e-2, k_of_steps = 1e-10, k_shorter = 0.5;
  Setting wide;
  wide.method = computes_in(*find_method(k_method_of_any_model), number) ? k_method_of_any_model : k_relative;
  wide.number = number;
  const double tolerance = setting.tolerance > 0 ? setting.tolerance : k_of_steps;
  wide.tolerance = std::max(k_tighter * std::min(tolerance, error), least_tolerance(number));
  wide.longest_step = longest_steps(prepared).other;
  if (setting.longest_step > 0) wide.longest_step = std::min(wide.longest_step, k_shorter * setting.longest_step);
  // Gains are compiled, and another way to the same motion.
  wide.projection = setting.projection == Projection::gains ? Projection::full : setting.projection;
  return wide;
}

/// A small part of what is lost: what a wider type rounds may be more than its first tolerance, so that steps make no progress.
double looser(double tolerance, double lost) {
  constexpr double k_of_lost = 1e-2, k_loosest = 1e-4;
  return std::max(tolerance, std::min(k_of_lost * lost, k_loosest));
}

/// Of `float`, errors are told in `double`; empty: nothing is wider.
std::string told_in(const std::string& number) {
  if (number == "float") return "double";
  return number == "double" || number == "long-double" ? number : "";
}

/// What is lost acts like a tolerance; errors of a run, which may be far less than that, are what comes of it in the end, more or less.
bool is_much(const Lost& lost, double known, const Setting& setting) {
  constexpr double k_of_known = 1e-2, k_of_tolerance = 0.1, k_in_time = 0.25, k_useless = 0.1;
  if (known >= k_useless) return false;  // what more may be wrong with it matters to nobody
  return lost.value > k_of_known * known || lost.in_time > k_in_time * known ||
         (setting.tolerance > 0 && lost.value > k_of_tolerance * setting.tolerance);
}

}  // namespace

RoundingCheck::RoundingCheck(const PreparedModel& prepared, const Engine& engine, const Setting& setting)
    : prepared_(prepared), engine_(engine), setting_(setting), states_(prepared.span.samples) {
  if (setting.number == "float") return;
  Setting nudged = setting;
  nudged.is_nudged = true;
  nudged_ = begin_in_rows(prepared, engine, nudged, k_nudged_seconds);
}

std::optional<RoundingCheck::WideRows> RoundingCheck::rows_in(const std::string& wider, double lost, double known,
                                                              Engines& engines, const Simulated& run,
                                                              double most_seconds) const {
  const auto within = [&](double seconds, const Engine& engine, const Setting& setting) -> std::optional<WideRows> {
    const TimeLimit limit(seconds);
    RunInRows told = in_rows(prepared_, engine, setting, Meter::none);
    if (!gets_as_far(told.run, run)) return std::nullopt;
    return WideRows{std::move(told.rows), setting.tolerance};
  };
  const auto interpreted = engine_.another();
  Setting wide = in_wider(setting_, wider, std::max(lost, known), prepared_);
  if (auto rows = within(k_most_interpreted, *interpreted, wide)) return rows;
  if (const double loose = looser(wide.tolerance, lost); loose > wide.tolerance) {
    wide.tolerance = loose;
    if (auto rows = within(k_most_interpreted, *interpreted, wide)) return rows;
  }
  // A run that takes so long is worth a compiler's time.
  const Engine* const compiled = Interruption::is_asked_for() ? nullptr : engines.of(wider);
  return compiled == nullptr ? std::nullopt : within(most_seconds, *compiled, wide);
}

std::string RoundingCheck::wider_than(const LostDigits& digits, double lost) const {
  constexpr double k_clear = 1e-2;
  const bool is_next_enough = setting_.number != "long-double" && digits.in("long-double").value <= k_clear * lost;
  return is_next_enough ? "long-double" : "float128";
}

DeliveredError RoundingCheck::lost_in(const Rows& rows) const {
  constexpr double k_known = 1e-7;  ///< of runs by steps of one length: nobody knows
  const std::string number = told_in(setting_.number);
  if (number.empty()) return {};
  const Yardstick own = of_themselves(rows, prepared_, setting_);
  DeliveredError lost = LostDigits(prepared_, engine_, setting_, states_, own).in(number);
  return lost.value > (setting_.tolerance > 0 ? setting_.tolerance : k_known) ? lost : DeliveredError{};
}

RoundingError RoundingCheck::error_of(const Simulated& run, const Rows& rows, const Yardstick& yardstick, double known,
                                      Engines& engines, double most_seconds) {
  RoundingError result;
  if (nudged_.valid()) {
    const RunInRows nudged = nudged_.get();
    if (gets_as_far(nudged.run, run)) result = {yardstick.difference(rows, nudged.rows)};
  }
  const std::string number = told_in(setting_.number);
  if (number.empty()) return result;
  if (states_.all().size() < k_close_samples)
    states_ = passage(prepared_, *engine_.another(), setting_, most_seconds).states;
  const LostDigits digits(prepared_, engine_, setting_, states_, yardstick);
  const Lost lost = digits.in(number);
  known = std::max(known, result.value);
  if (!is_much(lost, known, setting_)) return result;
  result.lost = lost;
  result.wider = wider_than(digits, lost.value);
  const auto told = rows_in(result.wider, lost.value, known, engines, run, most_seconds);
  result.is_told_in_wider = told.has_value();
  DeliveredError& error = result;
  if (told)
    error = by_wider(rows, *told, yardstick);
  else if (lost.value > error.value)
    error = lost;
  return result;
}

DeliveredError RoundingCheck::by_wider(const Rows& rows, const WideRows& wide, const Yardstick& yardstick) const {
  const Yardstick own(wide.rows, wide.rows, prepared_.columns.columns, least_range(wide.tolerance), wide.tolerance);
  const DeliveredError by_own = own.error_of(rows), by_other = yardstick.difference(rows, wide.rows);
  return by_own.value > by_other.value ? by_own : by_other;
}

}  // namespace gausssim
