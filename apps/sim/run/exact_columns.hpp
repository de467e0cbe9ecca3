#pragma once
// Which columns of a table somebody knows as functions of time.

#include <vector>

#include "model/evaluate.hpp"
#include "model/model.hpp"
#include "sim/output/columns.hpp"
#include "sim/run/times.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Closed forms of the scene are of columns, over time and parameters.
void check_exact(const Scene& scene, const Columns& columns, gaussgen::model::Values values,
                 gaussgen::support::Diagnostics& diagnostics);

/// Those of the model's file: of its own initial state, at a time that begins with 0. What the scene says itself counts more.
void take_exact_of_model(const std::vector<gaussgen::model::ClosedForm>& of_model, const Columns& columns,
                         const Span& span, gaussgen::model::Values values, Scene& scene);

}  // namespace gausssim
