#pragma once
// yaml-cpp reports where a scalar begins and what it decodes to; this finds the byte behind every
// decoded byte.

#include <cstdint>
#include <string>
#include <string_view>

#include "spec/node.hpp"

namespace gaussgen::spec {

enum class ScalarStyle { plain, single_quoted, double_quoted, block };

ScalarStyle style_at(std::string_view source, std::uint32_t begin, bool quoted);

/// `value` as decoded from the scalar that begins at byte `begin` of the source.
LocatedText align(std::string value, std::string_view source, std::uint32_t begin, ScalarStyle style);

/// Whether the quote that opens at `begin` is closed: yaml-cpp 0.7 accepts a file that ends inside one.
bool quote_is_closed(std::string_view source, std::uint32_t begin, ScalarStyle style);

}  // namespace gaussgen::spec
