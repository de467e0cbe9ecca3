#pragma once
// NAME=VALUE on the command line.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/choices.hpp"

namespace gaussgen::cli {

std::string trimmed(const std::string& text);

struct NameAndText {
  std::string name;
  std::string text;  ///< of the value
};

/// Throws UsageError.
NameAndText at_equals(const char* option, const std::string& assignment);

/// Throws UsageError where `key`, for which the user wrote `name`, is in `seen`: the last would win without a word.
void refuse_second_of(const char* option, const std::string& name, const std::string& key, std::set<std::string>& seen);

/// Assignments such as n=50. Throws UsageError.
model::GivenCounts parse_counts(const std::vector<std::string>& assignments);

/// Assignments such as floor=closed. Throws UsageError.
model::GivenRegime parse_regime(const std::vector<std::string>& assignments);

/// Assignments such as far=gravity,air or resting=floor=closed: words of effects and of modes. Throws UsageError.
std::vector<std::pair<std::string, std::vector<std::string>>> parse_variants(
    const std::vector<std::string>& assignments);

/// What a variant chooses, beside `common`. Throws UsageError.
model::Choices choices_of_variant(const std::string& variant, const std::vector<std::string>& words,
                                  const model::Choices& common);

/// Why the model has no such count, for the user.
std::string unknown_count(const model::UnknownCount& unknown);

/// What is wrong with the words of --effects, each in a line.
std::string wrong_effects(const model::WrongEffects& wrong, const model::GivenEffects& words);

}  // namespace gaussgen::cli
