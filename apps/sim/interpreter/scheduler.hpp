#pragma once
// Brings instructions into an order in which many neighbours have the same operation.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/interpreter/instruction.hpp"

namespace gausssim {

/// An operation that is not the one before costs a processor more than the operation itself, since it cannot foresee it. So what is independent changes places, as
/// compilers do it: each instruction has the same operands as before, and results are the same bits.
class Scheduler {
 public:
  /// From `begin` on; nothing moves across a call, a jump, or `landings`, where jumps lead to.
  void run(std::vector<Instruction>& code, std::size_t begin, const std::vector<std::size_t>& landings);

 private:
  static constexpr std::size_t k_operations = static_cast<std::size_t>(Op::give_nothing) + 1;

  /// What waits for an instruction: a list of edges.
  struct Node {
    std::uint32_t waits_for = 0;
    std::int32_t first_edge = -1;
  };
  struct Edge {
    std::uint32_t to;
    std::int32_t next;
  };
  /// Of one slot: who wrote it last, and a list of those who have read it since.
  struct Access {
    std::uint32_t block = 0;
    std::int32_t writer = -1;
    std::int32_t first_reader = -1;
  };

  void reorder(std::vector<Instruction>& code, std::size_t begin, std::size_t end);
  void find_dependences(const Instruction* code, std::uint32_t count);
  void read(Slot slot, std::uint32_t by);
  void write(Slot slot, std::uint32_t by);
  void depend(std::int32_t before, std::uint32_t after);
  Access& access(Slot slot);
  std::size_t longest() const;
  void release(const Instruction* code, std::uint32_t done);

  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::vector<Edge> readers_;
  std::vector<Access> accesses_;
  std::uint32_t block_ = 0;
  std::array<std::vector<std::uint32_t>, k_operations> ready_;  ///< by operation
  std::vector<Instruction> ordered_;
};

/// Says of neighbours with one operation that they are a run.
void mark_runs(std::vector<Instruction>& code, std::size_t begin, const std::vector<std::size_t>& landings);

}  // namespace gausssim
