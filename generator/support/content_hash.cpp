#include "support/content_hash.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace gaussgen::support {

std::string content_hash(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001B3U;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace gaussgen::support
