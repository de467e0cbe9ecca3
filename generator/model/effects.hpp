#pragma once
// `effects:` named parts of a model that a scene may do without. They are chosen and put together before anything is read, so that
// nothing of the others is left. Private to the folder.

#include "model/reading.hpp"

namespace gaussgen::model {

/// A word of `effects`, and where it stands; of an option it has no place.
struct ChoiceOfEffects {
  GivenEffects words = {};
  std::vector<support::Span> places = {};  ///< of each word, if they stand in a file
};

/// The file with the effects that act; the others are dropped, after their shape was checked. `all` takes what there is to know of them.
/// Throws WrongEffects for words without a place.
spec::Node with_chosen_effects(spec::Node root, const ChoiceOfEffects& choice, std::vector<Effect>& all,
                               Reading& reading);

/// The entries of the effects that are left, after those that the file has without them. An entry that is there already gets the
/// keys that it does not have.
spec::Node with_entries_of_effects(spec::Node root, Reading& reading);

}  // namespace gaussgen::model
