#pragma once
// Expressions of a model that have no value, or numbers that no scalar type holds.

#include "emit/header.hpp"
#include "emit/unit.hpp"
#include "ir/substitute.hpp"
#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// Held coordinates and their rates as what they are held at.
ir::Substitution held_values(ModelGraph& mechanics);

/// An error for every expression that has no finite real value in any configuration, such as x/(y - y), at its innermost
/// part; else for speeds that do not stand for as many rates.
void check_values(ModelGraph& mechanics, support::Diagnostics& diagnostics);

/// An error where a speed's equation of motion has none, such as with a root taken where it begins.
void check_equations(Mechanics& mechanics, support::Diagnostics& diagnostics);

/// An error when numbers of the model multiply to one beyond the range of double, from which emitted code reads its constants.
void check_range(const ir::Graph& graph, const std::vector<ir::NodeId>& values, const model::Name& model,
                 support::Diagnostics& diagnostics);

/// Likewise, of all that `unit` computes.
void check_range(const ir::Graph& graph, const emit::Unit& unit, const model::Name& model,
                 support::Diagnostics& diagnostics);

/// The header; without text, with the same error, where it is a rewriting of the passes that makes such a number.
emit::Header header_in_range(ir::Graph graph, const emit::Unit& unit, const model::Name& model,
                             support::Diagnostics& diagnostics);

}  // namespace gaussgen
