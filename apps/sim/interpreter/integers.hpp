#pragma once
// Whole numbers in the text of a header: sizes of arrays, indices, bounds of loops.

#include <string>
#include <string_view>
#include <unordered_map>

namespace gausssim {

/// Sums and products of numbers and names, such as `4 + 6 * i + k`.
class Integers {
 public:
  void set(const std::string& name, int value) { values_[name] = value; }

  bool has(const std::string& name) const { return values_.count(name) != 0; }

  /// Throws std::invalid_argument where the text is anything else.
  int operator()(std::string_view text) const;

 private:
  int sum(std::string_view text) const;
  int product(std::string_view text) const;
  int factor(std::string_view text) const;

  std::unordered_map<std::string, int> values_;
};

}  // namespace gausssim
