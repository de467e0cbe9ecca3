#pragma once
// A model text to a checked model.

#include <optional>

#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Nothing when there was an error; all errors of the text are in `diagnostics`. Texts of submodels are put behind `source`.
std::optional<Model> build_model(support::Source& source, support::Diagnostics& diagnostics);

}  // namespace gaussgen::model
