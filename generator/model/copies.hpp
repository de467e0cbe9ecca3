#pragma once
// Names in the file of a submodel stand in the model with the name of the submodel in front; what is said of that file speaks
// as the file does. Private to the folder.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// What the names of each file have in front, in each copy of it; a file is told by the offset of its first byte.
class Copies {
 public:
  using Prefixes = std::set<std::string>;

  void add(std::uint32_t file, const std::string& prefix) { prefixes_[file].insert(prefix); }

  /// Those of the files of a submodel, which gets `prefix` in front.
  void add(const Copies& inside, const std::string& prefix);

  /// Of all files.
  std::size_t count() const;

  /// What `name` has in front that is not in the file in which `at` lies; empty for the first file.
  std::string prefix_of(const std::string& name, std::uint32_t at, const support::Source& source) const;

  /// The findings, each in the names of its file; what is wrong with all copies is said once.
  support::Diagnostics in_own_names(const support::Diagnostics& found, const support::Source& source) const;

 private:
  const Prefixes& prefixes_at(std::uint32_t at, const support::Source& source) const;

  std::map<std::uint32_t, Prefixes> prefixes_;
};

}  // namespace gaussgen::model
