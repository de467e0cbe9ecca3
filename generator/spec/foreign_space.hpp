#pragma once
// Spaces that look like those of the indentation, and are letters to YAML.

#include "support/diagnostics.hpp"

namespace gaussgen::spec {

/// True, and a report, if what begins its line at `at` begins with one.
bool refuse_foreign_space(const support::Source& source, std::uint32_t at, support::Diagnostics& diagnostics);

}  // namespace gaussgen::spec
