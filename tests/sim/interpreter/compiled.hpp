#pragma once
// The functions of compiled headers by name, called as the interpreter is.

#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "gauss/math.hpp"

namespace headertest {

template <class S>
struct CompiledFunction {
  std::string name;
  gauss::Status (*call)(S* const* arguments);
};

/// All that wrap.py found in one header.
template <class S>
struct CompiledModel {
  std::string model;  ///< file below the root, and options
  std::vector<CompiledFunction<S>> functions;
};

template <class S>
std::vector<CompiledModel<S>>& compiled_models() {
  static std::vector<CompiledModel<S>> models;
  return models;
}

template <class S>
struct Registered {
  Registered(std::string model, std::vector<CompiledFunction<S>> functions) {
    compiled_models<S>().push_back({std::move(model), std::move(functions)});
  }
};

/// A struct of nothing but S, or S itself.
template <class Value, class S>
Value read(const S* from) {
  Value value{};
  if constexpr (!std::is_empty_v<Value>) std::memcpy(static_cast<void*>(&value), from, sizeof value);
  return value;
}

template <class Value, class S>
void write(const Value& value, S* to) {
  if constexpr (!std::is_empty_v<Value>) std::memcpy(to, &value, sizeof value);
}

}  // namespace headertest
