#pragma once
// Functions that run without a compiler.

#include <memory>
#include <string>

#include "sim/engine/engine.hpp"
#include "sim/interpreter/interpreter.hpp"

namespace gausssim {

/// Of a header, all functions but series. Numbers and bits are those of the compiled ones.
class InterpretedEngine final : public Engine {
 public:
  /// Throws NotRunnable.
  explicit InterpretedEngine(gaussgen::emit::cpp::File tree);
  ~InterpretedEngine() override;

  const char* name() const override { return "interpreted"; }
  /// The same entry for the same words, with a frame of its own: different ones may run at a time, one may not.
  Entry find(const std::string& function, const std::string& scalar) const override;
  std::unique_ptr<const Engine> another() const override;

 private:
  struct Callees;

  explicit InterpretedEngine(std::shared_ptr<const Program> program);

  Entry made(const std::string& function, const std::string& scalar) const;

  std::shared_ptr<const Program> program_;
  std::unique_ptr<Callees> callees_;
};

}  // namespace gausssim
