#include "sim/scene/instances.hpp"

#include <algorithm>

#include "instance_choice.hpp"

namespace gausssim {

namespace {

std::vector<gaussgen::PlacedWord> placed(const std::vector<Word>& words) {
  std::vector<gaussgen::PlacedWord> result;
  for (const Word& word : words) result.push_back({word.text, word.span});
  return result;
}

/// Values of the instance take the place of those with the same names.
void put_over(const std::vector<Given>& own, std::vector<Given>& all) {
  for (const Given& given : own) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const Given& one) { return one.name == given.name; });
    if (same == all.end())
      all.push_back(given);
    else
      *same = given;
  }
}

void put_number(const char* key, const std::optional<double>& own, const Instance& one, std::optional<double>& to,
                Scene& scene) {
  if (!own) return;
  to = own;
  scene.places[key] = one.places.at(key);
}

}  // namespace

const Instance* find_instance(const Scene& scene, const std::string& name) {
  const auto& all = scene.instances;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Instance& one) { return one.name.text == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> instance_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Instance& one : scene.instances) names.push_back(one.name.text);
  return names;
}

void take_instance(const Instance& one, Scene& scene) {
  const std::vector<gaussgen::PlacedWord> words =
      gaussgen::choice_of_instance(placed(scene.effects), placed(one.effects));
  scene.effects.clear();
  for (const gaussgen::PlacedWord& word : words) scene.effects.push_back({word.text, word.span});
  put_over(one.parameters, scene.parameters);
  put_over(one.initial, scene.initial);
  put_over(one.inputs, scene.inputs);
  put_over(one.exact, scene.exact);
  if (!one.outputs.empty()) scene.outputs = one.outputs;
  if (one.method) scene.method = one.method;
  put_number("tolerance", one.tolerance, one, scene.tolerance, scene);
  put_number("step", one.step, one, scene.step, scene);
  put_number("longest_step", one.longest_step, one, scene.longest_step, scene);
  if (!one.about.empty()) scene.about = one.about;
  scene.instance = one.name.text;
  scene.instances.clear();
}

}  // namespace gausssim
