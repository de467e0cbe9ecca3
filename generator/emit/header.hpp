#pragma once
// A Unit as the text of one standalone C++ header.

#include <string>
#include <string_view>

#include "emit/unit.hpp"

namespace gaussgen::emit {

struct Files {
  std::string header;
  std::string source;  ///< instantiates the functions of the header for Unit::compiled_for; empty where that is
};

/// Same unit, same bytes.
Files emit_files(const ir::Graph& graph, const Unit& unit);
std::string emit_header(const ir::Graph& graph, const Unit& unit);

/// The text of src/gauss/math.hpp, which every header carries.
std::string_view prelude();

}  // namespace gaussgen::emit
