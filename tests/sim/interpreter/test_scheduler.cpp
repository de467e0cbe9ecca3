// Instructions that change places leave every slot with what it had: with few slots, nearly all of them depend on each other.

#include <algorithm>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "sim/interpreter/machine.hpp"
#include "sim/interpreter/scheduler.hpp"

namespace {

using gausssim::Instruction;
using gausssim::Op;

constexpr std::uint32_t k_slots = 12;

std::vector<Instruction> random_code(std::mt19937& engine) {
  const std::vector<Op> operations{Op::move,        Op::add,    Op::multiply, Op::subtract_product, Op::less,
                                   Op::add_product, Op::select, Op::replace,  Op::negate,           Op::add_difference};
  const auto below = [&](std::size_t count) { return static_cast<std::uint32_t>(engine() % count); };
  std::vector<Instruction> code;
  for (int i = 0; i < 60; ++i)
    code.push_back({operations[below(operations.size())], 1, below(k_slots), below(k_slots), below(k_slots)});
  code.push_back({Op::give_nothing});
  return code;
}

std::vector<double> slots_after(const std::vector<Instruction>& code) {
  gausssim::Program program;
  program.code = code;
  program.functions.resize(1);
  std::vector<double> slots;
  for (std::uint32_t i = 0; i < k_slots; ++i) slots.push_back(0.3 + 0.1 * i);
  (void)gausssim::Machine<double>(program, slots.data(), nullptr).run(0);
  return slots;
}

std::size_t runs_of(const std::vector<Instruction>& code) {
  std::size_t runs = 0;
  for (std::size_t i = 0; i < code.size(); i += code[i].run) ++runs;
  return runs;
}

}  // namespace

TEST_CASE("what changes places gives the same bits") {
  std::mt19937 engine(11);
  gausssim::Scheduler scheduler;
  std::size_t before = 0, after = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::vector<Instruction> written = random_code(engine);
    std::vector<Instruction> ordered = written;
    scheduler.run(ordered, 0, {});
    REQUIRE(slots_after(ordered) == slots_after(written));
    before += written.size();
    after += runs_of(ordered);
  }
  CHECK(after < before);
}

TEST_CASE("a load stays behind the store before it, and nothing crosses where a jump leads to") {
  const std::vector<Instruction> written{{Op::load, 1, 0, 0, 0}, {Op::store, 1, 0, 0, 1}, {Op::load, 1, 1, 0, 1},
                                         {Op::add, 1, 2, 0, 1},  {Op::move, 1, 3, 0, 0},  {Op::add, 1, 4, 0, 0},
                                         {Op::give_nothing}};
  std::vector<Instruction> ordered = written;
  gausssim::Scheduler scheduler;
  scheduler.run(ordered, 0, {5});
  REQUIRE(ordered[0].op == Op::load);
  CHECK(ordered[1].op == Op::store);
  const auto is_second_load = [](const Instruction& one) { return one.op == Op::load && one.to == 1; };
  CHECK(std::find_if(ordered.begin(), ordered.end(), is_second_load) > ordered.begin() + 1);
  CHECK(ordered[5].to == 4);
}
