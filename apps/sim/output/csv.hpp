#pragma once
// A table as text: one row per sample, all digits.

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/drive/quad.hpp"
#include "sim/output/columns.hpp"

namespace gausssim {

/// The shortest decimal that is read as the same number.
inline std::string text_of(float value) { return fmt::format("{}", value); }
inline std::string text_of(double value) { return fmt::format("{}", value); }
inline std::string text_of(long double value) { return fmt::format("{}", value); }

/// `t [s],chi [rad],…`; names with commas or quotes are quoted (RFC 4180).
std::string csv_header(const std::vector<Column>& columns);

/// In two thirds of the time that a string for each number takes.
template <class S>
void append_text(std::string& text, const S& value) {
  if constexpr (std::is_floating_point_v<S>) {
    fmt::format_to(std::back_inserter(text), "{}", value);
  } else {
    text += text_of(value);
  }
}

/// The shortest decimals that are read as the same numbers.
template <class S>
void append_csv_row(std::string& text, const S& t, const S* row, std::size_t count) {
  append_text(text, t);
  for (std::size_t i = 0; i < count; ++i) {
    text += ',';
    append_text(text, row[i]);
  }
  text += '\n';
}

/// A file that appears under its name when it is complete; without `finish` nothing remains of it. "-" is standard output. Throws cli::FileError.
class CsvFile {
 public:
  explicit CsvFile(const std::string& path);
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;
  ~CsvFile();

  void write(const std::string& text);
  void finish();

 private:
  std::string path_, temporary_;
  std::FILE* file_ = nullptr;
};

}  // namespace gausssim
