#include "cli/assignments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/arguments.hpp"
#include "cli/usage_error.hpp"
#include "model/format.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

namespace {

/// At the first one: what is behind it may have others.
NameAndText at_first_equals(const char* option, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw UsageError(fmt::format("{}: expected name=value, not '{}'", option, assignment));
  const std::string name = trimmed(assignment.substr(0, equals));
  if (name.empty()) throw UsageError(fmt::format("{}: a name is missing before '=' in '{}'", option, assignment));
  return {name, assignment.substr(equals + 1)};
}

}  // namespace

NameAndText at_equals(const char* option, const std::string& assignment) {
  NameAndText found = at_first_equals(option, assignment);
  if (found.text.find('=') != std::string::npos)
    throw UsageError(
        fmt::format("{}: one value each, as in {} a=1 {} b=2, not '{}'", option, option, option, assignment));
  return found;
}

void refuse_second_of(const char* option, const std::string& name, const std::string& key,
                      std::set<std::string>& seen) {
  if (seen.insert(key).second) return;
  throw UsageError(fmt::format("{}: '{}' is given twice; leave one of the two out", option, name));
}

model::GivenCounts parse_counts(const std::vector<std::string>& assignments) {
  constexpr long long k_most = model::format::k_most_copies;
  model::GivenCounts counts;
  std::set<std::string> seen;
  for (const std::string& text : assignments) {
    const NameAndText given = at_equals("--count", text);
    const auto count = whole_number(trimmed(given.text), 0, k_most);
    if (!count)
      throw UsageError(fmt::format("--count {}: a whole number from 0 to {} is needed, not '{}'", given.name, k_most,
                                   trimmed(given.text)));
    refuse_second_of("--count", given.name, given.name, seen);
    counts[given.name] = *count;
  }
  return counts;
}

model::GivenRegime parse_regime(const std::vector<std::string>& assignments) {
  model::GivenRegime regime;
  std::set<std::string> seen;
  for (const std::string& text : assignments) {
    const NameAndText given = at_equals("--regime", text);
    refuse_second_of("--regime", given.name, given.name, seen);
    regime[given.name] = trimmed(given.text);
  }
  return regime;
}

std::vector<std::pair<std::string, std::vector<std::string>>> parse_variants(
    const std::vector<std::string>& assignments) {
  std::vector<std::pair<std::string, std::vector<std::string>>> variants;
  std::set<std::string> seen;
  for (const std::string& text : assignments) {
    const NameAndText given = at_first_equals("--variant", text);
    refuse_second_of("--variant", given.name, given.name, seen);
    const auto is_part_of_names = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (!std::all_of(given.name.begin(), given.name.end(), is_part_of_names))
      throw UsageError(fmt::format("--variant {}: it is a part of names in C++: letters, digits and '_'", given.name));
    std::vector<std::string> words;
    std::string word;
    for (const char c : given.text + ",") {
      if (c != ',') {
        word += c;
      } else {
        if (word = trimmed(word); !word.empty()) words.push_back(word);
        word.clear();
      }
    }
    variants.emplace_back(given.name, std::move(words));
  }
  return variants;
}

model::Choices choices_of_variant(const std::string& variant, const std::vector<std::string>& words,
                                  const model::Choices& common) {
  const std::string option = "--variant " + variant;
  model::Choices choices = common;
  choices.effects.clear();
  std::set<std::string> seen;
  for (const std::string& word : words) {
    if (word.find('=') == std::string::npos) {
      choices.effects.push_back(word);
      continue;
    }
    const NameAndText given = at_equals(option.c_str(), word);
    refuse_second_of(option.c_str(), given.name, given.name, seen);
    choices.regime[given.name] = trimmed(given.text);
  }
  return choices;
}

std::string unknown_count(const model::UnknownCount& unknown) {
  if (unknown.known().empty())
    return fmt::format("--count: the model has no '{}' that could be changed, since it has no 'counts'",
                       unknown.name());
  const std::string near = support::did_you_mean(unknown.name(), unknown.known());
  return fmt::format("--count: the model has no count '{}'; {}", unknown.name(),
                     near.empty() ? "its counts are " + support::joined(unknown.known()) : near);
}

std::string wrong_effects(const model::WrongEffects& wrong, const model::GivenEffects& words) {
  std::string text;
  for (const model::EffectMistake& one : wrong.mistakes())
    text += fmt::format("{}--effects {}: {}; {}", text.empty() ? "" : "\n", words[one.word], one.message, one.hint);
  return text;
}

}  // namespace gaussgen::cli
