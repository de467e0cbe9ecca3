#include "model/effect_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "support/suggest.hpp"

namespace gaussgen::model {

namespace {

/// How it came that an effect acts or not.
struct Verdict {
  bool acts = false;
  std::optional<std::size_t> word = std::nullopt;  ///< that names it
};

std::vector<std::string> names_of(const std::vector<Effect>& effects) {
  std::vector<std::string> names;
  names.reserve(effects.size());
  for (const Effect& effect : effects) names.push_back(effect.name.text);
  return names;
}

bool has_sign(const std::string& word) { return !word.empty() && (word.front() == '+' || word.front() == '-'); }

class Choosing {
 public:
  Choosing(const std::vector<Effect>& effects, const GivenEffects& words)
      : effects_(effects), words_(words), verdicts_(effects.size()) {}

  std::vector<Verdict> run() {
    begin();
    for (std::size_t i = 0; i < words_.size(); ++i) take(i);
    for (std::size_t i = 0; i < effects_.size(); ++i) choose_one_of(i);
    for (std::size_t i = 0; i < effects_.size(); ++i) {
      if (!verdicts_[i].acts) continue;
      check_needs(i);
      check_excludes(i);
    }
    return std::move(verdicts_);
  }

  std::vector<WrongChoice> take_mistakes() { return std::move(mistakes_); }

 private:
  void begin() {
    const std::string first = words_.empty() ? "default" : words_.front();
    const bool is_all = first == "all";
    const bool is_default = first == "default" || has_sign(first);
    for (std::size_t i = 0; i < effects_.size(); ++i)
      verdicts_[i].acts = (is_all && !effects_[i].one_of) || ((is_all || is_default) && effects_[i].by_default);
  }

  void take(std::size_t index) {
    const std::string& word = words_[index];
    if (is_word_of_choice(word)) {
      if (index > 0)
        refuse(index, {}, fmt::format("'{}' stands behind other words", word),
               fmt::format("write it first, as in [{}, -{}]", word, effects_.empty() ? "x" : effects_[0].name.text));
      return;
    }
    const std::string name = has_sign(word) ? word.substr(1) : word;
    const std::optional<std::size_t> effect = find(name);
    if (!effect) return refuse_unknown(index, name);
    Verdict& verdict = verdicts_[*effect];
    if (verdict.word)
      return refuse(index, effect, fmt::format("'{}' is chosen twice", name), "remove one of the two words");
    verdict = {word.front() != '-', index};
  }

  void refuse_unknown(std::size_t index, const std::string& name) {
    const std::vector<std::string> known = names_of(effects_);
    const std::string near = support::did_you_mean(name, known);
    refuse(index, {}, fmt::format("there is no effect '{}'", name),
           name.find_first_of(", ") != std::string::npos ? "several are a list, as in [gravity, air]"
           : !near.empty()                               ? near
           : known.empty()                               ? "the model has no effects"
                                                         : "its effects are " + support::joined(known));
  }

  std::optional<std::size_t> find(const std::string& name) const {
    const auto found =
        std::find_if(effects_.begin(), effects_.end(), [&](const Effect& effect) { return effect.name.text == name; });
    if (found == effects_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - effects_.begin());
  }

  /// Once for each choice, at the first effect in it.
  void choose_one_of(std::size_t first) {
    const std::vector<std::size_t> rivals = rivals_of(first);
    if (rivals.empty() || rivals.front() != first) return;
    std::vector<std::size_t> named;
    std::optional<std::size_t> removed;
    std::optional<std::size_t> usual;
    for (const std::size_t i : rivals) {
      if (verdicts_[i].acts && verdicts_[i].word) named.push_back(i);
      if (effects_[i].by_default) usual = i;
      if (effects_[i].by_default && !verdicts_[i].acts && verdicts_[i].word) removed = i;
    }
    if (named.empty() && removed) return refuse_removal(*removed, rivals);
    const std::optional<std::size_t> winner = named.empty() ? usual : named.front();
    for (const std::size_t i : rivals) verdicts_[i].acts = i == winner;
    if (named.size() > 1) refuse_rivals(named[0], named[1]);
  }

  std::vector<std::size_t> rivals_of(std::size_t effect) const {
    std::vector<std::size_t> rivals;
    const auto& choice = effects_[effect].one_of;
    for (std::size_t i = 0; i < effects_.size() && choice; ++i) {
      if (effects_[i].one_of && effects_[i].one_of->text == choice->text) rivals.push_back(i);
    }
    return rivals;
  }

  void refuse_removal(std::size_t removed, const std::vector<std::size_t>& rivals) {
    std::vector<std::string> others;
    for (const std::size_t i : rivals) {
      if (i != removed) others.push_back(effects_[i].name.text);
    }
    refuse(verdicts_[removed].word, removed,
           fmt::format("without '{}', nothing of '{}' acts", name_of(removed), effects_[removed].one_of->text),
           others.empty() ? "leave it in" : "name another one: " + support::joined(others));
  }

  void refuse_rivals(std::size_t a, std::size_t b) {
    if (*verdicts_[a].word > *verdicts_[b].word) std::swap(a, b);
    refuse(verdicts_[b].word, b,
           fmt::format("'{}' and '{}' do not act together: of '{}' one acts", name_of(a), name_of(b),
                       effects_[a].one_of->text),
           "remove one of the two");
  }

  void check_needs(std::size_t effect) {
    for (const Name& need : effects_[effect].needs) {
      const std::optional<std::size_t> needed = find(need.text);
      if (!needed || verdicts_[*needed].acts) continue;
      refuse(blamed(*needed, effect), effect,
             fmt::format("'{}' requires '{}', which does not act", name_of(effect), need.text),
             words_.empty() ? fmt::format("write 'default: on' at '{}', too, or leave it out here", need.text)
             : verdicts_[*needed].word ? fmt::format("leave '{}' out, too, or let '{}' act", name_of(effect), need.text)
                                       : fmt::format("add '{}', or leave '{}' out", need.text, name_of(effect)));
    }
  }

  void check_excludes(std::size_t effect) {
    for (const Name& other : effects_[effect].excludes) {
      const std::optional<std::size_t> excluded = find(other.text);
      if (!excluded || !verdicts_[*excluded].acts) continue;
      const bool is_said_by_both = excludes(*excluded, effect) && *excluded < effect;
      if (is_said_by_both) continue;
      refuse(later(effect, *excluded), effect,
             fmt::format("'{}' excludes '{}', which acts, too", name_of(effect), other.text),
             words_.empty() ? std::string("write 'default: on' at one of the two")
             : effects_[*excluded].one_of
                 ? fmt::format("name another one of '{}', as {}, or leave '{}' out", effects_[*excluded].one_of->text,
                               others_of_its_group(*excluded), name_of(effect))
                 : fmt::format("leave one of the two out, as by '-{}'", other.text));
    }
  }

  /// Of alternatives, one acts: taking it away alone leaves none.
  std::string others_of_its_group(std::size_t effect) const {
    std::vector<std::string> others;
    for (std::size_t i = 0; i < effects_.size(); ++i) {
      const auto& group = effects_[i].one_of;
      if (i != effect && group && group->text == effects_[effect].one_of->text) others.push_back(effects_[i].name.text);
    }
    return support::joined(others);
  }

  bool excludes(std::size_t effect, std::size_t other) const {
    const auto& all = effects_[effect].excludes;
    return std::any_of(all.begin(), all.end(), [&](const Name& name) { return name.text == name_of(other); });
  }

  /// The word that removes what is needed, else the one that names what needs it, else the first.
  std::optional<std::size_t> blamed(std::size_t needed, std::size_t effect) const {
    if (verdicts_[needed].word) return verdicts_[needed].word;
    return verdicts_[effect].word ? verdicts_[effect].word : first_word();
  }

  std::optional<std::size_t> later(std::size_t a, std::size_t b) const {
    const auto& one = verdicts_[a].word;
    const auto& other = verdicts_[b].word;
    if (!one && !other) return first_word();
    return one && other ? std::max(*one, *other) : one ? one : other;
  }

  std::optional<std::size_t> first_word() const {
    return words_.empty() ? std::nullopt : std::optional<std::size_t>(0);
  }

  const std::string& name_of(std::size_t effect) const { return effects_[effect].name.text; }

  void refuse(std::optional<std::size_t> word, std::optional<std::size_t> effect, std::string message,
              std::string hint) {
    mistakes_.push_back({word, effect, std::move(message), std::move(hint)});
  }

  const std::vector<Effect>& effects_;
  const GivenEffects& words_;
  std::vector<Verdict> verdicts_;
  std::vector<WrongChoice> mistakes_;
};

}  // namespace

bool is_word_of_choice(const std::string& word) { return word == "all" || word == "none" || word == "default"; }

std::vector<WrongChoice> choose_effects(std::vector<Effect>& effects, const GivenEffects& words) {
  Choosing choosing(effects, words);
  const std::vector<Verdict> verdicts = choosing.run();
  for (std::size_t i = 0; i < effects.size(); ++i) effects[i].acts = verdicts[i].acts;
  return choosing.take_mistakes();
}

}  // namespace gaussgen::model
