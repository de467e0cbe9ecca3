#include "cli/files.hpp"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "support/files.hpp"

namespace gaussgen::cli {

void fail_on(const std::string& path, const std::string& what) { throw FileError(path + ": " + what); }

namespace {

/// Kept, since it can be read once, and commands that take a model in several ways read it for each.
const std::string& standard_input() {
  static const std::optional<std::string> text = support::read_stream(std::cin);
  // The stream takes an error, as of a closed one, for the end.
  if (!text || std::ferror(stdin) != 0) fail_on("<stdin>", "cannot be read");
  return *text;
}

}  // namespace

support::Source read_source(const std::string& path) {
  if (path == "-") return {"<stdin>", standard_input(), support::read_regular_file};
  std::string why;
  std::optional<std::string> text = support::read_file(path, why);
  if (!text) fail_on(path, why);
  return {path, *std::move(text), support::read_regular_file};
}

void keep_what_was_read(const std::string& path, const support::Source& source) {
  for (const std::string& name : source.names()) {
    if (are_same_file(path, name)) fail_on(path, "the model was read from it, and would be lost: name another file");
  }
}

bool are_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return std::filesystem::is_regular_file(a, error);
  const std::filesystem::path first = std::filesystem::weakly_canonical(a, error);
  return !error && first == std::filesystem::weakly_canonical(b, error) && !std::filesystem::exists(first, error);
}

void write_standard_output(const std::string& text) {
  std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
  std::cout.flush();
  if (!std::cout) throw FileError("standard output: cannot be written");
}

}  // namespace gaussgen::cli
