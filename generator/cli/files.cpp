#include "cli/files.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace gaussgen::cli {

namespace {

namespace fs = std::filesystem;

/// More than any model may have, so that the reader refuses what is cut off here; and /dev/zero comes to an end.
constexpr std::size_t k_most_read = std::size_t{16} << 20U;

std::string read_stream(std::istream& in, const std::string& name) {
  std::string text;
  char block[65536];
  while (text.size() <= k_most_read && (in.read(block, sizeof block) || in.gcount() > 0)) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) fail_on(name, "cannot be read");
  return text;
}

}  // namespace

void fail_on(const std::string& path, const std::string& what) { throw FileError(path + ": " + what); }

support::Source read_source(const std::string& path) {
  if (path == "-") return {"<stdin>", read_stream(std::cin, "<stdin>")};
  std::error_code error;
  if (fs::is_directory(path, error)) fail_on(path, "is a directory");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_on(path, std::strerror(errno));
  return {path, read_stream(in, path)};
}

void write_standard_output(const std::string& text) {
  std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
  std::cout.flush();
  if (!std::cout) throw FileError("standard output: cannot be written");
}

}  // namespace gaussgen::cli
