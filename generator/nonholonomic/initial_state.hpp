#pragma once

#include <map>
#include <string>

#include "gauss/system.hpp"

namespace gaussgen::nonholonomic {

/// Numbers for every symbol of the chart, from the model's values and initial state; rates that the model leaves open
/// get some value that is nothing special. For choices at generation time, never for output.
GiNaC::exmap initial_state(const model::Model& model, const gauss::Chart& chart);

/// f there; 0 when it has no finite real value.
double evaluate(const gauss::ex& f, const GiNaC::exmap& state);

}  // namespace gaussgen::nonholonomic
