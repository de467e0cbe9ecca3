#pragma once
// A model text to a checked model.

#include <optional>

#include "model/given_counts.hpp"
#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Nothing when there was an error; all errors of the text are in `diagnostics`. Texts of submodels are put behind `source`.
/// `counts` go before those of the file. Throws UnknownCount.
std::optional<Model> build_model(support::Source& source, support::Diagnostics& diagnostics,
                                 const GivenCounts& counts = {});

}  // namespace gaussgen::model
