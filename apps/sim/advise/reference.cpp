#include "sim/advise/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "sim/run/in_rows.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

constexpr double k_agreement = 1.0 / 20;  ///< of the error that is asked for
constexpr double k_first =
    1e-3;  ///< tolerance, as a part of the error: what is lost over a motion of some length is made up for
constexpr double k_tighter = 1e-2, k_much_tighter = 1e-6;  ///< tolerances, by how far two runs are apart
/// Of errors that can be shown: tables are compared with the digits of long double.
constexpr double k_least = static_cast<double>(std::numeric_limits<long double>::epsilon()) / k_agreement;

/// As of Yardstick. What is as small as this beside its size has no digits in double that could be delivered.
constexpr double k_least_range = 1e-12;

/// Two runs by the default of the model that have as little in common as can be: in number types that are next to each other, since runs that round the same start, and the same values, agree on
/// what that makes of an unstable motion; of other orders, or by a pair of methods, since steps that stability limits are the same for all tolerances; and with other longest steps.
class TightSearch {
 public:
  TightSearch(const PreparedModel& prepared, Engines& engines, double error, const Loss& loss, const TimeLimit& limit)
      : prepared_(prepared),
        engines_(engines),
        error_(error),
        loss_(loss),
        tolerance_(error * k_first),
        limit_(limit) {}

  std::optional<TightRun> run(std::string& why) {
    if (error_ < k_least) {
      why = fmt::format("an error of {:.1e} cannot be shown: the least that can is {:.1e}", error_, k_least);
      return std::nullopt;
    }
    const std::string first = number_name(prepared_.scene);
    for (const char* const number : {"double", "long-double", "float128"}) {
      if (is_before(number, first) || loss_.is_above(k_agreement * error_, number)) continue;
      if (auto found = in(number)) return found;
    }
    why =
        fmt::format("an error of {:.1e} cannot be shown: the two tightest runs that were tried {}", error_,
                    failure_.empty() ? fmt::format("differ by {:.1e}, in {}, where a twentieth of the error is needed",
                                                   closest_.value, closest_.output)
                                     : "end early (" + failure_ + ")");
    return std::nullopt;
  }

 private:
  static bool is_before(const std::string& number, const std::string& first) {
    return number == "double" && (first == "long-double" || first == "float128");
  }

  static std::string next_to(const std::string& number) {
    return number == "double" || number == "float" ? "long-double" : "float128";
  }

  std::optional<TightRun> in(const std::string& number) {
    const std::string wider = next_to(number);
    if (engines_.of(number) == nullptr) return std::nullopt;
    const bool has_wider = engines_.of(wider) != nullptr;
    const double least = least_tolerance(number);
    for (tolerance_ = std::max(tolerance_, least);;) {
      const RunInRows coarse = told(tight(number, tolerance_, longest_steps(prepared_).other));
      if (!failure_.empty()) return std::nullopt;
      const double finer = std::max(tolerance_ * k_tighter, least);
      const std::string& fine_number = has_wider ? wider : number;
      const Setting setting = by_other_terms(tight(fine_number, finer, longest_steps(prepared_).fine), prepared_);
      RunInRows fine = told(setting);
      if (!failure_.empty()) return std::nullopt;
      agree_at_events(fine, coarse.run.events, coarse.rows, prepared_.span);
      Yardstick yardstick(std::move(fine.rows), coarse.rows, prepared_.columns.columns, k_least_range,
                          least_tolerance(fine_number));
      DeliveredError apart = yardstick.error_of(coarse.rows);
      apart.value = std::max(apart.value, k_agreement * k_least);
      if (apart.value < closest_.value) closest_ = apart;
      if (apart.value <= k_agreement * error_)
        return TightRun{std::move(yardstick),
                        fmt::format("{} in {}, tolerance {:.0e}", setting.method, setting.number, setting.tolerance),
                        apart.value};
      if (tolerance_ <= least) return std::nullopt;
      const double tighter = std::clamp(k_agreement * error_ / apart.value, k_much_tighter, k_tighter);
      tolerance_ = std::max(tolerance_ * tighter, least);
    }
  }

  Setting tight(const std::string& number, double tolerance, double longest_step) {
    Setting setting;
    setting.method = default_method(prepared_, *engines_.of(number), number);
    setting.number = number;
    setting.projection = default_projection(setting.method);
    setting.tolerance = tolerance;
    setting.longest_step = longest_step;
    return setting;
  }

  RunInRows told(const Setting& setting) {
    RunInRows result = in_rows(prepared_, *engines_.of(setting.number), setting, Meter::none);
    throw_if_ended(limit_);
    failure_ = why_not(result.run);
    return result;
  }

  const PreparedModel& prepared_;
  Engines& engines_;
  double error_;
  const Loss& loss_;
  double tolerance_;  ///< of the coarse run: what one number type has found not to do, others need not try
  const TimeLimit& limit_;
  DeliveredError closest_{std::numeric_limits<double>::infinity(), ""};
  std::string failure_;
};

}  // namespace

std::string why_not(const Simulated& run) {
  if (run.outcome == gauss::simulate::Outcome::running) return "";
  return run.why.empty() ? fmt::format("{} at t = {:.6g}", gauss::simulate::name(run.outcome), run.reached) : run.why;
}

std::optional<TightRun> tight_run(const PreparedModel& prepared, Engines& engines, double error, const Loss& loss,
                                  const TimeLimit& limit, std::string& why) {
  return TightSearch(prepared, engines, error, loss, limit).run(why);
}

std::vector<std::string> numbers_from(const std::string& first, const std::string& method) {
  const std::vector<std::string> all{"double", "long-double", "float128"};
  std::vector<std::string> numbers;
  const auto begin = std::find(all.begin(), all.end(), first);
  if (begin == all.end()) return {first};
  std::copy_if(begin, all.end(), std::back_inserter(numbers),
               [&](const std::string& number) { return computes_in(*find_method(method), number); });
  return numbers;
}

}  // namespace gausssim
