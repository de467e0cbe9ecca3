#pragma once
// A picture of a table: a panel for each unit, one above the other.

#include <string>
#include <vector>

#include "sim/plot/table.hpp"

namespace gausssim::plot {

/// SVG. Lines of `columns` against `across`, as long as all of these; `title` is that of the document.
std::string chart(const TableColumn& across, const std::vector<const TableColumn*>& columns, const std::string& title);

}  // namespace gausssim::plot
