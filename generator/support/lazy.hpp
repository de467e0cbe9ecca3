#pragma once
// Values that are computed when somebody asks for them, once.

#include <functional>
#include <optional>
#include <utility>

namespace gaussgen::support {

template <class T>
class Lazy {
 public:
  Lazy() = default;
  explicit Lazy(std::function<T()> make) : make_(std::move(make)) {}

  const T& operator*() const {
    if (!value_) value_.emplace(make_());
    return *value_;
  }
  const T* operator->() const { return &**this; }

 private:
  std::function<T()> make_;
  mutable std::optional<T> value_;
};

/// A list like that, which is used as any other.
template <class List>
class LazyList {
 public:
  LazyList() = default;
  explicit LazyList(std::function<List()> make) : make_(std::move(make)) {}
  LazyList& operator=(List value) {
    value_ = std::move(value);
    return *this;
  }

  operator const List&() const { return get(); }  // NOLINT(google-explicit-constructor)
  const List& get() const {
    if (!value_) value_.emplace(make_ ? make_() : List());
    return *value_;
  }

  auto begin() const { return get().begin(); }
  auto end() const { return get().end(); }
  auto begin() { return own().begin(); }
  auto end() { return own().end(); }
  std::size_t size() const { return get().size(); }
  bool empty() const { return get().empty(); }
  const auto& operator[](std::size_t i) const { return get()[i]; }
  auto& operator[](std::size_t i) { return own()[i]; }
  auto& back() { return own().back(); }
  void clear() { own().clear(); }
  template <class Value>
  void push_back(Value&& value) {
    own().push_back(std::forward<Value>(value));
  }
  template <class... Values>
  void emplace_back(Values&&... values) {
    own().emplace_back(std::forward<Values>(values)...);
  }
  template <class... Values>
  void assign(Values&&... values) {
    own().assign(std::forward<Values>(values)...);
  }

 private:
  List& own() {
    (void)get();
    return *value_;
  }

  std::function<List()> make_;
  mutable std::optional<List> value_;
};

}  // namespace gaussgen::support
