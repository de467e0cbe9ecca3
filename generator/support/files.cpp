#include "support/files.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace gaussgen::support {

namespace fs = std::filesystem;

std::optional<std::string> read_stream(std::istream& in) {
  std::string text;
  char block[65536];
  while (text.size() <= k_most_read && (in.read(block, sizeof block) || in.gcount() > 0)) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) return std::nullopt;
  return text;
}

std::optional<std::string> read_file(const std::string& path, std::string& why) {
  std::error_code error;
  why = "is a directory";
  if (fs::is_directory(path, error)) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  why = std::strerror(errno);
  if (!in) return std::nullopt;
  why = "cannot be read";
  return read_stream(in);
}

std::optional<std::string> read_regular_file(const std::string& path, std::string& why) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  why = "is no regular file";
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return std::nullopt;
  return read_file(path, why);
}

}  // namespace gaussgen::support
