#pragma once
// Derivatives of the motion and of its forces by anything they depend on: state, inputs, time, parameters.
//
// The accelerations a and multipliers λ of  g a = f + bᵀ λ,  b a + drift = 0  are differentiated with what they solve, not through the
// elimination:  g a' = (f' - g' a + b'ᵀ λ) + bᵀ λ',  b a' + (drift' + b' a) = 0  is the same system with other forces and drifts, and
// so another solve over the factors that are there already. Of a tree the equations of links are such a system, too, with a few terms each.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ir/differentiate.hpp"
#include "ir/symbol_sets.hpp"
#include "mechanics.hpp"
#include "strategy/tree_tangent.hpp"

namespace gaussgen {

/// How accelerations are differentiated.
enum class DerivativeMethod {
  implicit,  ///< by the system that they solve
  forward,   ///< through its solution, node by node: shorter where little is solved
  reverse,   ///< by the system, a row at a time: by all variables at once
  links,     ///< by the equations of links that a tree solves, each by itself
};

/// Those that give derivatives of the very expressions that are emitted, also where a quaternion is not of unit length: the system
/// that a tree does not form says something else there.
std::vector<DerivativeMethod> derivative_methods(const Mechanics& mechanics);

/// What a derivative is taken by. A parameter takes along the formulas that follow from it.
struct Variable {
  ir::SymbolId symbol;
  std::string name;
};

std::vector<Variable> state_variables(const Mechanics& mechanics);  ///< configuration, then speeds
std::vector<Variable> input_variables(const Mechanics& mechanics);
Variable time_variable(const Mechanics& mechanics);

/// Derivatives by one variable after another.
class Derivatives {
 public:
  /// By any of `variables`; `steps` gets what is computed, in words. Both last as long as this.
  Derivatives(Mechanics& mechanics, std::vector<Variable> variables, DerivativeMethod method, strategy::Steps& steps);

  std::size_t count() const { return variables_.size(); }

  /// From here on `operator()` is the derivative by the variable of this index.
  void by(std::size_t variable);

  /// The same with accelerations and multipliers as they are: forces and drifts that their derivatives by it are the answer to.
  strategy::Dynamics sides_by(std::size_t variable);

  ir::Expr operator()(ir::Expr function) { return (*along_)(function); }
  strategy::Vector operator()(const strategy::Vector& functions);

 private:
  void begin(std::size_t variable);
  void seed_formulas(ir::SymbolId symbol);
  strategy::Dynamics sides(const std::string& name);
  void solve(const std::string& name);
  void solve_along_links(const std::string& name);
  void follow(const strategy::Limb& limb, std::size_t index, ir::Directional& response);

  Mechanics& mechanics_;
  std::vector<Variable> variables_;
  DerivativeMethod method_;
  strategy::Steps& steps_;
  ir::SymbolSets dependence_;
  std::vector<std::size_t> dependent_rows_;
  std::optional<strategy::TreeTangent> tangent_;       ///< of links
  std::map<std::size_t, strategy::Matrix> responses_;  ///< of limbs: by each component before, of each speed
  std::optional<ir::Directional> along_;
};

/// What `rhs` fills: rates of the configuration, then accelerations.
strategy::Vector state_rates(const Mechanics& mechanics);

/// How many operations `jacobian` will take by a method, from some of its columns or rows: what the first one takes with all that is common, and
/// what others add to it.
double predicted_operations(Mechanics& mechanics, const std::vector<Variable>& variables, DerivativeMethod method);

/// ∂(rates of the state)/∂variables, a row for each rate. By parameters not in reverse.
strategy::Matrix jacobian(Mechanics& mechanics, const std::vector<Variable>& variables, DerivativeMethod method,
                          strategy::Steps& steps);

}  // namespace gaussgen
