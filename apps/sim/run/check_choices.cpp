#include "sim/run/check_choices.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <utility>

#include "cli/usage_error.hpp"
#include "sim/drive/projection.hpp"
#include "sim/run/setting.hpp"
#include "support/error_codes.hpp"

namespace gausssim {

namespace {

namespace code = gaussgen::support::code;
using Choice = std::optional<Word>;

bool is(const Choice& choice, const char* word) { return choice && choice->text == word; }

class ChoicesCheck {
 public:
  ChoicesCheck(const Scene& scene, gaussgen::support::Diagnostics& diagnostics)
      : scene_(scene),
        diagnostics_(diagnostics),
        method_(chooses_method(scene) ? nullptr : find_method(scene.method->text)) {}

  std::vector<std::string> run() {
    if (method_ != nullptr) check_method();
    if (is(scene_.number, "float128") && !is_full_or_off() && !is(scene_.method, "taylor"))
      refuse({&scene_.projection, &scene_.number}, "in float128 there is full projection, or none");
    if (is(scene_.projection, "gains") && is(scene_.engine, "interpreted"))
      refuse({&scene_.engine, &scene_.projection}, "gains are for compiled models");
    check_unused();
    return std::move(remarks_);
  }

 private:
  bool is_full_or_off() const {
    return !scene_.projection || is(scene_.projection, "full") || is(scene_.projection, "off");
  }

  void check_method() {
    const auto refuse_method = [&](const Choice& beside, const std::string& why) {
      refuse({&beside, &scene_.method}, fmt::format("method '{}': {}", method_->name, why));
    };
    if (!method_->missing.empty()) return refuse_method(scene_.method, method_->missing);
    const std::string& number = number_name(scene_);
    if (!computes_in(*method_, number)) refuse_method(scene_.number, "it does not compute in " + number);
    const bool is_series = method_->name == "taylor";
    if (!method_->projects && scene_.projection && !is(scene_.projection, "off"))
      refuse_method(
          scene_.projection,
          "it does not project, so states drift off the constraints as its tolerance allows; take 'projection: off'");
    else if (is_series && !is_full_or_off())
      refuse_method(scene_.projection, "series take full projection, or none");
    if (is_series && is(scene_.engine, "interpreted"))
      refuse_method(scene_.engine, "it has no series in a model that is interpreted");
  }

  /// At the first choice that stands in the scene.
  void refuse(std::initializer_list<const Choice*> choices, const std::string& message) {
    for (const Choice* const choice : choices) {
      if (!*choice || is_of_option((*choice)->span)) continue;
      diagnostics_.error(code::k_conflicting_keys, (*choice)->span, message);
      return;
    }
    throw gaussgen::cli::UsageError(message);
  }

  /// Nobody should believe that a run was made with what it does not use.
  void check_unused() {
    if (method_ != nullptr && method_->takes_step) {
      const std::string why = fmt::format("'{}' takes steps of one length: ", method_->name);
      warn("tolerance", scene_.tolerance, why + "the tolerance is not used");
      warn("longest_step", scene_.longest_step, why + "'longest_step' is not used");
    } else {
      const std::string who = method_ != nullptr ? "'" + method_->name + "'" : "a method that is chosen for the model";
      warn("step", scene_.step, who + " takes its steps by the tolerance: the step is not used");
    }
    if (!is(scene_.projection, "gains")) warn("gain", scene_.gain, "a gain is for 'projection: gains', and not used");
  }

  void warn(const char* key, const std::optional<double>& value, const std::string& message) {
    if (!value) return;
    const auto place = scene_.places.find(key);
    if (place == scene_.places.end())
      remarks_.push_back(message);
    else
      diagnostics_.warning(code::k_unused, place->second, message);
  }

  const Scene& scene_;
  gaussgen::support::Diagnostics& diagnostics_;
  const MethodInfo* method_;  ///< null: one is chosen for the model
  std::vector<std::string> remarks_;
};

}  // namespace

std::vector<std::string> check_choices(const Scene& scene, gaussgen::support::Diagnostics& diagnostics) {
  return ChoicesCheck(scene, diagnostics).run();
}

}  // namespace gausssim
