#pragma once
// Where something is made that appears elsewhere when it is whole.

#include <filesystem>
#include <string>

namespace gausssim {

/// A folder of this process alone, gone with it. What killed processes have left in the cache goes when the next one is made there.
class WorkFolder {
 public:
  /// `cache` empty: in the temporary folder of the system, which is not ours to tidy.
  explicit WorkFolder(const std::filesystem::path& cache);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  bool is_there() const { return !path_.empty(); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace gausssim
