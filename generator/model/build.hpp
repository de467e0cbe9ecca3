#pragma once
// A model text to a checked model.

#include <optional>

#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Nothing when there was an error; all errors of the text are in `diagnostics`.
std::optional<Model> build_model(const support::Source& source, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
