#pragma once
// Which effects act: words of a user against what the effects say of each other. Private to the folder.

#include <optional>
#include <string>
#include <vector>

#include "model/choices.hpp"
#include "model/model.hpp"

namespace gaussgen::model {

/// What is wrong, and of which effect; without words, the defaults are.
struct WrongChoice {
  std::optional<std::size_t> word;    ///< index of the word that is to blame
  std::optional<std::size_t> effect;  ///< index of the effect, where it is about one
  std::string message;
  std::string hint;
};

/// Sets Effect::acts. Of effects with the same `one_of` one acts whatever the words are: that which they name, else the default.
std::vector<WrongChoice> choose_effects(std::vector<Effect>& effects, const GivenEffects& words);

/// all, none, default: no names of effects.
bool is_word_of_choice(const std::string& word);

}  // namespace gaussgen::model
