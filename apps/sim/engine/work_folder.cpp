#include "sim/engine/work_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <vector>

namespace gausssim {

namespace {

namespace fs = std::filesystem;

constexpr const char* k_prefix = "build-";

/// The kernel gives it up with the process, however that ends. -1: somebody else has it.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Its owner is gone; or nobody takes so long, where file systems have no locks.
bool is_stale(const fs::path& folder) {
  constexpr std::chrono::minutes k_new(1);  // it may not have its lock yet
  constexpr std::chrono::hours k_old(24);
  std::error_code error;
  const auto written = fs::last_write_time(folder, error);
  if (error) return false;
  const auto age = fs::file_time_type::clock::now() - written;
  if (age < k_new) return false;
  const int lock = locked(folder);
  if (lock >= 0) ::close(lock);
  return lock >= 0 || age > k_old;
}

void remove_stale(const fs::path& cache) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator entry(cache, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().rfind(k_prefix, 0) == 0) folders.push_back(entry->path());
  }
  for (const fs::path& folder : folders) {
    if (is_stale(folder)) fs::remove_all(folder, error);
  }
}

}  // namespace

WorkFolder::WorkFolder(const fs::path& cache) {
  std::error_code error;
  if (!cache.empty()) {
    fs::create_directories(cache, error);
    remove_stale(cache);
  }
  const fs::path parent = cache.empty() ? fs::temp_directory_path(error) : cache;
  std::string path = (parent / (std::string(k_prefix) + "XXXXXX")).string();
  if (::mkdtemp(path.data()) == nullptr) return;
  path_ = path;
  lock_ = locked(path_);
}

WorkFolder::~WorkFolder() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace gausssim
