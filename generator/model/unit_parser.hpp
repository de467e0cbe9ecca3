#pragma once
// The text of a unit, "kg*m^2/s", to its dimension.

#include <optional>

#include "model/dimension.hpp"
#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Names, 1, * (or a middle dot), /, ^ (or raised digits) and round brackets, from left to right as in expressions.
/// Nothing after a mistake, which is reported at its place.
std::optional<Dimension> parse_unit(const spec::LocatedText& text, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
