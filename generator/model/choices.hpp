#pragma once
// What the user chooses beside the file: counts over those that it states, and which of its effects act.

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gaussgen::model {

/// By the names in `counts` of the model itself; those of submodels are their own.
using GivenCounts = std::map<std::string, std::int64_t>;

/// In order: `all`, `none` or `default` may be the first word, the others are names of effects, with + or - in front. Without a word:
/// the default. Those of submodels are their own.
using GivenEffects = std::vector<std::string>;

/// The mode of each contact, dry friction and link that breaks, by name (docs/regimes.md); those that are not named have the first one
/// that they may have: open, sticks, holds.
using GivenRegime = std::map<std::string, std::string>;

struct Choices {
  GivenCounts counts = {};
  GivenEffects effects = {};
  GivenRegime regime = {};
  bool is_ground = false;  ///< contacts are open and friction is left out, where `regime` does not say otherwise
};

/// A mode is given of what the model does not have, or one that it does not take: likewise a mistake outside the file.
class WrongRegime : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A count is given that the model does not have: a mistake outside the file, so it has no place in it.
class UnknownCount : public std::runtime_error {
 public:
  UnknownCount(std::string name, std::vector<std::string> known)
      : runtime_error("unknown count " + name), name_(std::move(name)), known_(std::move(known)) {}

  const std::string& name() const { return name_; }
  const std::vector<std::string>& known() const { return known_; }

 private:
  std::string name_;
  std::vector<std::string> known_;
};

/// What is wrong with a word of GivenEffects.
struct EffectMistake {
  std::size_t word = 0;  ///< its index
  std::string message;
  std::string hint;
};

/// Effects are given that the model does not have, or that do not go together: likewise a mistake outside the file.
class WrongEffects : public std::runtime_error {
 public:
  explicit WrongEffects(std::vector<EffectMistake> mistakes)
      : runtime_error("wrong effects"), mistakes_(std::move(mistakes)) {}

  const std::vector<EffectMistake>& mistakes() const { return mistakes_; }

 private:
  std::vector<EffectMistake> mistakes_;
};

}  // namespace gaussgen::model
