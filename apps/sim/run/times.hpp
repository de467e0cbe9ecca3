#pragma once
// When a run begins and ends, and when it is looked at.

#include "model/evaluate.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

struct Span {
  double start = 0, duration = 10;
  long samples = 501;
  double every = 0;  ///< what somebody has said is between two samples; 0: nobody has
};

/// Those of the scene, in which there may be parameters. Throws cli::UsageError where an option says what cannot be.
Span read_times(const Scene& scene, const gaussgen::model::Values& parameters,
                gaussgen::support::Diagnostics& diagnostics);

}  // namespace gausssim
