#include "sim/advise/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "gauss/integrate/taylor.hpp"
#include "sim/run/in_rows.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

constexpr double k_agreement = 1.0 / 20;  ///< of the error that is asked for
constexpr double k_first =
    1e-3;  ///< tolerance, as a part of the error: what is lost over a motion of some length is made up for
constexpr double k_tighter = 1e-2;
constexpr const char* k_relative = "fehlberg78";  ///< of the same order as the method of any model

/// Runs by the default of the model, each second one of another order or by a relative of the method: where steps are as long as stability allows they are the
/// same for any tolerance, and their errors, too, would be.
class TightSearch {
 public:
  TightSearch(const PreparedModel& prepared, Engines& engines, double error)
      : prepared_(prepared), engines_(engines), error_(error) {}

  std::optional<TightRun> run(std::string& why) {
    const std::string first = prepared_.scene.number ? prepared_.scene.number->text : "double";
    for (const char* const number : {"double", "long-double", "float128"}) {
      if (is_before(number, first)) continue;
      if (auto found = in(number)) return found;
    }
    why = fmt::format("an error of {:.1e} cannot be shown: the two tightest runs that were tried {}", error_,
                      failure_.empty() ? fmt::format("differ by {:.1e}, in {}", closest_.value, closest_.output)
                                       : "end early (" + failure_ + ")");
    return std::nullopt;
  }

 private:
  static bool is_before(const std::string& number, const std::string& first) {
    return number == "double" && (first == "long-double" || first == "float128");
  }

  std::optional<TightRun> in(const std::string& number) {
    const Engine* const engine = engines_.of(number);
    if (engine == nullptr) return std::nullopt;
    Setting setting;
    setting.method = default_method(prepared_.model, *engine, scalar_of(number));
    if (!computes_in(*find_method(setting.method), number)) return std::nullopt;
    setting.number = number;
    setting.projection = default_projection(setting.method);
    setting.tolerance = std::max(error_ * k_first, least_tolerance(number));
    RunInRows coarse = told(*engine, setting);
    for (bool is_other = true; setting.tolerance > least_tolerance(number); is_other = !is_other) {
      setting.tolerance = std::max(setting.tolerance * k_tighter, least_tolerance(number));
      RunInRows fine = told(*engine, is_other ? other_than(setting) : setting);
      if (!why_not(fine.run).empty()) break;
      const DeliveredError apart = delivered_error(coarse.rows, fine.rows, prepared_.columns.columns);
      if (apart.value < closest_.value) closest_ = apart;
      if (apart.value <= k_agreement * error_)
        return TightRun{std::move(fine.rows),
                        fmt::format("{} in {}, tolerance {:.0e}", setting.method, number, setting.tolerance),
                        apart.value};
      coarse = std::move(fine);
    }
    return std::nullopt;
  }

  /// With errors of other terms.
  static Setting other_than(const Setting& setting) {
    constexpr int k_more = 4;
    Setting other = setting;
    if (setting.method == "taylor") {
      const int most = find_method(setting.method)->order;
      const int usual = gauss::integrate::taylor_order(setting.tolerance, most);
      other.order = usual + k_more <= most ? usual + k_more : usual - k_more;
    } else if (setting.method == k_method_of_any_model && computes_in(*find_method(k_relative), setting.number)) {
      other.method = k_relative;
    }
    return other;
  }

  RunInRows told(const Engine& engine, const Setting& setting) {
    RunInRows result = in_rows(prepared_, engine, setting, Meter::none);
    failure_ = why_not(result.run);
    return result;
  }

  const PreparedModel& prepared_;
  Engines& engines_;
  double error_;
  DeliveredError closest_{std::numeric_limits<double>::infinity(), ""};
  std::string failure_;
};

}  // namespace

std::string why_not(const Simulated& run) {
  if (run.outcome == gauss::simulate::Outcome::running) return "";
  return run.why.empty() ? fmt::format("{} at t = {:.6g}", gauss::simulate::name(run.outcome), run.reached) : run.why;
}

std::optional<TightRun> tight_run(const PreparedModel& prepared, Engines& engines, double error, std::string& why) {
  return TightSearch(prepared, engines, error).run(why);
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
