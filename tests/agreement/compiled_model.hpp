#pragma once
// A compiled header behind one interface, so that one test serves every model.

#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace agreement {

/// Results of a struct of scalars, member by member.
template <class Struct>
std::vector<double> flattened(const Struct& result) {
  static_assert(sizeof(Struct) % sizeof(double) == 0, "a result struct holds scalars only");
  std::vector<double> values(sizeof(Struct) / sizeof(double));
  std::memcpy(values.data(), &result, sizeof(Struct));
  return values;
}

/// What a compiled model answers at one state, as plain numbers.
struct CompiledModel {
  std::string file;  ///< below models/, without .yaml
  std::vector<double> parameters;
  std::function<void(double, const std::vector<double>&)> set;  ///< time and state
  std::function<std::vector<double>()> rhs, energy, mass_matrix;
  std::function<std::vector<double>()> reactions, reaction_forces;  ///< empty without constraints
  /// What one call of rhs_and_reactions finds; empty without constraints.
  std::function<std::pair<std::vector<double>, std::vector<double>>()> rhs_and_reactions;
  /// Of the accelerations found by rhs; empty where the model has none.
  std::function<std::vector<double>()> residuals, compulsion;
};

const std::vector<CompiledModel>& compiled_models();

}  // namespace agreement
