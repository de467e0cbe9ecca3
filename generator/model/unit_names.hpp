#pragma once
// The names of units, with and without prefixes.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/dimension.hpp"

namespace gaussgen::model {

struct KnownUnit {
  Dimension dimension;
  bool is_coherent = true;  ///< one of it is one of SI: "N" and "kg", not "kN" and "g"
};

/// Nothing for a name that is no unit.
std::optional<KnownUnit> find_unit(std::string_view name);

/// For suggestions: every name without prefix.
std::vector<std::string> unit_names();

/// What to write for a name that is no unit: "write 'N*m'" for Nm, "write 'm'" for metre, "did you mean 'Pa'?"; never empty.
std::string hint_for_unit(const std::string& name);

}  // namespace gaussgen::model
