#pragma once
// Distinct index types, so that a mix-up of blocks (free for held, row for column) does not compile.

#include <cstddef>
#include <utility>
#include <vector>

namespace gaussgen::support {

template <class Tag>
struct Index {
  std::size_t value = 0;
  friend bool operator==(Index a, Index b) { return a.value == b.value; }
  friend bool operator!=(Index a, Index b) { return a.value != b.value; }
  friend bool operator<(Index a, Index b) { return a.value < b.value; }
};

/// The indices 0 … count-1, for range-for.
template <class IndexType>
std::vector<IndexType> indices(std::size_t count) {
  std::vector<IndexType> all;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) all.push_back(IndexType{i});
  return all;
}

/// A vector that is addressed by one index type only.
template <class IndexType, class Value>
class Indexed {
 public:
  Indexed() = default;
  Indexed(std::size_t size, const Value& value) : values_(size, value) {}
  explicit Indexed(std::vector<Value> values) : values_(std::move(values)) {}

  Value& operator[](IndexType i) { return values_[i.value]; }
  const Value& operator[](IndexType i) const { return values_[i.value]; }
  std::size_t size() const { return values_.size(); }
  void push_back(Value value) { values_.push_back(std::move(value)); }
  std::vector<IndexType> indices() const { return support::indices<IndexType>(values_.size()); }
  const std::vector<Value>& values() const { return values_; }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::vector<Value> values_;
};

}  // namespace gaussgen::support
