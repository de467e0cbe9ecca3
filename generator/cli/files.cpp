#include "cli/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace gaussgen::cli {

namespace {

namespace fs = std::filesystem;

/// Enough for every model; what is larger is refused before it is read into memory.
constexpr std::uintmax_t k_largest_input = std::uintmax_t{16} << 20U;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw FileError(path + ": " + what);
}

std::string read_stream(std::istream& in, const std::string& name) {
  std::string text;
  char block[65536];
  while (in.read(block, sizeof block) || in.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > k_largest_input) fail(name, "larger than 16 MiB");
  }
  if (in.bad()) fail(name, "cannot be read");
  return text;
}

std::optional<std::string> existing_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

/// A file that is removed again unless it is renamed to its target.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : target_(target), path_(target + ".XXXXXX") {
    descriptor_ = mkstemp(path_.data());
    if (descriptor_ < 0) fail(target, std::strerror(errno));
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!renamed_) unlink(path_.c_str());
  }

  void write(const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t count = ::write(descriptor_, text.data() + done, text.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) fail(target_, std::strerror(errno));
      done += static_cast<std::size_t>(count);
    }
    if (fsync(descriptor_) != 0) fail(target_, std::strerror(errno));
  }

  void rename() {
    // mkstemp creates files for the owner alone; a header is for everybody whom the umask allows.
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(descriptor_, 0666 & ~mask) != 0 || std::rename(path_.c_str(), target_.c_str()) != 0) {
      fail(target_, std::strerror(errno));
    }
    renamed_ = true;
  }

 private:
  std::string target_;
  std::string path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

support::Source read_source(const std::string& path) {
  if (path == "-") return {"<stdin>", read_stream(std::cin, "<stdin>")};
  std::error_code error;
  if (fs::is_directory(path, error)) fail(path, "is a directory");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, std::strerror(errno));
  return {path, read_stream(in, path)};
}

void write_file(const std::string& path, const std::string& text) {
  if (existing_text(path) == text) return;
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) fail(folder.string(), error.message());
  if (fs::is_directory(path, error)) fail(path, "is a directory");
  TemporaryFile file(path);
  file.write(text);
  file.rename();
}

void write_standard_output(const std::string& text) {
  std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
  std::cout.flush();
  if (!std::cout) throw FileError("standard output: cannot be written");
}

}  // namespace gaussgen::cli
