#include "model/renaming.hpp"

#include <algorithm>

#include "model/format.hpp"
#include "model/functions.hpp"
#include "model/rewriting.hpp"
#include "model/shapes.hpp"
#include "support/characters.hpp"

namespace gaussgen::model {

using format::Shape;
using spec::Node;
using spec::NodeKind;
using support::is_digit;
using support::is_letter;
using support::is_name_character;

namespace {

bool stays(const std::string& name) { return name == "space" || is_reserved(name); }

class Renaming {
 public:
  explicit Renaming(std::string prefix) : prefix_(std::move(prefix)) {}

  void rename(Node& map, const format::Map& shape) const {
    for (const format::Key& key : shape.keys) {
      for (spec::Entry& entry : map.entries) {
        if (entry.key.text == key.name) rename(entry.value, key.value);
      }
    }
  }

 private:
  void rename(Node& node, const format::Value& value) const {
    if (fits(node, value)) return rename_as(node, value);
    for (const format::Value& other : value.others) {
      if (fits(node, other)) return rename_as(node, other);
    }
  }

  void rename_as(Node& node, const format::Value& value) const {
    switch (value.shape) {
      case Shape::version:
      case Shape::text:
      case Shape::word:
      case Shape::count:  // numbers by now
      case Shape::counts: return;
      case Shape::expression:
      case Shape::new_name:
      case Shape::name: node.scalar = renamed(node.scalar); return;
      case Shape::map: rename(node, *value.map); return;
      case Shape::list:
        for (Node& item : node.items) rename(item, *value.item);
        return;
      case Shape::entries:
        for (spec::Entry& entry : node.entries) {
          entry.key = renamed(entry.key);
          rename(entry.value, *value.item);
        }
        return;
    }
  }

  /// A name that something else is part of, such as tip.x, is one; the e of 1e5 is none.
  spec::LocatedText renamed(const spec::LocatedText& text) const {
    Rewriting result(text);
    while (!result.is_done()) {
      if (is_digit(result.peek())) {
        while (is_name_character(result.peek()) || result.peek() == '.') result.keep(1);
      } else if (is_letter(result.peek())) {
        std::size_t size = 1;
        while (is_name_character(result.peek(size))) ++size;
        if (!stays(text.text.substr(result.at(), size))) result.put(prefix_);
        result.keep(size);
        while (is_name_character(result.peek()) || result.peek() == '.') result.keep(1);
      } else {
        result.keep(1);
      }
    }
    return std::move(result).result();
  }

  std::string prefix_;
};

}  // namespace

void prefix_names(Node& root, const std::string& prefix) { Renaming(prefix).rename(root, format::model_file()); }

}  // namespace gaussgen::model
