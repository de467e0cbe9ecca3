#include "sim/ensemble/check_draws.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "model/evaluate.hpp"
#include "model/impossible.hpp"
#include "support/error_codes.hpp"

namespace gausssim {

namespace {

namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
using Values = std::vector<std::optional<double>>;  ///< of what varies; nothing: its nominal value

struct Mistake {
  std::string code, message;
};

class Checker {
 public:
  Checker(const std::vector<Placed>& places, const model::Model& model) : model_(model) {
    for (const Placed& place : places) {
      std::optional<std::size_t> index;
      const auto symbol = model.symbols.find(place.name);
      if (!place.is_input && symbol != model.symbols.end()) index = symbol->second.index;
      parameters_.push_back(index);
    }
    for (const model::Parameter& parameter : model.parameters)
      plain_.push_back(parameter.is_formula ? std::nullopt
                                            : model::value_of(parameter.value, {{"pi", std::acos(-1.0)}}));
  }

  std::optional<Mistake> mistake(const Values& given) const {
    std::vector<std::optional<double>> values = plain_;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (parameters_[i] && given[i]) values[*parameters_[i]] = given[i];
    }
    model::Values all{{"pi", std::acos(-1.0)}};
    for (std::size_t k = 0; k < values.size(); ++k) {
      const model::Parameter& parameter = model_.parameters[k];
      const auto value = values[k] ? values[k] : model::value_of(parameter.value, all);
      if (!value) continue;
      if (!std::isfinite(*value))
        return Mistake{code::k_not_finite, fmt::format("'{}' is {}", parameter.name.text,
                                                       std::isnan(*value) ? "not a real number" : "infinite")};
      all[parameter.name.text] = *value;
    }
    for (const auto& found : model::impossible_bodies(model_, all)) {
      if (found.severity == gaussgen::support::Severity::error) return Mistake{found.code, found.message};
    }
    return std::nullopt;
  }

 private:
  const model::Model& model_;
  std::vector<std::optional<std::size_t>> parameters_;  ///< that each varied quantity is; of inputs none
  std::vector<std::optional<double>> plain_;            ///< values of those that are no formulas
};

/// The one quantity whose value is wrong with any others, if it is one.
const Varied* culprit(const Checker& checker, const Plan& plan, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Values alone(values.size());
    alone[i] = values[i];
    if (checker.mistake(alone)) return &plan.varied()[i];
  }
  return nullptr;
}

std::string in_words(const Plan& plan, const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("{}{} = {:.6g}", i == 0 ? "" : ", ", plan.varied()[i].name, values[i]);
  return text;
}

}  // namespace

void check_draws(const Ensemble& ensemble, const std::vector<Placed>& places, const model::Model& model,
                 gaussgen::support::Diagnostics& diagnostics) {
  const Plan plan(ensemble);
  const Checker checker(places, model);
  long wrong = 0, first = 0;
  std::optional<Mistake> found;
  for (long i = 0; i < plan.count(); ++i) {
    const std::vector<double> values = plan.values(i);
    const auto mistake = checker.mistake(Values(values.begin(), values.end()));
    if (!mistake) continue;
    if (++wrong > 1) continue;
    first = i;
    found = mistake;
  }
  if (!found) return;
  const std::vector<double> values = plan.values(first);
  const Varied* const one = culprit(checker, plan, values);
  diagnostics.error(found->code, one == nullptr ? ensemble.span : one->span,
                    fmt::format("trajectory {} cannot be, with {}: {}{}", first, in_words(plan, values), found->message,
                                wrong > 1 ? fmt::format(" (and {} more)", wrong - 1) : ""),
                    "narrow what varies");
}

}  // namespace gausssim
