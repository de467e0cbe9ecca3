#pragma once
// What must hold of the bytes before YAML sees them: yaml-cpp passes bad encodings and controls on.

#include "support/diagnostics.hpp"

namespace gaussgen::spec {

inline constexpr std::size_t k_largest_file = 4U << 20U;

/// False when the text cannot be read further; each kind of trouble is reported at its first place.
bool check_text(const support::Source& source, support::Diagnostics& diagnostics);

/// Bytes of a leading UTF-8 byte order mark, which is allowed: 0 or 3.
std::size_t byte_order_mark(std::string_view text);

}  // namespace gaussgen::spec
