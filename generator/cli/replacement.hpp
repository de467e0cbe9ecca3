#pragma once
// Writing a file so that nobody ever sees half of one.

#include <string>

namespace gaussgen::cli {

/// New text for a file. The text is written beside the file when this object is made; `commit` puts it in place by renaming,
/// so that a reader sees the old file or the whole new one. Without `commit` nothing remains. A file that already has this text
/// is left alone, and build systems then rebuild nothing. Devices and pipes cannot be renamed to: they are written to.
///
/// The constructor and `commit` throw FileError.
class Replacement {
 public:
  Replacement(const std::string& path, const std::string& text);
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement();

  void commit();

 private:
  void write(const std::string& text);

  std::string path_;       ///< for messages
  std::string target_;     ///< links followed
  std::string temporary_;  ///< empty: nothing to rename
  std::string stream_;     ///< text for a device or a pipe
  int descriptor_ = -1;
};

/// Writes a file that must not exist yet. Throws FileError.
void write_new_file(const std::string& path, const std::string& text);

}  // namespace gaussgen::cli
