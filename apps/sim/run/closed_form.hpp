#pragma once
// Outputs that somebody knows as functions of time: `exact` of a scene.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/error_estimate.hpp"

namespace gausssim {

/// Over time and parameters, with the digits of the number type.
class ClosedForms {
 public:
  explicit ClosedForms(const PreparedModel& model);

  bool has(const std::string& column) const { return forms_.count(column) != 0; }
  bool are_there() const { return !forms_.empty(); }
  /// Of a column that there is one for.
  Quad at(const std::string& column, Quad t) const;
  /// `rows` of a run of the model from its start on, with columns that are known as they have to be.
  Rows instead_of(const Rows& rows, const PreparedModel& model) const;

 private:
  std::map<std::string, gaussgen::model::Ast> forms_;
  std::map<std::string, Quad> values_;
};

}  // namespace gausssim
