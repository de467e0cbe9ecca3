#pragma once
// Models come in and text goes out.

#include <stdexcept>
#include <string>

#include "support/source.hpp"

namespace gaussgen::cli {

/// A file that cannot be read or written; the message is for the user.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws a FileError about `path`.
[[noreturn]] void fail_on(const std::string& path, const std::string& what);

/// The text of a model file, or of standard input for "-".
support::Source read_source(const std::string& path);

/// Throws a FileError where what is to be written to `path` would take the place of a file that was read.
void keep_what_was_read(const std::string& path, const support::Source& source);

/// Whether both are one file, now or as soon as it is there.
bool are_same_file(const std::string& a, const std::string& b);

void write_standard_output(const std::string& text);

}  // namespace gaussgen::cli
