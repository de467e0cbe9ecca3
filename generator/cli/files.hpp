#pragma once
// Reading a model and writing results so that nobody ever sees half of one.

#include <optional>
#include <stdexcept>
#include <string>

#include "support/source.hpp"

namespace gaussgen::cli {

/// A file that cannot be read or written; the message is for the user.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The text of a model file, or of standard input for "-".
support::Source read_source(const std::string& path);

/// Writes beside the target and renames, so that a reader sees the old file or the whole new one. A file that already has
/// this text is not touched: build systems then rebuild nothing.
void write_file(const std::string& path, const std::string& text);

void write_standard_output(const std::string& text);

}  // namespace gaussgen::cli
