#pragma once
// `gauss-sim methods`.

#include <string>

namespace gausssim {

/// All that are known, as a table for readers or as JSON.
std::string listed_methods(bool is_json);

}  // namespace gausssim
