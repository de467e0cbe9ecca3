#pragma once
// A function of a model as both engines offer it.

namespace gausssim {

/// `arguments`: in the order of the emitted function, each the first number of the struct that it takes. Returns gauss::Status as a number.
struct Entry {
  using Call = int (*)(const void* self, void* const* arguments);
  Call call = nullptr;
  const void* self = nullptr;

  explicit operator bool() const { return call != nullptr; }
  int operator()(void* const* arguments) const { return call(self, arguments); }
};

}  // namespace gausssim
