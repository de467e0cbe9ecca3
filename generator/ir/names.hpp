#pragma once
// Each name of a graph once: nodes hold its number.

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

#include "ir/node.hpp"

namespace gaussgen::ir {

class Names {
 public:
  Names() { insert(""); }
  Names(const Names& other) : Names() {
    for (const std::string& name : other.names_) insert(name);
  }
  Names(Names&&) = default;
  Names& operator=(const Names&) = delete;
  Names& operator=(Names&&) = default;
  ~Names() = default;

  /// The number of a name; 0 of the empty one.
  NameId insert(const std::string& name) {
    if (const auto known = numbers_.find(name); known != numbers_.end()) return known->second;
    const NameId number{static_cast<std::uint32_t>(names_.size())};
    numbers_.emplace(names_.emplace_back(name), number);
    return number;
  }

  /// Stays valid while names are added.
  const std::string& operator[](NameId id) const { return names_[id.index]; }

 private:
  std::deque<std::string> names_;
  std::unordered_map<std::string_view, NameId> numbers_;  // of texts in names_, which do not move
};

}  // namespace gaussgen::ir
