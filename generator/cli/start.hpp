#pragma once
// Where a model begins, for commands that compute numbers at its state.

#include "cli/options.hpp"
#include "mechanics.hpp"
#include "support/diagnostics.hpp"
#include "support/rational.hpp"

namespace gaussgen::cli {

/// Open positions, and with `--assemble` given ones too, satisfy the constraints, to `digits` digits.
void set_start(Mechanics& mechanics, model::Model& model, const support::Rational& time, int digits,
               const Options& options, support::Diagnostics& diagnostics);

}  // namespace gaussgen::cli
