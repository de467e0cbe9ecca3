#pragma once
// A picture of a table: a panel for each unit, one above the other.

#include <string>
#include <vector>

#include "sim/plot/table.hpp"

namespace gausssim::plot {

/// How values that follow each other belong together.
struct Bonds {
  bool are_there = true;                ///< else there are dots
  const TableColumn* within = nullptr;  ///< a line ends where this one's value changes; null: nowhere
};

/// SVG. Lines of `columns` against `x`, as long as all of these; `title` is that of the document.
std::string chart(const TableColumn& x, const std::vector<const TableColumn*>& columns, const std::string& title,
                  const Bonds& bonds = {});

}  // namespace gausssim::plot
