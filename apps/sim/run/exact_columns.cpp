#include "sim/run/exact_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/error_codes.hpp"

namespace gausssim {

namespace code = gaussgen::support::code;
namespace model = gaussgen::model;

namespace {

/// Some have no value now and then.
double at_another_time(const model::Ast& form, model::Values values) {
  values["t"] = 0.7390851332151607;
  return model::value_of(form, values).value_or(0);
}

}  // namespace

void check_exact(const Scene& scene, const Columns& columns, model::Values values,
                 gaussgen::support::Diagnostics& diagnostics) {
  values["t"] = scene.exact.empty() ? 0 : 1;
  for (const Given& form : scene.exact) {
    const bool is_column = std::any_of(columns.columns.begin(), columns.columns.end(),
                                       [&](const Column& column) { return column.name == form.name; });
    if (!is_column)
      diagnostics.error(code::k_wrong_reference, form.span, fmt::format("'{}' is no column of the table", form.name),
                        "'outputs' names the columns; a closed form is of one of them");
    if (model::is_broken(form.value)) continue;
    const auto value = model::value_of(form.value, values);
    if (!value)
      diagnostics.error(code::k_wrong_reference, form.value.span,
                        "a closed form is made of t, pi, numbers, parameters and functions of these");
    else if (!std::isfinite(*value) && !std::isfinite(at_another_time(form.value, values)))
      diagnostics.error(code::k_not_finite, form.value.span,
                        fmt::format("the closed form of '{}' has no value", form.name));
  }
}

void take_exact_of_model(const std::vector<model::ClosedForm>& of_model, const Columns& columns, const Span& span,
                         model::Values values, Scene& scene) {
  if (!scene.initial.empty() || !scene.inputs.empty() || span.start != 0) return;
  values["t"] = 1;
  const auto has_name = [](const std::string& name) { return [&](const auto& one) { return one.name == name; }; };
  for (const model::ClosedForm& form : of_model) {
    const auto is_it = has_name(form.name.text);
    const bool is_column = std::any_of(columns.columns.begin(), columns.columns.end(), is_it);
    const bool is_said = std::any_of(scene.exact.begin(), scene.exact.end(), is_it);
    if (is_column && !is_said && model::value_of(form.value, values))
      scene.exact.push_back({form.name.text, form.value, form.name.span});
  }
}

}  // namespace gausssim
