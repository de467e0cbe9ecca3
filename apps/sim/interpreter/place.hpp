#pragma once
// What a name in a header refers to, as it is written: `prepared.m`, `state.chi()`, `jacobian.of_rates[4 + k]`.

#include <string_view>
#include <vector>

namespace gausssim {

/// Parts of a text that has to live on.
struct Place {
  std::string_view object;  ///< up to the first dot
  std::string_view member;  ///< with the group that it is in; empty: the object itself
  bool is_access = false;   ///< by a member function
  std::vector<std::string_view> indices;
};

/// Throws std::invalid_argument where the text is something else.
Place place_of(std::string_view text);

}  // namespace gausssim
