// The page that shows a study: docs/study-format.md.
#pragma once

#include <string_view>

namespace gausssim {

// HTML in UTF-8, with `report_placeholder` once in it, in an element of JSON. Whoever puts a study there writes each `<` of it as \u003c,
// so that no name of a model can end the element, and leaves the rest as it is: the page allows its script by its hash.
std::string_view report_template();

inline constexpr std::string_view report_placeholder = "@STUDY@";

}  // namespace gausssim
