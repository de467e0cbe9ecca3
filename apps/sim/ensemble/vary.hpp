#pragma once
// A model whose values an ensemble may change when it runs.

#include <string>
#include <vector>

#include "model/model.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Where a varied value goes.
struct Placed {
  bool is_input = false;  ///< else a parameter
  std::string name;       ///< in the model
};

/// Makes each varied quantity one that is given at run time: formulas are no more, and initial values follow parameters of their own. Parameters and inputs keep the values
/// of the model's file for what is checked with it, and initial values are nominal. One place for each varied quantity of the scene, unless `diagnostics` has errors.
std::vector<Placed> vary(const Scene& scene, gaussgen::model::Model& to, gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
