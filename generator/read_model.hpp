#pragma once
// A model file as the later stages take it.

#include <optional>

#include "model/choices.hpp"
#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// The checked model without the rows that say nothing: of the three directions of a contact or of a coincidence, those in which
/// coordinates hold the motion already. Nothing when the file has errors. Throws model::UnknownCount.
std::optional<model::Model> read_model(support::Source& source, support::Diagnostics& diagnostics,
                                       const model::Choices& choices = {});

}  // namespace gaussgen
