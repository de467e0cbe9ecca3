#include "sim/effects/moves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/suggest.hpp"

namespace gausssim {

namespace {

using gaussgen::model::Effect;

bool needs(const Effect& effect, const std::string& name) {
  return std::any_of(effect.needs.begin(), effect.needs.end(), [&](const auto& one) { return one.text == name; });
}

bool excludes(const Effect& effect, const std::string& name) {
  return std::any_of(effect.excludes.begin(), effect.excludes.end(), [&](const auto& one) { return one.text == name; });
}

/// Without an effect, and without those that need it; nothing where one of these is the choice of several.
bool drop(EffectSet& acting, const std::string& name, const std::vector<Effect>& effects) {
  acting.erase(name);
  return std::all_of(effects.begin(), effects.end(), [&](const Effect& effect) {
    if (acting.count(effect.name.text) == 0 || !needs(effect, name)) return true;
    return !effect.one_of && drop(acting, effect.name.text, effects);
  });
}

/// That went along with `name`.
std::string others_in_words(const EffectSet& before, const EffectSet& left, const std::string& name) {
  std::vector<std::string> others;
  for (const std::string& one : before) {
    if (one != name && left.count(one) == 0) others.push_back(one);
  }
  return others.empty() ? "" : fmt::format(" (and {})", gaussgen::support::joined(others));
}

bool goes_with(const Effect& effect, const EffectSet& acting, const std::vector<Effect>& effects) {
  for (const auto& name : effect.needs) {
    if (acting.count(name.text) == 0) return false;
  }
  return std::none_of(effects.begin(), effects.end(), [&](const Effect& other) {
    const std::string& name = other.name.text;
    return acting.count(name) > 0 && (excludes(effect, name) || excludes(other, effect.name.text));
  });
}

}  // namespace

std::vector<Move> moves_from(const EffectSet& acting, const std::vector<Effect>& effects) {
  std::vector<Move> moves;
  for (const Effect& effect : effects) {
    const std::string& name = effect.name.text;
    if (acting.count(name) == 0) continue;
    EffectSet left = acting;
    if (!drop(left, name, effects)) continue;
    const std::string others = others_in_words(acting, left, name);
    if (!effect.one_of) {
      moves.push_back({fmt::format("without {}{}", name, others), std::move(left)});
      continue;
    }
    for (const Effect& other : effects) {
      const bool is_alternative = other.one_of && other.one_of->text == effect.one_of->text && other.name.text != name;
      if (!is_alternative || !goes_with(other, left, effects)) continue;
      EffectSet with = left;
      with.insert(other.name.text);
      moves.push_back({fmt::format("{} instead of {}{}", other.name.text, name, others), std::move(with), true});
    }
  }
  return moves;
}

std::vector<std::string> in_order(const EffectSet& acting, const std::vector<Effect>& effects) {
  std::vector<std::string> names;
  for (const Effect& effect : effects) {
    if (acting.count(effect.name.text) > 0) names.push_back(effect.name.text);
  }
  if (names.empty()) names.emplace_back("none");
  return names;
}

}  // namespace gausssim
