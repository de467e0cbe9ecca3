#pragma once
// The words that scenes and options choose from.

#include <string>
#include <vector>

namespace gausssim {

const std::vector<std::string>& method_names();
const std::vector<std::string>& number_names();
const std::vector<std::string>& projection_names();
const std::vector<std::string>& strategy_names();
const std::vector<std::string>& engine_names();
const std::vector<std::string>& code_names();

/// What studies call a form of a scene by a strategy that the scene does not name.
std::string form_by_strategy(const std::string& form, const std::string& strategy);

}  // namespace gausssim
