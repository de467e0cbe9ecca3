#include "sim/engine/interpreted.hpp"

#include <algorithm>
#include <array>
#include <list>
#include <map>
#include <utility>
#include <variant>

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

constexpr std::size_t k_most_arguments = 8;

template <class S>
struct Callee {
  Callee(const std::shared_ptr<const Program>& program, int index)
      : interpreter(program),
        function(index),
        count(program->functions[static_cast<std::size_t>(index)].parameters.size()),
        frame(interpreter.frame()) {}

  static int call(const void* self, void* const* arguments) {
    const auto& callee = *static_cast<const Callee*>(self);
    std::array<S*, k_most_arguments> places{};
    for (std::size_t i = 0; i < callee.count; ++i) places[i] = static_cast<S*>(arguments[i]);
    return static_cast<int>(callee.interpreter.call(callee.function, places.data(), callee.frame));
  }

  Interpreter<S> interpreter;
  int function;
  std::size_t count;
  mutable typename Interpreter<S>::Frame frame;
};

template <class S>
Entry entry_of(std::list<Callee<S>>& all, const std::shared_ptr<const Program>& program, int function) {
  all.emplace_back(program, function);
  return {Callee<S>::call, &all.back()};
}

/// Series are for compilers: loops over orders.
void remove_series(cpp::File& tree) {
  const auto is_of_series = [](const cpp::Item& item) {
    const auto* const function = std::get_if<cpp::Function>(&item);
    const auto* const type = std::get_if<cpp::Struct>(&item);
    return (function != nullptr && function->name.rfind("taylor", 0) == 0) ||
           (type != nullptr && type->name.rfind("Taylor", 0) == 0);
  };
  tree.items.erase(std::remove_if(tree.items.begin(), tree.items.end(), is_of_series), tree.items.end());
}

/// Default values are the functions of their structs.
std::string as_in_program(const std::string& function) {
  return function == "parameters" ? "Parameters" : function == "inputs" ? "Inputs" : function;
}

}  // namespace

struct InterpretedEngine::Callees {
  std::map<std::pair<std::string, std::string>, Entry> entries;  ///< by function and scalar
  std::list<Callee<float>> in_float;
  std::list<Callee<double>> in_double;
  std::list<Callee<long double>> in_long_double;
  std::list<Callee<Quad>> in_quad;
};

InterpretedEngine::InterpretedEngine(std::shared_ptr<const Program> program)
    : program_(std::move(program)), callees_(std::make_unique<Callees>()) {}

InterpretedEngine::InterpretedEngine(cpp::File tree) : callees_(std::make_unique<Callees>()) {
  remove_series(tree);
  program_ = std::make_shared<const Program>(compile(tree));
}

InterpretedEngine::~InterpretedEngine() = default;

Entry InterpretedEngine::find(const std::string& function, const std::string& scalar) const {
  const auto [place, is_new] = callees_->entries.try_emplace({function, scalar});
  if (is_new) place->second = made(function, scalar);
  return place->second;
}

std::unique_ptr<const Engine> InterpretedEngine::another() const {
  return std::unique_ptr<const Engine>(new InterpretedEngine(program_));
}

Entry InterpretedEngine::made(const std::string& function, const std::string& scalar) const {
  const int index = program_->find(as_in_program(function));
  if (index < 0) return {};
  if (scalar == scalar_name<float>()) return entry_of(callees_->in_float, program_, index);
  if (scalar == scalar_name<double>()) return entry_of(callees_->in_double, program_, index);
  if (scalar == scalar_name<long double>()) return entry_of(callees_->in_long_double, program_, index);
  return entry_of(callees_->in_quad, program_, index);
}

}  // namespace gausssim
