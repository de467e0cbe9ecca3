#pragma once
// How the functions of a model are executed.

#include <memory>
#include <string>

#include "sim/drive/quad.hpp"
#include "sim/engine/entry.hpp"
#include "sim/engine/plugin.hpp"

namespace gausssim {

class Engine {
 public:
  virtual ~Engine() = default;

  virtual const char* name() const = 0;
  /// Of function and number type, as C++ writes it; an empty one where there is none.
  virtual Entry find(const std::string& function, const std::string& scalar) const = 0;
  /// The same functions, for another thread: what one engine has found may run on one thread at a time.
  virtual std::unique_ptr<const Engine> another() const = 0;
};

/// Values and the start, which are no part of what is compiled, are found by another engine.
class CompiledEngine final : public Engine {
 public:
  CompiledEngine(std::shared_ptr<const Plugin> plugin, std::unique_ptr<const Engine> beside)
      : plugin_(std::move(plugin)), beside_(std::move(beside)) {}

  const char* name() const override { return "compiled"; }
  Entry find(const std::string& function, const std::string& scalar) const override {
    const Entry compiled = plugin_->find(function, scalar);
    return compiled ? compiled : beside_->find(function, scalar);
  }
  std::unique_ptr<const Engine> another() const override {
    return std::make_unique<CompiledEngine>(plugin_, beside_->another());
  }

 private:
  std::shared_ptr<const Plugin> plugin_;
  std::unique_ptr<const Engine> beside_;
};

/// As C++ writes a number type.
template <class S>
const char* scalar_name();
template <>
inline const char* scalar_name<float>() {
  return "float";
}
template <>
inline const char* scalar_name<double>() {
  return "double";
}
template <>
inline const char* scalar_name<long double>() {
  return "long double";
}

template <>
inline const char* scalar_name<Quad>() {
  return "__float128";
}

}  // namespace gausssim
