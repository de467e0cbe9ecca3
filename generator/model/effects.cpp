#include "model/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "model/effect_choice.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/shape_check.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

using format::k_effects;

bool is_section(const std::string& key) {
  static const std::vector<std::string> k_sections = format::section_names();
  return std::find(k_sections.begin(), k_sections.end(), key) != k_sections.end();
}

Entry* find_effects(Node& root) {
  const auto found =
      std::find_if(root.entries.begin(), root.entries.end(), [](const Entry& e) { return e.key.text == k_effects; });
  return found == root.entries.end() ? nullptr : &*found;
}

/// What the file says of its effects.
class Declarations {
 public:
  explicit Declarations(Reading& reading) : reading_(reading) {}

  std::vector<Effect> read(const Node& section) {
    const std::size_t findings = reading_.diagnostics.all().size();
    for (const Entry& entry : section.entries) all_.push_back(effect(entry));
    const bool is_read = reading_.diagnostics.all().size() == findings;
    for (std::size_t i = 0; i < all_.size() && is_read; ++i) {
      check_references(i, all_[i].needs, "requires");
      check_references(i, all_[i].excludes, "excludes");
      check_choice(i);
    }
    return std::move(all_);
  }

 private:
  void error(const std::string& id, support::Span at, std::string message, std::string hint) {
    reading_.diagnostics.error(id, at, std::move(message), std::move(hint));
  }

  Effect effect(const Entry& entry) {
    const std::string where = fmt::format("effect '{}'", entry.key.text);
    Effect effect;
    effect.name = name_of(entry.key);
    if (check_name(effect.name, reading_) && is_word_of_choice(effect.name.text))
      error(code::k_reserved_name, effect.name.span,
            fmt::format("'{}' says which effects act, and is none itself", effect.name.text), "choose another name");
    if (entry.value.kind == NodeKind::empty) return effect;
    if (!expect_map(entry.value, entry.key.span, where, reading_)) return effect;
    check_keys(entry.value, where, format::keys_of(format::effect()), reading_);
    effect.about = text_field(entry.value, "about", reading_);
    effect.by_default = read_default(entry);
    effect.needs = names_at(entry, "requires");
    effect.excludes = names_at(entry, "excludes");
    const Node* const choice = spec::find(entry.value, "one_of");
    if (choice != nullptr && expect_scalar(*choice, entry.key.span, "'one_of'", reading_)) {
      effect.one_of = name_of(choice->scalar);
      check_name(*effect.one_of, reading_);
    }
    return effect;
  }

  bool read_default(const Entry& entry) {
    const Node* const word = spec::find(entry.value, "default");
    if (word == nullptr || !expect_scalar(*word, entry.key.span, "'default'", reading_)) return false;
    const std::string& text = word->scalar.text;
    if (text != "on" && text != "off")
      error(code::k_unknown_word, word->span, fmt::format("an effect is on or off by default, not '{}'", text),
            "write on or off; off, if left out");
    return text == "on";
  }

  std::vector<Name> names_at(const Entry& entry, const char* key) {
    std::vector<Name> names;
    const Node* const list = spec::find(entry.value, key);
    if (list == nullptr || !expect_list(*list, entry.key.span, fmt::format("'{}'", key), reading_)) return names;
    for (const Node& item : list->items) {
      if (expect_scalar(item, list->span, "an effect", reading_)) names.push_back(name_of(item.scalar));
    }
    return names;
  }

  std::vector<std::string> others(std::size_t effect) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (i != effect) names.push_back(all_[i].name.text);
    }
    return names;
  }

  void check_references(std::size_t effect, const std::vector<Name>& names, const char* key) {
    const std::vector<std::string> known = others(effect);
    for (const Name& name : names) {
      if (std::find(known.begin(), known.end(), name.text) != known.end()) continue;
      const std::string near = support::did_you_mean(name.text, known);
      const bool is_itself = name.text == all_[effect].name.text;
      error(
          code::k_wrong_reference, name.span,
          is_itself ? fmt::format("'{}' {} itself", name.text, key) : fmt::format("there is no effect '{}'", name.text),
          !near.empty()   ? near
          : known.empty() ? "it is the only effect"
                          : "the others are " + support::joined(known));
    }
  }

  /// Whatever is chosen, exactly one of them acts, so one has to be the usual one.
  void check_choice(std::size_t effect) {
    const auto& choice = all_[effect].one_of;
    if (!choice) return;
    std::vector<std::string> usual;
    std::vector<std::string> rivals;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (!all_[i].one_of || all_[i].one_of->text != choice->text) continue;
      if (i < effect) return;  // it is said at the first one
      rivals.push_back(all_[i].name.text);
      if (all_[i].by_default) usual.push_back(all_[i].name.text);
    }
    if (rivals.size() < 2)
      error(code::k_effect_choice, choice->span, fmt::format("'{}' is the only one of '{}'", rivals[0], choice->text),
            "write 'one_of' with the same word at the others, or leave it out");
    else if (usual.size() != 1)
      error(code::k_effect_choice, choice->span,
            usual.empty()
                ? fmt::format("none of {} acts by default, and one has to", support::joined(rivals))
                : fmt::format("{} act by default, and of '{}' only one can", support::joined(usual), choice->text),
            usual.empty() ? "write 'default: on' at one of them" : "leave 'default: on' at one of them alone");
  }

  Reading& reading_;
  std::vector<Effect> all_;
};

/// As far as texts go.
bool are_equal(const Node& a, const Node& b) {
  if (a.kind != b.kind || a.scalar.text != b.scalar.text || a.items.size() != b.items.size() ||
      a.entries.size() != b.entries.size())
    return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!are_equal(a.items[i], b.items[i])) return false;
  }
  return std::all_of(a.entries.begin(), a.entries.end(), [&](const Entry& entry) {
    const Node* const other = spec::find(b, entry.key.text);
    return other != nullptr && are_equal(entry.value, *other);
  });
}

/// Puts the sections of effects to those of the file.
class Merging {
 public:
  Merging(Node& root, Reading& reading) : root_(root), reading_(reading) {}

  void take(Entry effect) {
    for (Entry& section : effect.value.entries) {
      if (!is_section(section.key.text) || section.value.kind == NodeKind::empty) continue;
      Node* own = spec::find(root_, section.key.text);
      if (own == nullptr) {
        root_.entries.push_back(std::move(section));
      } else if (own->kind == NodeKind::empty) {
        *own = std::move(section.value);
      } else if (own->kind == NodeKind::map && expect_map(section.value, section.key.span, "a section", reading_)) {
        for (Entry& entry : section.value.entries) add(std::move(entry), effect.key.text, section.key.text, *own);
      }
    }
  }

 private:
  void add(Entry entry, const std::string& effect, const std::string& name, Node& section) {
    // Each entry of many copies is looked up, and not compared with all others.
    auto& known = known_[name];
    for (std::size_t i = known.size(); i < section.entries.size(); ++i) known.emplace(section.entries[i].key.text, i);
    const auto [place, is_new] = known.emplace(entry.key.text, section.entries.size());
    if (is_new) return section.entries.push_back(std::move(entry));
    Entry& own = section.entries[place->second];
    if (are_equal(own.value, entry.value)) return;
    if (own.value.kind == NodeKind::empty) {
      own.value = std::move(entry.value);
    } else if (own.value.kind == NodeKind::map && entry.value.kind == NodeKind::map) {
      for (Entry& field : entry.value.entries) extend(std::move(field), effect, own);
    } else if (entry.value.kind != NodeKind::empty) {
      refuse(entry.key.text, effect, entry.key.span, own.key.span);
    }
  }

  void extend(Entry field, const std::string& effect, Entry& own) {
    const auto same = std::find_if(own.value.entries.begin(), own.value.entries.end(),
                                   [&](const Entry& entry) { return entry.key.text == field.key.text; });
    if (same == own.value.entries.end()) return own.value.entries.push_back(std::move(field));
    if (!are_equal(same->value, field.value))
      refuse(fmt::format("{}' of '{}", field.key.text, own.key.text), effect, field.key.span, same->key.span);
  }

  void refuse(const std::string& what, const std::string& effect, support::Span at, support::Span first) {
    reading_.diagnostics.error(
        code::k_effect_fit, at,
        fmt::format("the effect '{}' says something else of '{}' than {}", effect, what, reading_.line_text(first)),
        "an effect adds entries, and keys to entries; what it is to replace belongs to another effect that is left out "
        "then, as by 'one_of'");
  }

  Node& root_;
  Reading& reading_;
  std::map<std::string, std::map<std::string, std::size_t>> known_;  ///< index of each entry, by section
};

void note_word(const std::string& word, const Entry& effect, Model& model) {
  std::vector<std::string>& effects = model.words_of_absent_effects[word];
  if (effects.empty() || effects.back() != effect.key.text) effects.push_back(effect.key.text);
}

/// Of an effect that does not act: what is missing elsewhere may stand in it, and a slip in it is one all the same.
void leave_out(const Entry& effect, Reading& reading) {
  if (effect.value.kind != NodeKind::map) return;
  for (const Entry& section : effect.value.entries) {
    if (!is_section(section.key.text)) continue;
    for (const Entry& entry : section.value.entries) {
      LeftOut left{section.key.text, entry.key.text, {}, effect.key.text, {}};
      left.names.add_owner(entry.key.text);
      if (!declares(section.key.text)) continue;
      reading.left_out.push_back(std::move(left));
      note_word(entry.key.text, effect, reading.model);
    }
    for (const std::string& word : words_in(section.value)) note_word(word, effect, reading.model);
  }
  for (const format::Key& key : format::effect().keys) {
    const Node* const section = is_section(key.name) ? spec::find(effect.value, key.name) : nullptr;
    if (section != nullptr) check_shape(*section, key.value, section->span, fmt::format("'{}'", key.name), reading);
  }
}

void report(const std::vector<WrongChoice>& mistakes, const ChoiceOfEffects& choice, const std::vector<Effect>& effects,
            Reading& reading) {
  std::vector<EffectMistake> outside;
  for (const WrongChoice& one : mistakes) {
    const bool is_in_file = one.word && *one.word < choice.places.size();
    if (is_in_file) {
      reading.diagnostics.error(code::k_effect_choice, choice.places[*one.word], one.message, one.hint);
    } else if (one.word) {
      outside.push_back({*one.word, one.message, one.hint});
    } else if (one.effect) {
      reading.diagnostics.error(code::k_effect_choice, effects[*one.effect].name.span, "by default, " + one.message,
                                one.hint);
    }
  }
  if (!outside.empty()) throw WrongEffects(std::move(outside));
}

}  // namespace

Node with_chosen_effects(Node root, const ChoiceOfEffects& choice, std::vector<Effect>& all, Reading& reading) {
  Entry* const section = find_effects(root);
  const bool is_read = section != nullptr && section->value.kind != NodeKind::empty &&
                       expect_map(section->value, section->key.span, "'effects'", reading);
  const std::size_t findings = reading.diagnostics.all().size();
  if (is_read) all = Declarations(reading).read(section->value);
  const bool is_sound = reading.diagnostics.all().size() == findings;
  const std::vector<WrongChoice> mistakes = choose_effects(all, choice.words);
  if (is_sound) report(mistakes, choice, all, reading);
  if (!is_read) return root;
  std::vector<Entry> acting;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Entry& effect = section->value.entries[i];
    if (all[i].acts) {
      acting.push_back(std::move(effect));
    } else {
      leave_out(effect, reading);
      if (!is_sound) reading.unread.add(effect);
    }
  }
  section->value.entries = std::move(acting);
  return root;
}

Node with_entries_of_effects(Node root, Reading& reading) {
  Entry* const section = find_effects(root);
  if (section == nullptr) return root;
  std::vector<Entry> effects = std::move(section->value.entries);
  root.entries.erase(root.entries.begin() + (section - root.entries.data()));
  Merging merging(root, reading);
  for (Entry& effect : effects) merging.take(std::move(effect));
  return root;
}

}  // namespace gaussgen::model
