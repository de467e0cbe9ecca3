#pragma once
// Values in double of expressions without motion: only to refuse models that cannot start.

#include <map>
#include <optional>
#include <string>

#include "model/model.hpp"

namespace gaussgen::model {

using Values = std::map<std::string, double>;

/// Nothing when a symbol is not among `values`; infinities and NaN come back as such.
std::optional<double> value_of(const Ast& ast, const Values& values);

/// Of every parameter that has one, and of pi.
Values parameter_values(const Model& model);

}  // namespace gaussgen::model
