#pragma once
// What can be checked once every section is read. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// All of the below, in an order in which no finding follows from an earlier one.
void check_model(Reading& reading);

/// Names resolve, and every expression uses only what is allowed at its place.
void check_domains(Reading& reading);

/// No cycles; parameters in dependency order; `is_formula`.
void order_parameters(Reading& reading);

/// Names outside expressions: components of generalized forces, dependent speeds.
void check_references(Reading& reading);

/// Parameters that derivatives are taken by. Wants ordered parameters.
void check_sensitivities(Reading& reading);

/// Divisions by zero, values that are not finite, negative masses. Wants ordered parameters.
void check_values(Reading& reading);

/// Jumps and kinks stay out of what is differentiated.
void check_smoothness(Reading& reading);

/// Forces are linear in reactions.
void check_reactions(Reading& reading);

/// There are bodies, they move, and every speed and constraint has something to act on.
void check_topology(Reading& reading);

/// Sums, functions and places get what fits them in units, where units are stated; formulas without a unit get the one that follows. Wants
/// ordered parameters.
void check_dimensions(Reading& reading);

/// Warns of units such as deg and mm, which look like a conversion that nobody makes.
void check_units(Reading& reading);

/// Warns of frequencies in Hz whose turns are taken for radians. Wants ordered parameters.
void check_frequencies(Reading& reading);

}  // namespace gaussgen::model
