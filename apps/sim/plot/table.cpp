#include "sim/plot/table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "cli/files.hpp"

namespace gausssim::plot {

namespace {

class Reader {
 public:
  Reader(std::string_view text, const std::string& path) : rest_(text), path_(path) {}

  bool is_at_end() const { return rest_.empty(); }

  /// The fields of the next line; quotes may hold commas, quotes and ends of lines.
  std::vector<std::string> line() {
    ++line_;
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    while (!rest_.empty()) {
      const char c = taken();
      if (is_quoted && c == '"' && !rest_.empty() && rest_.front() == '"') {
        fields.back() += taken();
      } else if (c == '"' && (is_quoted || fields.back().empty())) {
        is_quoted = !is_quoted;
      } else if (c == ',' && !is_quoted) {
        fields.emplace_back();
      } else if (c == '\n' && !is_quoted) {
        return fields;
      } else if (c != '\r' || is_quoted) {
        fields.back() += c;
      }
    }
    if (is_quoted) fail("a quote is not closed");
    return fields;
  }

  void add(const std::string& field, TableColumn& column) const {
    double value = std::numeric_limits<double>::quiet_NaN();
    const char* const end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    const bool is_number = stop == end && !field.empty() && error != std::errc::invalid_argument;
    std::string& why = field.empty() ? column.gap : column.no_number;
    column.goes_on = column.goes_on || (!field.empty() && !column.gap.empty());
    if (!is_number && why.empty()) why = at_line(fmt::format("'{}' in column '{}' is no number", field, column.name));
    column.values.push_back(value);
  }

  [[noreturn]] void fail(const std::string& what) const { throw gaussgen::cli::FileError(at_line(what)); }

 private:
  std::string at_line(const std::string& what) const { return fmt::format("{}:{}: {}", path_, line_, what); }

  char taken() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  std::string_view rest_;
  const std::string& path_;
  int line_ = 0;
};

TableColumn column_of(const std::string& header) {
  const std::size_t open = header.rfind(" [");
  if (open == std::string::npos || header.back() != ']') return {header, "", {}, "", "", false};
  return {header.substr(0, open), header.substr(open + 2, header.size() - open - 3), {}, "", "", false};
}

}  // namespace

std::vector<TableColumn> parse_table(std::string_view text, const std::string& path) {
  Reader reader(text, path);
  if (reader.is_at_end()) throw gaussgen::cli::FileError(path + ":1: the table is empty");
  std::vector<TableColumn> columns;
  for (const std::string& header : reader.line()) {
    if (header.empty()) reader.fail("a column has no name");
    columns.push_back(column_of(header));
  }
  while (!reader.is_at_end()) {
    const std::vector<std::string> fields = reader.line();
    if (fields.size() != columns.size())
      reader.fail(fmt::format("there are {} fields where the header has {}", fields.size(), columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) reader.add(fields[i], columns[i]);
  }
  if (columns.front().values.empty()) reader.fail("there are no rows under the header");
  return columns;
}

std::vector<TableColumn> read_table(const std::string& path) {
  const gaussgen::support::Source source = gaussgen::cli::read_source(path);
  return parse_table(source.text(), path);
}

}  // namespace gausssim::plot
