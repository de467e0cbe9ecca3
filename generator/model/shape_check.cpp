#include "model/shape_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/fields.hpp"
#include "model/names.hpp"
#include "model/shapes.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using format::Shape;
using format::Value;
using spec::Node;
using spec::NodeKind;

namespace {

class ShapeCheck {
 public:
  explicit ShapeCheck(Reading& reading) : reading_(reading) {}

  void check(const Node& node, const Value& value, support::Span owner, const std::string& where) {
    if (node.kind == NodeKind::empty && value.may_be_empty) return;
    if (const Value* const fitting = fitting_of(node, value)) return check_fitting(node, *fitting, owner, where);
    switch (kind_of(value.shape)) {
      case NodeKind::map: expect_map(node, owner, where, reading_); return;
      case NodeKind::sequence: expect_list(node, owner, where, reading_); return;
      default: expect_scalar(node, owner, where, reading_);
    }
  }

 private:
  static support::Span span_of(const Node& map, const std::string& key) {
    const auto found = std::find_if(map.entries.begin(), map.entries.end(),
                                    [&](const spec::Entry& entry) { return entry.key.text == key; });
    return found->key.span;
  }

  /// Where a law stands, those beside it.
  static std::vector<std::string> allowed_in(const Node& node, const format::Map& map) {
    for (const spec::Entry& entry : node.entries) {
      if (format::is_law(map, entry.key.text)) return format::keys_beside(map, entry.key.text);
    }
    return format::keys_of(map);
  }

  void check(const Node& node, const format::Map& map, support::Span owner, const std::string& where) {
    if (!expect_map(node, owner, where, reading_)) return;
    check_keys(node, where, allowed_in(node, map), reading_);
    for (const format::Key& key : map.keys) {
      const Node* const value = key.need == format::Need::required ? required(node, key.name, owner, where, reading_)
                                                                   : spec::find(node, key.name);
      if (value != nullptr) check(*value, key.value, span_of(node, key.name), fmt::format("'{}'", key.name));
    }
  }

  static bool knows_keys(const Value& value, const Node& node) {
    if (value.map == nullptr) return true;
    const std::vector<std::string> keys = format::keys_of(*value.map);
    return std::all_of(node.entries.begin(), node.entries.end(),
                       [&](const spec::Entry& entry) { return has(keys, entry.key.text); });
  }

  /// The one of several that is meant: by its brackets, its length, its word, its keys; else the first of its kind.
  static const Value* fitting_of(const Node& node, const Value& value) {
    std::vector<const Value*> all{&value};
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const Value& other : all[i]->others) all.push_back(&other);
    }
    const Value* near = nullptr;
    for (const Value* one : all) {
      if (kind_of(one->shape) != node.kind) continue;
      if (near == nullptr || (!fits(node, *near) && fits(node, *one))) near = one;
      const bool is_word = one->shape != Shape::word || has(one->words, node.scalar.text);
      const bool has_length = one->count == 0 || one->count == node.items.size();
      if (is_word && has_length && fits(node, *one) && knows_keys(*one, node)) return one;
    }
    return near;
  }

  static bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  }

  void check_fitting(const Node& node, const Value& value, support::Span owner, const std::string& where) {
    switch (value.shape) {
      case Shape::map: return check(node, *value.map, owner, where);
      case Shape::entries:
      case Shape::counts: return check_entries(node, value);
      case Shape::list: return check_list(node, value, where);
      case Shape::word: return check_word(node, value, where);
      case Shape::new_name: return check_new_name(node.scalar);
      case Shape::expression:
        if (node.scalar.text.find_first_not_of(" \t\n") == std::string::npos) read_expression(node, owner, reading_);
        return;
      default: return;
    }
  }

  void check_entries(const Node& node, const Value& value) {
    for (const spec::Entry& entry : node.entries) {
      check_new_name(entry.key);
      check(entry.value, *value.item, entry.key.span, fmt::format("'{}'", entry.key.text));
    }
  }

  void check_list(const Node& node, const Value& value, const std::string& where) {
    if (value.count > 0) expect_length(node, value.count, where, reading_);
    for (const Node& item : node.items) check(item, *value.item, node.span, "an entry of " + where);
  }

  void check_word(const Node& node, const Value& value, const std::string& where) {
    if (has(value.words, node.scalar.text)) return;
    const std::string near = support::did_you_mean(node.scalar.text, value.words);
    reading_.diagnostics.error(code::k_unknown_word, node.span, fmt::format("{} is not '{}'", where, node.scalar.text),
                               near.empty() ? "it is one of " + support::joined(value.words) : near);
  }

  /// With an index in it, it is a name when it is written out.
  void check_new_name(const spec::LocatedText& text) {
    if (text.text.find('$') == std::string::npos) check_name(name_of(text), reading_);
  }

  Reading& reading_;
};

}  // namespace

void check_shape(const Node& node, const Value& value, support::Span owner, const std::string& where,
                 Reading& reading) {
  ShapeCheck(reading).check(node, value, owner, where);
}

}  // namespace gaussgen::model
