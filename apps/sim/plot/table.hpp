#pragma once
// A table as `gauss-sim run` writes it.

#include <string>
#include <string_view>
#include <vector>

namespace gausssim::plot {

struct TableColumn {
  std::string name, unit;  ///< of a header such as `chi [rad]`; the unit may be empty
  std::vector<double> values;
  std::string no_number;  ///< why it cannot be drawn: a field of it, with its line; empty where all are numbers
  std::string gap;        ///< the same of the first field that is empty; its value is NaN
  bool goes_on = false;   ///< there is a value behind it
};

/// The columns of a CSV file with a header (RFC 4180). Throws cli::FileError with file and line where it is none.
std::vector<TableColumn> read_table(const std::string& path);

/// The same of a text; `path` is for messages.
std::vector<TableColumn> parse_table(std::string_view text, const std::string& path);

}  // namespace gausssim::plot
