#pragma once
// What to say about a character that an expression may not contain.

#include <string>

namespace gaussgen::model {

struct CharacterAdvice {
  std::string name;  ///< "'θ' (U+03B8, Greek small letter theta)"
  std::string hint;
};

CharacterAdvice advise(char32_t value);

}  // namespace gaussgen::model
