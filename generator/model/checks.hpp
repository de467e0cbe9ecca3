#pragma once
// What can be checked once every section is read. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// All of the below, in an order in which no finding follows from an earlier one.
void check_model(const spec::Node& root, Reading& reading);

/// Names resolve, and every expression uses only what is allowed at its place.
void check_domains(Reading& reading);

/// No cycles; parameters in dependency order; `is_formula`.
void order_parameters(Reading& reading);

}  // namespace gaussgen::model
