#include "sim/advise/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sim/advise/reference.hpp"
#include "sim/run/in_rows.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/jumps.hpp"
#include "sim/run/progress_bar.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

constexpr double k_margin = 0.5;  ///< of what is asked for
constexpr double k_close = 0.1;   ///< of it: looser is not looked for
constexpr int k_most_trials = 7;  ///< of a method, from the first that delivers on
constexpr int k_most_failures = 20;
constexpr double k_loosest = 1e-2;  ///< tolerance
constexpr double k_first = 0.1;     ///< of the error: errors of steps add up
constexpr double k_digits_of_float = 1e-4;
constexpr double k_few_digits = 1e-5;  ///< from here on a method of low order is tried
constexpr const char* k_method_of_few_digits = "dopri5";
constexpr double k_beaten =
    10;  ///< times the best so far, where it delivers: looser tolerances will not make up for that
constexpr double k_hopeless = 3;  ///< times the best so far, at a looser tolerance
constexpr double k_dear = 1.25;   ///< times what a run without projection takes: constraints are kept for less

constexpr double k_unlimited = std::numeric_limits<double>::infinity();

/// As somebody would write it.
double two_digits(double value) { return std::stod(fmt::format("{:.1e}", value)); }

/// The loosest tolerance of one method in one number type that delivers.
class OneMethod {
 public:
  OneMethod(const PreparedModel& prepared, const Engine& engine, const Yardstick& reference, double error,
            const TimeLimit& whole)
      : prepared_(prepared), engine_(engine), reference_(reference), goal_(k_margin * error), whole_(whole) {}

  /// `best`: seconds of the best so far. Nothing: it does not deliver, or not as cheaply.
  std::optional<Trial> run(Setting setting, double best) {
    double& knob = setting.step > 0 ? setting.step : setting.tolerance;
    const double least = setting.step > 0 ? 0 : least_tolerance(setting.number);
    const double most =
        setting.step > 0 ? prepared_.span.duration / static_cast<double>(prepared_.span.samples - 1) : k_loosest;
    knob = std::min(knob, most);
    std::optional<Trial> found;
    double loosest_failing = k_unlimited;
    for (int count = 0, failures = 0; count < k_most_trials && failures < k_most_failures;
         ++(found ? count : failures)) {
      Trial trial = tried(setting, best);
      last_ = trial;
      const bool delivers = trial.why.empty() && trial.error.value <= goal_;
      if (trial.seconds > (delivers ? k_beaten : k_hopeless) * best) break;
      if (trial.is_unsuitable || (!delivers && knob <= least)) break;
      // Where samples, or stability, are what steps are short by, a looser tolerance brings nothing.
      if (delivers && found && trial.steps == found->steps) break;
      if (delivers && (!found || trial.seconds < found->seconds)) found = trial;
      if (delivers && trial.error.value >= k_close * goal_) break;
      if (!delivers) loosest_failing = std::min(loosest_failing, knob);
      const double next = std::clamp(two_digits(knob * factor(trial, setting)), least, most);
      if (delivers && (next >= loosest_failing || next == knob)) break;
      knob = next;
    }
    return found;
  }

  const Trial& last() const { return last_; }

 private:
  Trial tried(const Setting& setting, double best) const {
    // Whatever takes longer is of no use.
    constexpr double k_least_limit = 1, k_sure = 2;
    const TimeLimit limit(k_least_limit + k_sure * k_beaten * best);
    RunInRows told = in_rows(prepared_, engine_, setting, Meter::none);
    agree_at_events(told, {}, reference_.rows(), prepared_.span);
    throw_if_ended(whole_);
    Trial trial{setting,
                {},
                told.run.cpu_seconds,
                why_not(told.run),
                told.run.steps,
                told.run.outcome == gauss::simulate::Outcome::bad_settings};
    if (!trial.why.empty()) return trial;
    trial.error = reference_.error_of(told.rows);
    // The least of some: what is short is disturbed most.
    constexpr double k_enough = 0.01;
    constexpr int k_most = 30, k_least = 3;
    double sum = trial.seconds;
    for (int k = 1; k < k_most && sum < (k < k_least ? 2 * k_enough : k_enough); ++k) {
      const Simulated again = unheard(prepared_, engine_, setting);
      if (!why_not(again).empty()) break;  // its time is over
      trial.seconds = std::min(trial.seconds, again.cpu_seconds);
      sum += again.cpu_seconds;
    }
    return trial;
  }

  /// Errors go with tolerances, and with powers of steps.
  double factor(const Trial& trial, const Setting& setting) const {
    constexpr double k_unknown = 0.1, k_safe = 0.6, k_most = 1e3, k_least = 1e-6;
    if (!trial.why.empty() || !std::isfinite(trial.error.value)) return k_unknown;
    // What is off by all tells nothing of how far.
    constexpr double k_lost = 0.1, k_far = 1e-3;
    if (trial.error.value >= k_lost && setting.tolerance > 0)
      return std::min(k_far, k_safe * goal_ / trial.error.value);
    const double ratio = k_safe * goal_ / std::max(trial.error.value, goal_ / k_most);
    const double order = setting.step > 0 ? find_method(setting.method)->order : 1;
    return std::pow(std::clamp(ratio, k_least, k_most), 1 / order);
  }

  const PreparedModel& prepared_;
  const Engine& engine_;
  const Yardstick& reference_;
  double goal_;
  const TimeLimit& whole_;
  Trial last_;
};

class Search {
 public:
  Search(const PreparedModel& prepared, Engines& engines, const Wanted& wanted)
      : prepared_(prepared),
        engines_(engines),
        error_(wanted.error),
        bar_(wanted.is_told),
        limit_(wanted.budget, TimeLimit::Of::all),
        too_long_(fmt::format("no setting for an error of {:.1e} was found in {:.3g} s; {}", wanted.error,
                              wanted.budget,
                              prepared.edge.empty() ? "--budget gives it more" : hint_for_edge(prepared.edge))),
        longest_step_(prepared.scene.longest_step.value_or(0)) {}

  std::optional<FoundSetting> run(std::string& why) {
    try {
      bar_.say("looking for a setting: a tight run");
      const Loss loss(prepared_, engines_, error_);
      throw_if_ended(limit_);
      auto reference = tight_run(prepared_, engines_, error_, loss, limit_, why);
      if (!reference) return std::nullopt;
      found_.reference = std::move(reference->yardstick);
      found_.reference_in_words = reference->in_words;
      found_.agreement = reference->agreement;
      if (!chooses_method(prepared_.scene)) {
        const std::string& method = prepared_.scene.method->text;
        try_in(method, number_name(prepared_.scene));
        try_harder(method);
      } else {
        try_all(loss);
      }
      try_without_projection();
    } catch (const OutOfTime&) {
      if (found_.trials.empty()) return why = too_long_, std::nullopt;
    }
    if (found_.trials.empty()) {
      why = fmt::format("no setting delivers an error of {:.1e}: {}", error_, said_of_last());
      return std::nullopt;
    }
    found_.chosen = cheapest();
    return std::move(found_);
  }

 private:
  void try_all(const Loss& loss) {
    const Engine* const engine = engines_.of(number_name(prepared_.scene));
    if (engine == nullptr) return;
    const std::string usual = default_method(prepared_, *engine, number_name(prepared_.scene));
    // Where nothing but rounding moves a model, a run has no end, unless something tells when it is of no use.
    if (loss.is_above(k_first * error_, number_name(prepared_.scene)) && !prepared_.scene.number)
      try_in_more_digits(usual, loss);
    std::vector<std::string> methods{usual};
    if (usual != k_method_of_any_model) methods.emplace_back(k_method_of_any_model);
    if (error_ >= k_few_digits) methods.emplace_back(k_method_of_few_digits);
    for (const std::string& method : methods) try_in(method, number_name(prepared_.scene));
    if (error_ >= k_digits_of_float && !prepared_.scene.number) {
      for (const std::string& method : methods) try_in(method, "float");
    }
    if (is_stiff()) {
      for (const MethodInfo& method : gausssim::methods())
        if (method.is_stiff && method.missing.empty()) try_in(method.name, number_name(prepared_.scene));
    }
    try_harder(usual);
  }

  /// Where nothing has delivered: shorter steps, for what acts for a time that others pass over; then more digits.
  void try_harder(const std::string& method) {
    if (!prepared_.scene.longest_step && found_.trials.empty()) {
      longest_step_ = longest_steps(prepared_).fine;
      if (try_in(method, number_name(prepared_.scene))) return;
      longest_step_ = 0;
    }
    if (found_.trials.empty() && !prepared_.scene.number) try_in_more_digits(method);
  }

  /// The first that comes as close to the least time as times can be measured.
  const Trial& cheapest() const {
    constexpr double k_alike = 1.1;
    return *std::find_if(found_.trials.begin(), found_.trials.end(),
                         [this](const Trial& trial) { return trial.seconds <= k_alike * best_; });
  }

  /// An error bounds what constraints drift by, where somebody pays for it: in the usual number type and in that which is cheapest with projection, since projection may cost
  /// more than the others' digits.
  void try_without_projection() {
    if (prepared_.scene.projection || found_.trials.empty()) return;
    const double projected = best_;
    const std::string usual = number_name(prepared_.scene), other = cheapest().setting.number;
    try_without_projection(usual, projected);
    if (other != usual) try_without_projection(other, projected);
  }

  void try_without_projection(const std::string& number, double projected) {
    const Trial* least = nullptr;
    for (const Trial& trial : found_.trials)
      if (trial.setting.number == number && (least == nullptr || trial.seconds < least->seconds)) least = &trial;
    if (least == nullptr || least->setting.projection == Projection::off) return;
    Setting setting = least->setting;
    setting.projection = Projection::off;
    OneMethod one(prepared_, *engines_.of(number), found_.reference, error_, limit_);
    const auto trial = one.run(setting, best_);
    if (!trial || k_dear * trial->seconds >= projected) return;
    found_.trials.push_back(*trial);
    best_ = std::min(best_, trial->seconds);
  }

  void try_in_more_digits(const std::string& method, const std::optional<Loss>& loss = std::nullopt) {
    for (const std::string& number : numbers_from(number_name(prepared_.scene), method)) {
      if (number == number_name(prepared_.scene) || (loss && loss->is_above(k_first * error_, number))) continue;
      if (try_in(method, number, given_up(method))) return;
    }
  }

  double& given_up(const std::string& method) { return given_up_.try_emplace(method, k_unlimited).first->second; }

  bool try_in(const std::string& method, const std::string& number, double loosest = k_unlimited) {
    if (!computes_in(*find_method(method), number)) return false;
    const Engine* const engine = engines_.of(number);
    if (engine == nullptr) return false;
    bar_.say(fmt::format("looking for a setting: {} in {}", method, number));
    Setting setting;
    setting.method = method;
    setting.number = number;
    setting.projection =
        prepared_.scene.projection ? projection_of(prepared_.scene.projection->text) : default_projection(method);
    constexpr double k_first_steps = 1000;
    if (find_method(method)->takes_step) {
      setting.step = prepared_.span.duration / k_first_steps;
    } else {
      setting.tolerance = std::max(two_digits(std::min(k_first * error_, loosest)), least_tolerance(number));
      setting.longest_step = longest_step_;
    }
    OneMethod one(prepared_, *engine, found_.reference, error_, limit_);
    const auto trial = one.run(setting, best_);
    if (!trial) {
      last_ = one.last();
      double& tolerance = given_up(method);
      tolerance = std::min(tolerance, last_.setting.tolerance);
      return false;
    }
    best_ = std::min(best_, trial->seconds);
    found_.trials.push_back(*trial);
    return true;
  }

  /// Steps are as long as stability allows, and not as the tolerance does.
  bool is_stiff() {
    const Engine* const engine = engines_.of("double");
    if (engine == nullptr) return false;
    PreparedModel one_way = prepared_;
    one_way.span.samples = 2;  // more of them shorten steps
    Setting setting;
    setting.method = k_method_of_any_model;
    setting.projection = default_projection(setting.method);
    constexpr double k_loose = 1e-3, k_tight = 1e-6, k_alike = 0.9;  ///< of order 8: 0.42 where accuracy decides
    setting.tolerance = k_loose;
    const Simulated loose = unheard(one_way, *engine, setting);
    setting.tolerance = k_tight;
    const Simulated tight = unheard(one_way, *engine, setting);
    throw_if_ended(limit_);
    const long steps = std::max(loose.steps + loose.rejected, 1L), all = std::max(tight.steps + tight.rejected, 1L);
    return static_cast<double>(steps) > k_alike * static_cast<double>(all);
  }

  std::string said_of_last() const {
    if (!last_.why.empty()) return last_.why;
    return fmt::format("{} in {} at tolerance {:.0e} is off by {:.1e}, in {}", last_.setting.method,
                       last_.setting.number, last_.setting.tolerance, last_.error.value, last_.error.output);
  }

  const PreparedModel& prepared_;
  Engines& engines_;
  double error_;
  ProgressBar bar_;
  TimeLimit limit_;
  std::string too_long_;
  double longest_step_;
  double best_ = k_unlimited;
  FoundSetting found_;
  Trial last_;
  std::map<std::string, double> given_up_;  ///< at which tolerance each method was
};

}  // namespace

std::optional<FoundSetting> find_setting(const PreparedModel& prepared, Engines& engines, const Wanted& wanted,
                                         std::string& why) {
  return Search(prepared, engines, wanted).run(why);
}

}  // namespace gausssim
