#include "sim/interpreter/scheduler.hpp"

#include <algorithm>
#include <limits>

namespace gausssim {

namespace {

/// Others stay before or behind it.
bool is_fixed(Op op) { return op == Op::status || op >= Op::call; }

bool reads_two(Op op) {
  switch (op) {
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::negative_product:
    case Op::add_product:
    case Op::subtract_product:
    case Op::less:
    case Op::at_most:
    case Op::either:
    case Op::select:
    case Op::replace:
    case Op::worse:
    case Op::atan2:
    case Op::pow: return true;
    default: return false;
  }
}

bool reads_target(Op op) {
  switch (op) {
    case Op::add_product:
    case Op::subtract_product:
    case Op::add_difference:
    case Op::select:
    case Op::replace:
    case Op::store: return true;
    default: return false;
  }
}

/// Two arguments may be one object: loads stay before stores, and stores before loads.
bool is_border(Op before, Op after) {
  return (before == Op::load && after == Op::store) || (before == Op::store && after == Op::load);
}

std::vector<std::size_t> borders_of(const std::vector<Instruction>& code, std::size_t begin) {
  std::vector<std::size_t> borders;
  Op outside = Op::move;
  for (std::size_t i = begin; i < code.size(); ++i) {
    const Op op = code[i].op;
    if (is_fixed(op)) borders.insert(borders.end(), {i, i + 1});
    if (is_border(outside, op)) borders.push_back(i);
    if (op == Op::load || op == Op::store) outside = op;
  }
  return borders;
}

}  // namespace

void Scheduler::run(std::vector<Instruction>& code, std::size_t begin, const std::vector<std::size_t>& landings) {
  std::vector<std::size_t> borders = borders_of(code, begin);
  borders.insert(borders.end(), landings.begin(), landings.end());
  std::sort(borders.begin(), borders.end());
  std::size_t from = begin;
  for (const std::size_t border : borders) {
    if (border > from + 1) reorder(code, from, border);
    from = std::max(from, border);
  }
  mark_runs(code, begin, borders);
}

void Scheduler::reorder(std::vector<Instruction>& code, std::size_t begin, std::size_t end) {
  const auto count = static_cast<std::uint32_t>(end - begin);
  const Instruction* const block = code.data() + begin;
  find_dependences(block, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (nodes_[i].waits_for == 0) ready_[static_cast<std::size_t>(block[i].op)].push_back(i);
  }
  ordered_.clear();
  while (ordered_.size() < count) {
    std::vector<std::uint32_t>& next = ready_[longest()];
    // What becomes ready on the way joins in.
    for (std::size_t k = 0; k < next.size(); ++k) {
      ordered_.push_back(block[next[k]]);
      release(block, next[k]);
    }
    next.clear();
  }
  std::copy(ordered_.begin(), ordered_.end(), code.begin() + static_cast<std::ptrdiff_t>(begin));
}

std::size_t Scheduler::longest() const {
  const auto is_shorter = [](const auto& a, const auto& b) { return a.size() < b.size(); };
  return static_cast<std::size_t>(std::max_element(ready_.begin(), ready_.end(), is_shorter) - ready_.begin());
}

void Scheduler::release(const Instruction* code, std::uint32_t done) {
  for (std::int32_t e = nodes_[done].first_edge; e >= 0; e = edges_[static_cast<std::size_t>(e)].next) {
    const std::uint32_t waiting = edges_[static_cast<std::size_t>(e)].to;
    if (--nodes_[waiting].waits_for == 0) ready_[static_cast<std::size_t>(code[waiting].op)].push_back(waiting);
  }
}

void Scheduler::find_dependences(const Instruction* code, std::uint32_t count) {
  ++block_;
  nodes_.assign(count, {});
  edges_.clear();
  readers_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    const Instruction& instruction = code[i];
    const Op op = instruction.op;
    if (op != Op::load && op != Op::store) read(instruction.a, i);
    if (reads_two(op)) read(instruction.b, i);
    if (reads_target(op)) read(instruction.to, i);
    if (op != Op::store) write(instruction.to, i);
    if (op == Op::sincos) write(instruction.b, i);
  }
}

Scheduler::Access& Scheduler::access(Slot slot) {
  if (slot >= accesses_.size()) accesses_.resize(2 * static_cast<std::size_t>(slot) + 1);
  Access& access = accesses_[slot];
  if (access.block != block_) access = {block_, -1, -1};
  return access;
}

void Scheduler::depend(std::int32_t before, std::uint32_t after) {
  if (before < 0 || static_cast<std::uint32_t>(before) == after) return;
  Node& node = nodes_[static_cast<std::size_t>(before)];
  edges_.push_back({after, node.first_edge});
  node.first_edge = static_cast<std::int32_t>(edges_.size() - 1);
  ++nodes_[after].waits_for;
}

void Scheduler::read(Slot slot, std::uint32_t by) {
  Access& found = access(slot);
  depend(found.writer, by);
  readers_.push_back({by, found.first_reader});
  found.first_reader = static_cast<std::int32_t>(readers_.size() - 1);
}

void Scheduler::write(Slot slot, std::uint32_t by) {
  Access& found = access(slot);
  depend(found.writer, by);
  for (std::int32_t r = found.first_reader; r >= 0; r = readers_[static_cast<std::size_t>(r)].next)
    depend(static_cast<std::int32_t>(readers_[static_cast<std::size_t>(r)].to), by);
  found.writer = static_cast<std::int32_t>(by);
  found.first_reader = -1;
}

void mark_runs(std::vector<Instruction>& code, std::size_t begin, const std::vector<std::size_t>& borders) {
  auto border = borders.begin();
  for (std::size_t i = begin; i < code.size();) {
    while (border != borders.end() && *border <= i) ++border;
    const std::size_t most =
        std::min(border == borders.end() ? code.size() : *border, i + std::numeric_limits<std::uint16_t>::max());
    std::size_t end = i + 1;
    while (end < most && code[end].op == code[i].op) ++end;
    code[i].run = static_cast<std::uint16_t>(end - i);
    i = end;
  }
}

}  // namespace gausssim
