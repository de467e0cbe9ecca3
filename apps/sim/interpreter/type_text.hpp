#pragma once
// Types as a header writes them.

#include <string>
#include <vector>

namespace gausssim {

/// const State<S>&: State; const typename Math<S>::Bool: Bool.
struct TypeText {
  std::string name;  ///< without what it is over
  bool is_const = false;
  bool is_reference = false;
};

TypeText type_in(std::string text);

inline std::string struct_in(const std::string& text) { return type_in(text).name; }

/// rates[12][n_v], and (&piece)[5].
struct ArrayName {
  std::string name;
  std::vector<std::string> extents;
};

ArrayName array_in(const std::string& text);

}  // namespace gausssim
