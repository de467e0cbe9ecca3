#pragma once

#include <stdexcept>
#include <string>

#include "model/model.hpp"

namespace gaussgen::cli {

/// A wrong command line; the message is for the user.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Applies "name=value" to a model: a parameter (a formula is replaced), an input, the initial value of a coordinate or
/// quaternion component, or an initial rate, written dot(chi), chi_dot or, for angular velocities, by name. The value is an
/// expression over parameters. Throws UsageError.
void apply_override(const std::string& assignment, model::Model& model);

/// An expression over parameters and numbers, such as the value of --time.
model::Ast parse_value(const std::string& option, const std::string& text, const model::Model& model);

}  // namespace gaussgen::cli
