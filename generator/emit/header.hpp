#pragma once
// A Unit as the text of one standalone C++ header.

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "emit/unit.hpp"
#include "passes/optimise.hpp"

namespace gaussgen::emit {

/// What the passes made of one function.
struct PassEffects {
  std::string function;
  std::vector<passes::PassEffect> passes;  ///< in the order in which they ran
};

/// How much of a header one output is.
struct OutputSize {
  std::string output;
  int operations = 0;  ///< as written: of a search, those of one step each
};

/// A header, and what it took to make it.
struct Header {
  std::string text;
  cpp::File tree;      ///< what `text` is printed from: for those that run it without a compiler
  std::string source;  ///< instantiates its functions for Unit::compiled_for; empty where that is
  std::vector<PassEffects> passes;
  std::vector<OutputSize> outputs;                ///< in their order
  std::chrono::steady_clock::time_point planned;  ///< when nothing was left but to write it
  std::size_t nodes_planned = 0;                  ///< of the graph, then
  std::size_t nodes = 0;                          ///< of the graph, in the end
};

/// Same unit, same bytes of text. The graph is for this only: preparing and printing add to it.
Header build_header(ir::Graph graph, const Unit& unit);

/// Its text.
std::string emit_header(ir::Graph graph, const Unit& unit);

/// The text of src/gauss/math.hpp, which every header carries.
std::string_view prelude();

/// src/gauss/constrained.hpp, without the include of math.hpp.
std::string_view constrained_prelude();

/// src/gauss/series_products.hpp, likewise.
std::string_view series_prelude();

}  // namespace gaussgen::emit
