#pragma once
// The page that shows a study (docs/study-format.md), whoever has measured it.

#include <nlohmann/json.hpp>
#include <string>

namespace gausssim {

/// `format`, `tool` and `machine` of a study, to which its problems are added.
nlohmann::ordered_json head_of_study();

/// HTML, with the study in it and nothing outside.
std::string page_of(const nlohmann::ordered_json& study);

}  // namespace gausssim
