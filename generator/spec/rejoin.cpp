#include "spec/rejoin.hpp"
#include "support/characters.hpp"

#include <algorithm>
#include <iterator>

namespace gaussgen::spec {

using support::is_digit;

namespace {

constexpr std::size_t k_most_pieces = 256;  // bounds the work on a list full of unclosed brackets

/// Open brackets left over; negative as soon as one closes that was never opened.
int open_brackets(const std::string& text, int open) {
  for (const char c : text) {
    if (c == '(') ++open;
    if (c == ')' && --open < 0) return open;
  }
  return open;
}

bool is_plain(const Node& node) { return node.kind == NodeKind::scalar && node.plain; }

/// 0,8 without a blank: such a comma is no separator, and a key that begins with a digit is none either.
bool is_decimal_comma(const LocatedText& head, const LocatedText& tail) {
  const bool is_close = head.span.end + 1 == tail.span.begin;
  return is_close && !head.text.empty() && !tail.text.empty() && is_digit(head.text.back()) &&
         is_digit(tail.text.front());
}

/// Pieces from `first` on that balance the brackets together, or 1.
template <class Piece>
std::size_t pieces_to_join(std::size_t count, std::size_t first, const Piece& piece) {
  int open = 0;
  for (std::size_t i = first; i < count && i < first + k_most_pieces; ++i) {
    const LocatedText* text = piece(i);
    if (text == nullptr) return 1;
    open = open_brackets(text->text, open);
    if (open < 0) return 1;
    if (open == 0) return i - first + 1;
  }
  return 1;
}

void append(Node& node, const LocatedText& tail) {
  LocatedText& head = node.scalar;
  head.text += ",";
  head.origin.push_back(head.span.end);
  head.text += tail.text;
  head.origin.insert(head.origin.end(), tail.origin.begin(), tail.origin.end());
  head.span.end = tail.span.end;
  node.span = head.span;
}

}  // namespace

void rejoin_items(std::vector<Node>& items) {
  const auto piece = [&](std::size_t i) { return is_plain(items[i]) ? &items[i].scalar : nullptr; };
  std::vector<Node> joined;
  for (std::size_t i = 0; i < items.size();) {
    const std::size_t count = pieces_to_join(items.size(), i, piece);
    Node node = items[i];
    for (std::size_t k = 1; k < count; ++k) append(node, items[i + k].scalar);
    joined.push_back(std::move(node));
    i += count;
  }
  items = std::move(joined);
}

void rejoin_entries(std::vector<Entry>& entries) {
  std::vector<Entry> joined;
  for (std::size_t i = 0; i < entries.size();) {
    const auto piece = [&](std::size_t k) -> const LocatedText* {
      if (k == i) return is_plain(entries[k].value) ? &entries[k].value.scalar : nullptr;
      return entries[k].value.kind == NodeKind::empty ? &entries[k].key : nullptr;
    };
    std::size_t count = pieces_to_join(entries.size(), i, piece);
    const LocatedText* head = piece(i);
    const LocatedText* tail = i + 1 < entries.size() ? piece(i + 1) : nullptr;
    if (head != nullptr && tail != nullptr && is_decimal_comma(*head, *tail)) count = std::max<std::size_t>(count, 2);
    Entry entry = entries[i];
    for (std::size_t k = 1; k < count; ++k) append(entry.value, entries[i + k].key);
    joined.push_back(std::move(entry));
    i += count;
  }
  entries = std::move(joined);
}

}  // namespace gaussgen::spec
