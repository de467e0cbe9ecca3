#pragma once
// The program while it is written.

#include <absl/container/flat_hash_map.h>

#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "sim/interpreter/integers.hpp"
#include "sim/interpreter/program.hpp"
#include "sim/interpreter/scheduler.hpp"

namespace gausssim {

class Writer {
 public:
  /// Of the frame, one after the other.
  Slot slots(std::size_t count = 1);
  /// One for each number.
  Slot constant(Constant constant);
  Slot number(double value);
  /// The constant in this place; null where another value is.
  const Constant* constant_at(Slot slot) const;

  void write(Instruction instruction);
  void move(Slot to, Slot from, std::size_t count = 1);
  void load(Slot to, std::uint32_t argument, std::size_t offset, std::size_t count = 1);
  void store(Slot from, std::uint32_t argument, std::size_t offset, std::size_t count = 1);
  /// Returns where the first of them is in the list of operands.
  std::uint32_t list(const std::vector<std::uint32_t>& operands);

  /// To be led to the next instruction by `land`.
  std::size_t jump_if_zero(Slot condition);
  void land(std::size_t jump);
  /// The function that was added last is written: what may change places does, see Scheduler.
  void end_of_function();

  const Layout* layout(const std::string& type) const { return program_.struct_of(type); }
  /// -1: there is none.
  int function(const std::string& name) const;

  /// Arguments of functions are numbered through.
  void add(Function function);
  void add(Layout layout) { program_.structs.push_back(std::move(layout)); }
  void add(Pattern pattern) { program_.patterns.push_back(std::move(pattern)); }
  std::uint32_t add(Call call);
  std::uint32_t add(const Solve& solve);

  const Program& program() const { return program_; }
  Program finished() && { return std::move(program_); }

  Integers integers;

 private:
  using Key = std::tuple<int, bool, double, double, double>;

  Program program_;
  std::map<Key, Slot> known_;
  std::unordered_map<Slot, std::size_t> constants_;  ///< places in Program::constants
  absl::flat_hash_map<std::string, int> functions_;
  Scheduler scheduler_;
  std::vector<std::size_t> landings_;  ///< of the function: where jumps lead to
};

}  // namespace gausssim
