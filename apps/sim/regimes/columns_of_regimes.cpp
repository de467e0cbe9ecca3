#include "sim/regimes/columns_of_regimes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace {

const std::string k_group = "modes";

bool is_of_modes(const std::string& word) { return word == k_group || word.rfind(k_group + ".", 0) == 0; }

std::vector<std::string> switches_in(const Switches& switches) {
  std::vector<std::string> names;
  for (const ContactSwitch& contact : switches.contacts) names.push_back(contact.name);
  for (const FrictionSwitch& friction : switches.frictions) names.push_back(friction.name);
  names.insert(names.end(), switches.links.begin(), switches.links.end());
  return names;
}

/// Each contact closed by itself, with friction that sticks.
std::vector<Modes> richer(const Switches& switches) {
  std::vector<Modes> all;
  for (const ContactSwitch& contact : switches.contacts) {
    all.push_back(ground_of(switches));
    all.back()[contact.name] = "closed";
  }
  if (all.empty()) all.push_back(ground_of(switches));
  for (Modes& modes : all) {
    for (const FrictionSwitch& friction : switches.frictions) modes[friction.name] = "sticks";
  }
  return all;
}

Column column_of_mode(const std::string& name) {
  Column column;
  column.name = k_group + "." + name;
  column.unit = "1";
  column.about = name;
  return column;
}

Columns columns_of_modes(const Word& word, const std::vector<std::string>& names,
                         gaussgen::support::Diagnostics& diagnostics) {
  Columns found;
  std::vector<std::string> known;
  for (const std::string& name : names) {
    known.push_back(k_group + "." + name);
    if (word.text == k_group || word.text == known.back()) found.columns.push_back(column_of_mode(name));
  }
  if (found.columns.empty()) {
    const std::string near = gaussgen::support::did_you_mean(word.text, known);
    diagnostics.error(gaussgen::support::code::k_wrong_reference, word.span,
                      fmt::format("the model has no output '{}'", word.text),
                      near.empty() ? "there are " + gaussgen::support::joined(known) : near);
  }
  return found;
}

/// What is said of an unknown output, with the group that models without regimes do not have.
gaussgen::support::Diagnostic with_modes(gaussgen::support::Diagnostic said, const std::string& word) {
  static const std::string k_list = "there are ";
  const std::string near = gaussgen::support::did_you_mean(word, {k_group});
  if (!near.empty()) {
    said.hint = near;
  } else if (said.hint.rfind(k_list, 0) == 0) {
    said.hint.insert(k_list.size(), k_group + ", ");
  }
  return said;
}

}  // namespace

const std::string& switch_in_column(const Column& column) {
  static const std::string k_none;
  return is_of_modes(column.name) ? column.about : k_none;
}

double number_of_mode(const std::string& mode) {
  if (mode == "closed" || mode == "sticks" || mode == "holds") return 1;
  return mode == "slides" || mode == "forwards" ? 2 : mode == "backwards" ? -2 : 0;
}

Columns columns_of_regimes(const Described& ground, const std::vector<Word>& wanted, RegimeSource& regimes,
                           gaussgen::support::Diagnostics& diagnostics, const ListEverything& list) {
  const std::vector<std::string> names = switches_in(regimes.switches());
  std::vector<Word> of_model;
  Columns result;
  const auto add = [&](const Columns& more) {
    for (const Column& column : more.columns) {
      const auto is_same = [&](const Column& one) { return one.name == column.name; };
      if (std::none_of(result.columns.begin(), result.columns.end(), is_same)) result.columns.push_back(column);
    }
  };
  for (const Word& word : wanted) {
    if (!is_of_modes(word.text)) of_model.push_back(word);
  }
  const auto asks_beyond_state = [](const Word& word) { return word.text != "state" && word.text != "energy"; };
  std::vector<Described> others;
  if (std::any_of(of_model.begin(), of_model.end(), asks_beyond_state)) {
    for (const Modes& modes : richer(regimes.switches())) {
      if (auto described = regimes.described(modes)) others.push_back(std::move(*described));
    }
  }
  if (wanted.empty()) return choose_columns(ground, wanted, diagnostics, list);
  for (const Word& word : wanted) {
    if (is_of_modes(word.text)) {
      add(columns_of_modes(word, names, diagnostics));
      continue;
    }
    gaussgen::support::Diagnostics of_ground;
    add(choose_columns(ground, {word}, of_ground, list));
    bool is_known = !of_ground.has_errors();
    for (const Described& other : others) {
      gaussgen::support::Diagnostics ignored;
      add(choose_columns(other, {word}, ignored));
      is_known = is_known || !ignored.has_errors();
    }
    if (is_known) continue;
    for (const auto& one : of_ground.all()) diagnostics.add(with_modes(one, word.text));
  }
  return result;
}

}  // namespace gausssim
