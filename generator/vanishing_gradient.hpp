#pragma once
// Constraints that say nothing wherever they hold, as squares: (x - e)^2 = 0 has the gradient 2 (x - e), which is 0 with it. Theory §8: rank b = l is needed.

#include <optional>
#include <string>
#include <vector>

#include "model_values.hpp"
#include "support/source.hpp"

namespace gaussgen {

/// Whether its gradient vanishes where the constraint holds, though not elsewhere: from places that nothing singles out, Newton's method on it alone comes near by
/// the same factor in each step, as it does to a root of higher order and to no other.
bool vanishes_with_gradient(Mechanics& mechanics, std::size_t constraint);

/// Whether it may be so: at the state that is bound in `values`, its gradient is small beside what its entries are made of.
bool has_small_gradient(Mechanics& mechanics, ModelValues& values, std::size_t constraint);

/// "constraint 'c' holds nothing: …"
std::string holds_nothing(const model::Constraint& constraint);

/// Of the law of such a constraint, what it has to say instead: "x - e" of (x - e)^2; nothing where that is not plain to see.
std::optional<std::string> base_of_power(const model::Constraint& constraint, const support::Source& source);

}  // namespace gaussgen
