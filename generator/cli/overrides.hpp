#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/usage_error.hpp"
#include "model/model.hpp"

namespace gaussgen::cli {

/// An expression that is given to `option`. Throws UsageError.
model::Ast parse_value(const std::string& option, const std::string& text);

/// What is wrong with a value that is infinite or no number.
std::string not_finite(double value);

/// Gives a model other values. `option` is for messages: how the user gave them.
class Overrides {
 public:
  explicit Overrides(model::Model& model) : model_(model) {}

  /// A parameter, an input, an initial value or rate, by the names that `apply_overrides` takes. Throws UsageError.
  void set(const std::string& option, const std::string& name, model::Ast value);

  /// Whether all have values with the parameters as they are now. Throws UsageError.
  void check() const;

 private:
  struct Given {
    std::string option;
    model::Ast value;
  };

  model::Model& model_;
  std::set<std::string> seen_;
  std::vector<Given> all_;
};

/// Applies assignments "name=value" to a model: each gives a value to a parameter (a formula is replaced), an input, the initial value of a coordinate or
/// quaternion component, or an initial rate, written dot(chi), chi_dot or, for angular velocities, by name. The value is an
/// expression over parameters. All are applied before any is judged by the values of parameters. Throws UsageError.
void apply_overrides(const std::vector<std::string>& assignments, model::Model& model);

/// The effect that does not act and has what `name` names, as those of `apply_overrides` do. Null: the model has it as it is, or nothing has.
const std::string* absent_effect_of(const std::string& name, const model::Model& model);

/// Assignments such as theta=2: the acceleration of a free coordinate, an angular velocity component or a speed, a number. By the
/// names that emitted code has for them. Throws UsageError.
std::map<std::string, support::Rational> parse_accelerations(const std::vector<std::string>& assignments,
                                                             const model::Model& model);

/// The value of --time: a number, or sums, products and quotients of numbers.
support::Rational parse_time(const std::string& text);

}  // namespace gaussgen::cli
