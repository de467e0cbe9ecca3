#include "model/emitted_names.hpp"

#include <algorithm>
#include <array>

namespace gaussgen::model {

bool is_emitted_macro(std::string_view name) { return name.rfind("GAUSS_", 0) == 0; }

bool is_taken_in_gauss(std::string_view name) {
  constexpr std::array<std::string_view, 4> k_names{"ScalarLogic", "StandardMath", "adl", "name"};
  return std::find(k_names.begin(), k_names.end(), name) != k_names.end();
}

}  // namespace gaussgen::model
