#pragma once

#include <optional>
#include <utility>

namespace gaussgen::evaluate {

/// A value, or the reason why there is none.
template <class T>
class Outcome {
 public:
  Outcome(T value) : value_(std::move(value)) {}  // NOLINT: a value is an outcome

  /// `reason` lives forever: it is a literal.
  static Outcome undefined(const char* reason) { return Outcome(reason, 0); }

  explicit operator bool() const { return value_.has_value(); }
  const T& operator*() const { return *value_; }
  const T* operator->() const { return &*value_; }
  const char* reason() const { return reason_; }

 private:
  Outcome(const char* reason, int) : reason_(reason) {}

  std::optional<T> value_;
  const char* reason_ = "";
};

}  // namespace gaussgen::evaluate
