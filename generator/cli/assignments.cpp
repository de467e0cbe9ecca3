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

NameAndText at_equals(const char* option, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw UsageError(fmt::format("{}: expected name=value, not '{}'", option, assignment));
  const std::string name = trimmed(assignment.substr(0, equals));
  if (name.empty()) throw UsageError(fmt::format("{}: a name is missing before '=' in '{}'", option, assignment));
  if (assignment.find('=', equals + 1) != std::string::npos)
    throw UsageError(
        fmt::format("{}: one value each, as in {} a=1 {} b=2, not '{}'", option, option, option, assignment));
  return {name, assignment.substr(equals + 1)};
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

std::vector<std::pair<std::string, model::GivenEffects>> parse_variants(const std::vector<std::string>& assignments) {
  std::vector<std::pair<std::string, model::GivenEffects>> variants;
  std::set<std::string> seen;
  for (const std::string& text : assignments) {
    const NameAndText given = at_equals("--variant", text);
    refuse_second_of("--variant", given.name, given.name, seen);
    const auto is_part_of_names = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    if (!std::all_of(given.name.begin(), given.name.end(), is_part_of_names))
      throw UsageError(fmt::format("--variant {}: it is a part of names in C++: letters, digits and '_'", given.name));
    model::GivenEffects words;
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
