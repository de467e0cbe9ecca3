#include "instance_choice.hpp"

#include <algorithm>

namespace gaussgen {

namespace {

bool has_sign(const std::string& word) { return !word.empty() && (word.front() == '+' || word.front() == '-'); }

std::string name_in(const std::string& word) { return has_sign(word) ? word.substr(1) : word; }

bool is_first_of_choice(const std::string& word) { return word == "all" || word == "none" || word == "default"; }

}  // namespace

std::vector<PlacedWord> choice_of_instance(const std::vector<PlacedWord>& of_scene,
                                           const std::vector<PlacedWord>& own) {
  if (own.empty()) return of_scene;
  if (!has_sign(own.front().text)) return own;
  std::vector<PlacedWord> words;
  // A list of names is these alone: without the first of them it would begin with a sign, and so stand beside the default.
  const bool is_list = !of_scene.empty() && !has_sign(of_scene.front().text);
  if (is_list && !is_first_of_choice(of_scene.front().text)) words.push_back({"none", of_scene.front().span});
  for (const PlacedWord& word : of_scene) {
    const auto is_named = [&](const PlacedWord& one) { return name_in(one.text) == name_in(word.text); };
    if (std::none_of(own.begin(), own.end(), is_named)) words.push_back(word);
  }
  words.insert(words.end(), own.begin(), own.end());
  return words;
}

}  // namespace gaussgen
