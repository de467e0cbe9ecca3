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
  /// `parameters` by their names.
  ClosedForms(const Scene& scene, std::map<std::string, Quad> parameters);

  bool has(const std::string& column) const { return forms_.count(column) != 0; }
  bool are_there() const { return !forms_.empty(); }
  /// Of a column that there is one for.
  Quad at(const std::string& column, Quad t) const;

 private:
  std::map<std::string, gaussgen::model::Ast> forms_;
  std::map<std::string, Quad> values_;
};

/// With the parameters of a model in float128.
ClosedForms closed_forms_of(const PreparedModel& model, const Engine& engine);

}  // namespace gausssim
