#pragma once
// A model text to a checked model.

#include <optional>

#include "model/choices.hpp"
#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Nothing when there was an error; all errors of the text are in `diagnostics`. Texts of submodels are put behind `source`.
/// `choices` go before what the file says. Throws UnknownCount, WrongEffects.
std::optional<Model> build_model(support::Source& source, support::Diagnostics& diagnostics,
                                 const Choices& choices = {});

}  // namespace gaussgen::model
