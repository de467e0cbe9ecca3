#include "interpreter/writer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace gausssim {

namespace {

constexpr std::size_t k_most_at_once = std::numeric_limits<std::uint16_t>::max();

std::uint32_t narrow(std::size_t value) { return static_cast<std::uint32_t>(value); }

}  // namespace

Slot Writer::slots(std::size_t count) {
  const Slot first = narrow(program_.slots);
  program_.slots += count;
  return first;
}

Slot Writer::constant(Constant constant) {
  const Key key{static_cast<int>(constant.kind), constant.is_negative, constant.a, constant.b, constant.c};
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  constant.slot = slots();
  known_.emplace(key, constant.slot);
  constants_.emplace(constant.slot, program_.constants.size());
  program_.constants.push_back(constant);
  return constant.slot;
}

Slot Writer::number(double value) { return constant({0, Constant::Kind::number, false, value}); }

const Constant* Writer::constant_at(Slot slot) const {
  const auto found = constants_.find(slot);
  return found == constants_.end() ? nullptr : &program_.constants[found->second];
}

void Writer::write(Instruction instruction) { program_.code.push_back(instruction); }

template <class Write>
void Writer::in_parts(std::size_t count, const Write& write) {
  for (std::size_t begin = 0; begin < count; begin += k_most_at_once)
    write(begin, static_cast<std::uint16_t>(std::min(count - begin, k_most_at_once)));
}

void Writer::move(Slot to, Slot from, std::size_t count) {
  if (to == from) return;
  if (count == 1) return write({Op::move, 1, to, from, 0});
  in_parts(count, [&](std::size_t begin, std::uint16_t part) {
    write({Op::copy, part, narrow(to + begin), narrow(from + begin), 0});
  });
}

// Neighbours are loaded together.
void Writer::load(Slot to, std::uint32_t argument, std::size_t offset, std::size_t count) {
  if (program_.code.size() > landing_) {
    Instruction& last = program_.code.back();
    const bool goes_on = last.op == Op::load && last.a == argument && last.to + last.count == to &&
                         last.b + last.count == offset && last.count + count <= k_most_at_once;
    if (goes_on) {
      last.count = static_cast<std::uint16_t>(last.count + count);
      return;
    }
  }
  in_parts(count, [&](std::size_t begin, std::uint16_t part) {
    write({Op::load, part, narrow(to + begin), argument, narrow(offset + begin)});
  });
}

void Writer::store(Slot from, std::uint32_t argument, std::size_t offset, std::size_t count) {
  in_parts(count, [&](std::size_t begin, std::uint16_t part) {
    write({Op::store, part, narrow(from + begin), argument, narrow(offset + begin)});
  });
}

std::uint32_t Writer::list(const std::vector<std::uint32_t>& operands) {
  const std::size_t first = program_.operands.size();
  program_.operands.insert(program_.operands.end(), operands.begin(), operands.end());
  return narrow(first);
}

std::size_t Writer::jump_if_zero(Slot condition) {
  write({Op::jump_if_zero, 1, 0, condition, 0});
  return program_.code.size() - 1;
}

void Writer::land(std::size_t jump) {
  landing_ = program_.code.size();
  program_.code[jump].b = narrow(landing_);
}

int Writer::function(const std::string& name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? -1 : found->second;
}

void Writer::add(Function function) {
  function.begin = landing_ = program_.code.size();
  function.first_argument = program_.arguments;
  program_.arguments += function.parameters.size();
  functions_.emplace(function.name, static_cast<int>(program_.functions.size()));
  program_.functions.push_back(std::move(function));
}

std::uint32_t Writer::add(Call call) {
  program_.calls.push_back(std::move(call));
  return narrow(program_.calls.size() - 1);
}

std::uint32_t Writer::add(const Solve& solve) {
  program_.solves.push_back(solve);
  return narrow(program_.solves.size() - 1);
}

}  // namespace gausssim
