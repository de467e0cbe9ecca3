#pragma once
// Spaces that look like those of the indentation, and are letters to YAML.

#include "support/diagnostics.hpp"

namespace gaussgen::spec {

/// A no-break space, an ideographic one, or one of a width of its own.
bool is_foreign_space(char32_t value);

/// True, and a report, if what begins its line at `at` begins with one.
bool refuse_foreign_space(const support::Source& source, std::uint32_t at, support::Diagnostics& diagnostics);

/// Likewise, if one stands behind the ':' of the key that begins at `at`: to YAML, that is no ':'.
bool refuse_space_behind_key(const support::Source& source, std::uint32_t at, support::Diagnostics& diagnostics);

}  // namespace gaussgen::spec
