#include "sim/interpreter/writer.hpp"

#include <utility>

namespace gausssim {

namespace {

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

void Writer::move(Slot to, Slot from, std::size_t count) {
  if (to == from) return;
  for (std::size_t k = 0; k < count; ++k) write({Op::move, 1, narrow(to + k), narrow(from + k), 0});
}

void Writer::load(Slot to, std::uint32_t argument, std::size_t offset, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) write({Op::load, 1, narrow(to + k), argument, narrow(offset + k)});
}

void Writer::store(Slot from, std::uint32_t argument, std::size_t offset, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) write({Op::store, 1, narrow(from + k), argument, narrow(offset + k)});
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
  landings_.push_back(program_.code.size());
  program_.code[jump].b = narrow(landings_.back());
}

void Writer::end_of_function() {
  scheduler_.run(program_.code, program_.functions.back().begin, landings_);
  landings_.clear();
}

int Writer::function(const std::string& name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? -1 : found->second;
}

void Writer::add(Function function) {
  function.begin = program_.code.size();
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
