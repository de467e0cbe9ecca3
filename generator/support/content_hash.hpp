#pragma once

#include <string>
#include <string_view>

namespace gaussgen::support {

/// FNV-1a of 64 bits (Fowler, Noll, Vo), as 16 hexadecimal digits: tells texts apart, and guards against nobody.
std::string content_hash(std::string_view text);

}  // namespace gaussgen::support
