#pragma once
// A whole model as text, to compare two ways of writing it.

#include <stdexcept>
#include <string>

#include "building.hpp"
#include "dumps.hpp"

namespace test {

inline std::string written_out(const Built& built) {
  if (!built.model) throw std::runtime_error(gaussgen::support::render(built.diagnostics, built.source));
  return gaussgen::dump_model(*built.model, built.source);
}

inline std::string written_out(const std::string& text) { return written_out(Built(text)); }

}  // namespace test
