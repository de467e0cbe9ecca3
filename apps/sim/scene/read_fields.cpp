#include "sim/scene/read_fields.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gausssim {

namespace code = gaussgen::support::code;
namespace model = gaussgen::model;
namespace spec = gaussgen::spec;
using gaussgen::support::Span;

void FieldReader::error(const std::string& id, Span span, const std::string& message, const std::string& hint) {
  reading_.diagnostics.error(id, span, message, hint);
}

void FieldReader::effects(std::vector<Word>& to) {
  const spec::Node* const node = spec::find(map_, "effects");
  if (node == nullptr) return;
  if (node->kind == spec::NodeKind::scalar) return to.push_back({node->scalar.text, node->span});
  if (!model::expect_list(*node, owner_, "'effects'", reading_)) return;
  if (node->items.empty())
    error(code::k_wrong_count, node->span, "there is no effect in the list", "write 'effects: none' for none at all");
  for (const spec::Node& item : node->items) {
    if (model::expect_scalar(item, node->span, "an effect", reading_)) to.push_back({item.scalar.text, item.span});
  }
}

void FieldReader::outputs(std::vector<Word>& to) {
  const spec::Node* const list = spec::find(map_, "outputs");
  if (list == nullptr || !model::expect_list(*list, owner_, "'outputs'", reading_)) return;
  if (list->items.empty())
    error(code::k_wrong_count, list->span, "there is no output in the list",
          "name some, or leave 'outputs' out: the table has the state and the energy then");
  for (const spec::Node& item : list->items) {
    if (model::expect_scalar(item, list->span, "an output", reading_)) to.push_back({item.scalar.text, item.span});
  }
}

void FieldReader::given(const std::string& section, std::vector<Given>& to) {
  model::read_section(map_, section, reading_, [&](const spec::Entry& entry) {
    to.push_back({entry.key.text, model::read_expression(entry.value, entry.key.span, reading_), entry.key.span});
  });
}

std::optional<Word> FieldReader::choice(const std::string& key, const std::vector<std::string>& words) {
  const spec::Node* const node = spec::find(map_, key);
  if (node == nullptr || !model::expect_scalar(*node, owner_, "'" + key + "'", reading_)) return std::nullopt;
  const std::string& word = node->scalar.text;
  if (std::find(words.begin(), words.end(), word) != words.end()) return Word{word, node->span};
  const std::string near = gaussgen::support::did_you_mean(word, words);
  error(code::k_unknown_word, node->span, fmt::format("there is no {} '{}'", key, word),
        near.empty() ? "there are " + gaussgen::support::joined(words) : near);
  return std::nullopt;
}

std::optional<double> FieldReader::positive(const std::string& key, std::map<std::string, Span>& places) {
  if (const spec::Node* const node = spec::find(map_, key)) places[key] = node->span;
  return numbers_.positive(map_, key);
}

void FieldReader::refuse_pair(const std::string& first, const std::string& second) {
  const spec::Node* const both = spec::find(map_, second);
  if (both == nullptr || spec::find(map_, first) == nullptr) return;
  error(code::k_conflicting_keys, both->span, fmt::format("'{}' and '{}' exclude each other", first, second),
        "leave one of the two out");
}

}  // namespace gausssim
