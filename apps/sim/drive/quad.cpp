#include "sim/drive/quad.hpp"

#include <quadmath.h>

#include <array>

namespace gausssim {

std::string text_of(Quad value) {
  std::array<char, 64> text{};
  quadmath_snprintf(text.data(), text.size(), "%.36Qg", value);
  return text.data();
}

Quad quad_of(const std::string& text) { return ::strtoflt128(text.c_str(), nullptr); }

}  // namespace gausssim
