#pragma once

#include "emit/cpp_tree.hpp"
#include "emit/plan.hpp"
#include "emit/split.hpp"

namespace gaussgen::emit {

/// `Prepared<S> prepare(const Parameters<S>&)`.
cpp::Function prepare_function(Plan& plan);

/// One function of the unit, in one piece.
FunctionCode artefact_function(Plan& plan, const Task& task);

/// Comment, name and type, without arguments and body.
cpp::Function declared(const Artefact& artefact);

/// One that calls others of the unit.
cpp::Function search_function(const Artefact& artefact);

}  // namespace gaussgen::emit
