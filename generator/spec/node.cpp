#include "spec/node.hpp"

#include <algorithm>

namespace gaussgen::spec {

support::Span LocatedText::span_of(std::size_t begin, std::size_t end) const {
  if (begin >= origin.size()) {
    const std::uint32_t after = origin.empty() ? span.begin : origin.back() + 1;
    return {after, after};
  }
  const std::size_t last = std::min(std::max(end, begin + 1), origin.size()) - 1;
  return {origin[begin], origin[last] + 1};
}

LocatedText located(std::string text, std::uint32_t begin) {
  LocatedText result;
  for (std::size_t i = 0; i < text.size(); ++i) result.origin.push_back(begin + static_cast<std::uint32_t>(i));
  result.span = {begin, begin + static_cast<std::uint32_t>(text.size())};
  result.text = std::move(text);
  return result;
}

namespace {

void shift(support::Span& span, std::uint32_t distance) {
  span.begin += distance;
  span.end += distance;
}

void shift(LocatedText& text, std::uint32_t distance) {
  shift(text.span, distance);
  for (std::uint32_t& byte : text.origin) byte += distance;
}

}  // namespace

std::size_t size_of(const Node& node) {
  std::size_t size = 1;
  for (const Node& item : node.items) size += size_of(item);
  for (const Entry& entry : node.entries) size += size_of(entry.value);
  return size;
}

std::size_t bytes_of(const Node& node) {
  std::size_t bytes = node.scalar.text.size();
  for (const Node& item : node.items) bytes += bytes_of(item);
  for (const Entry& entry : node.entries) bytes += entry.key.text.size() + bytes_of(entry.value);
  return bytes;
}

void shift(Node& node, std::uint32_t distance) {
  shift(node.span, distance);
  shift(node.scalar, distance);
  for (Node& item : node.items) shift(item, distance);
  for (Entry& entry : node.entries) {
    shift(entry.key, distance);
    shift(entry.value, distance);
  }
}

namespace {

template <class Map>
auto found(Map& map, const std::string& key) -> decltype(&map.entries[0].value) {
  for (auto& entry : map.entries) {
    if (entry.key.text == key) return &entry.value;
  }
  return nullptr;
}

}  // namespace

const Node* find(const Node& map, const std::string& key) { return found(map, key); }

Node* find(Node& map, const std::string& key) { return found(map, key); }

}  // namespace gaussgen::spec
