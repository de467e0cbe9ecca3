#pragma once
// Velocity constraints that say together less than their number.

#include <cstddef>
#include <string>
#include <vector>

#include "model_values.hpp"

namespace gaussgen {

/// What dependent rows Σ c_μ b_μ = 0 ask of the motion: Σ c_μ φ_μ does not depend on velocities, nor Σ c_μ φ̇_μ on accelerations.
enum class Agreement {
  agree,
  contradictory_velocities,     ///< Σ c_μ φ_μ is not zero
  contradictory_accelerations,  ///< Σ c_μ Θ_μ is not, while the velocities of the state satisfy all φ_μ
};

/// A constraint whose gradient over the free speeds is a combination of those of others.
struct Dependence {
  std::size_t index = 0;            ///< into Model::constraints
  std::vector<std::size_t> others;  ///< those that it takes, no more; none where the gradient is zero
  bool everywhere =
      false;  ///< as many follow from others wherever the equations of positions hold: numbers show it, not the form of the expressions
  bool by_another = false;  ///< then: elsewhere this one does not, but another in its place
  Agreement agreement = Agreement::agree;
  bool is_exact = true;  ///< false: it has a part of its own, below the tolerance of ranks
};

/// At the state that is bound in `values`; nothing where a gradient has no value. Others come before it in the model, except for
/// those that the solution leaves out as redundant, which come last.
std::vector<Dependence> dependences(Mechanics& mechanics, ModelValues& values);

/// "constraints 'a', 'b' and 'c'"
std::string names_of(const Mechanics& mechanics, const std::vector<std::size_t>& constraints);

/// "constraints 'b' and 'c' follow from constraint 'a'"
std::string dependence_in(const Mechanics& mechanics, const std::vector<std::size_t>& constraints,
                          const std::vector<std::size_t>& others);

/// "constraint 'b' follows from constraint 'a'"
std::string dependence_in(const Mechanics& mechanics, const Dependence& found);

/// "no velocities satisfy constraints 'a' and 'b' together"; empty where they agree.
std::string contradiction_in(const Mechanics& mechanics, const Dependence& found);

}  // namespace gaussgen
