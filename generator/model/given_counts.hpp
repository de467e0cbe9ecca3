#pragma once
// Counts that the user gives beside the file, over those that it states.

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gaussgen::model {

/// By the names in `counts` of the model itself; those of submodels are their own.
using GivenCounts = std::map<std::string, std::int64_t>;

/// A count is given that the model does not have: a mistake outside the file, so it has no place in it.
class UnknownCount : public std::runtime_error {
 public:
  UnknownCount(std::string name, std::vector<std::string> known)
      : runtime_error("unknown count " + name), name_(std::move(name)), known_(std::move(known)) {}

  const std::string& name() const { return name_; }
  const std::vector<std::string>& known() const { return known_; }

 private:
  std::string name_;
  std::vector<std::string> known_;
};

}  // namespace gaussgen::model
