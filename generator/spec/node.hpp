#pragma once
// The raw tree of a model file: what YAML says, with positions, before any meaning.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/source.hpp"

namespace gaussgen::spec {

/// A decoded text that knows from which byte of the source each of its bytes came: escapes, folded
/// lines and doubled quotes make the two differ.
struct LocatedText {
  std::string text;
  std::vector<std::uint32_t> origin;  ///< one per byte of `text`
  support::Span span;                 ///< all of it in the source, quotes included

  /// The source of text[begin, end); past the end it is the end of the text.
  support::Span span_of(std::size_t begin, std::size_t end) const;
};

/// A text that stands in the source as it is, from byte `begin` on.
LocatedText located(std::string text, std::uint32_t begin = 0);

enum class NodeKind { empty, scalar, sequence, map };

struct Entry;

struct Node {
  NodeKind kind = NodeKind::empty;
  support::Span span;   ///< of an empty value its key
  bool plain = false;   ///< a scalar without quotes, on which YAML's own signs act
  bool flow = false;    ///< inside or itself [...] or {...}
  bool is_cut = false;  ///< a scalar of which characters are refused, and taken out
  LocatedText scalar;
  std::vector<Node> items;     ///< of a sequence
  std::vector<Entry> entries;  ///< of a map, in the order of the file, keys unique
};

struct Entry {
  LocatedText key;
  Node value;
};

/// Values in it, itself among them.
std::size_t size_of(const Node& node);

/// Bytes of the texts in it, keys too.
std::size_t bytes_of(const Node& node);

/// Moves every span by `distance`.
void shift(Node& node, std::uint32_t distance);

/// The value at `key`, or nullptr.
const Node* find(const Node& map, const std::string& key);
Node* find(Node& map, const std::string& key);

}  // namespace gaussgen::spec
