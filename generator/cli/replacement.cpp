#include "cli/replacement.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cli/files.hpp"

namespace gaussgen::cli {

namespace {

namespace fs = std::filesystem;

bool has_text(const fs::path& path, const std::string& text) {
  std::error_code error;
  if (fs::file_size(path, error) != text.size() || error) return false;
  std::ifstream in(path, std::ios::binary);
  return in &&
         std::equal(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>(), text.begin(), text.end());
}

void make_folder_of(const fs::path& path) {
  const fs::path folder = path.parent_path();
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) fail_on(folder.string(), error.message());
}

void write_all(int descriptor, const std::string& text, const std::string& path) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail_on(path, std::strerror(errno));
    done += static_cast<std::size_t>(count);
  }
}

/// mkstemp creates files for the owner alone; a header is for everybody whom the umask allows.
mode_t usual_mode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

}  // namespace

Replacement::Replacement(const std::string& path, const std::string& text) : path_(path), target_(path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail_on(path, "is a directory");
  const bool is_new = !fs::exists(status);
  if (!is_new && !fs::is_regular_file(status)) {
    stream_ = text;
    return;
  }
  // A link stays a link: what it leads to is replaced.
  if (!is_new && fs::is_symlink(fs::symlink_status(path, error))) target_ = fs::canonical(path, error).string();
  if (!is_new && has_text(target_, text)) return;
  make_folder_of(target_);
  write(text);
}

Replacement::~Replacement() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void Replacement::write(const std::string& text) {
  std::string name = target_ + ".XXXXXX";
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail_on(path_, std::strerror(errno));
  temporary_ = name;
  // Only a constructor that ends is followed by the destructor.
  try {
    write_all(descriptor_, text, path_);
    if (fchmod(descriptor_, usual_mode()) != 0 || fsync(descriptor_) != 0) fail_on(path_, std::strerror(errno));
  } catch (const FileError&) {
    close(descriptor_);
    unlink(temporary_.c_str());
    throw;
  }
}

void Replacement::commit() {
  if (!stream_.empty()) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail_on(path_, std::strerror(errno));
    write_all(descriptor_, stream_, path_);
  }
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail_on(path_, std::strerror(errno));
  temporary_.clear();
}

void write_new_file(const std::string& path, const std::string& text) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_on(path, errno == EEXIST ? "is there already and stays as it is" : std::strerror(errno));
  try {
    write_all(descriptor, text, path);
  } catch (const FileError&) {
    close(descriptor);
    unlink(path.c_str());
    throw;
  }
  if (close(descriptor) != 0) fail_on(path, std::strerror(errno));
}

}  // namespace gaussgen::cli
