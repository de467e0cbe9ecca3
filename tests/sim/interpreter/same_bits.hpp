#pragma once
// Interpreted against compiled: every function of a header, at states of its own.

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "catch_shim.hpp"
#include "sim/interpreter/interpreter.hpp"
#include "sim/interpreter/compiled.hpp"
#include "sim/interpreter/tree_of.hpp"

namespace headertest {

/// What is no number has no bits of its own.
template <class S>
bool is_same(const S& a, const S& b) {
  if (!(a == a)) return !(b == b);
  return a == b && (a != S(0) || (S(1) / a > S(0)) == (S(1) / b > S(0)));
}

template <class S>
class Comparison {
  using Scalars = std::vector<S>;

 public:
  explicit Comparison(const CompiledModel<S>& model)
      : model_(model), interpreter_(compiled_model(model.model).tree), frame_(interpreter_.frame()) {}

  /// How many scalars were compared.
  std::size_t run() {
    make_prepared();
    compare_everything();
    place("State") = place("Initial");
    for (int round = 0; round < 6; ++round) {
      for (S& value : place("State")) value = value + far_of_round(round) * random();
      for (S& value : place("Derivative")) value = random();
      for (S& value : place("Inputs")) value = random();
      for (S& value : place("S")) value = random();
      compare_everything();
    }
    return compared_;
  }

 private:
  S random() { return static_cast<S>(std::uniform_real_distribution<double>(-1, 1)(engine_)); }

  /// At first beside the state where the motion begins, then anywhere; at last something that is no number.
  static S far_of_round(int round) {
    const double sizes[] = {0, 1e-9, 0.1, 1.5, 1.5, std::nan("")};
    return static_cast<S>(sizes[round]);
  }

  Scalars& place(const std::string& type) {
    Scalars& values = values_[type];
    if (values.empty()) values.resize(std::max<std::size_t>(size(type == "Initial" ? "State" : type), 1));
    return values;
  }

  std::size_t size(const std::string& type) const {
    return type == "S" || type == "StatusOf" ? 1 : interpreter_.size_of(type);
  }

  void make_prepared() {
    fill("Parameters", "Parameters");
    fill("Inputs", "Inputs");
    const int prepare = interpreter_.find("prepare");
    S* const arguments[] = {place("Parameters").data(), place("Prepared").data()};
    REQUIRE(interpreter_.call(prepare, arguments, frame_) == gauss::Status::ok);
    const int initial = interpreter_.find("initial_state");
    S* const of_initial[] = {place("Prepared").data(), place("Initial").data()};
    if (initial >= 0) (void)interpreter_.call(initial, of_initial, frame_);
  }

  void fill(const char* function, const std::string& type) {
    const int found = interpreter_.find(function);
    S* const argument[] = {place(type).data()};
    if (found >= 0) (void)interpreter_.call(found, argument, frame_);
  }

  void compare_everything() {
    for (const CompiledFunction<S>& function : model_.functions) {
      const int found = interpreter_.find(function.name);
      INFO(model_.model << ": " << function.name);
      REQUIRE(found >= 0);
      compare(function, interpreter_.program().functions[static_cast<std::size_t>(found)], found);
    }
  }

  void compare(const CompiledFunction<S>& compiled, const gausssim::Function& function, int index) {
    std::vector<Scalars> ours = arguments_of(function), theirs = ours;
    const gauss::Status status = interpreter_.call(index, pointers(ours).data(), frame_);
    const gauss::Status expected = compiled.call(pointers(theirs).data());
    CHECK(std::string(gauss::name(status)) == gauss::name(expected));
    for (std::size_t i = 0; i < ours.size(); ++i) {
      for (std::size_t k = 0; k < ours[i].size(); ++k) {
        INFO("argument " << function.parameters[i].name << ", scalar " << k << ": " << static_cast<double>(ours[i][k])
                         << " and " << static_cast<double>(theirs[i][k]));
        if (!is_same(ours[i][k], theirs[i][k])) FAIL("other bits");
        ++compared_;
      }
    }
    compare_in_place(compiled, function, index);
  }

  /// A state that is written over the one that it is made from.
  void compare_in_place(const CompiledFunction<S>& compiled, const gausssim::Function& function, int index) {
    if (function.name != "project") return;
    std::vector<Scalars> apart = arguments_of(function), over = apart;
    (void)compiled.call(pointers(apart).data());
    std::vector<S*> arguments = pointers(over);
    arguments.back() = arguments[1];
    (void)interpreter_.call(index, arguments.data(), frame_);
    for (std::size_t k = 0; k < over[1].size(); ++k) CHECK(is_same(over[1][k], apart.back()[k]));
  }

  std::vector<Scalars> arguments_of(const gausssim::Function& function) {
    std::vector<Scalars> arguments;
    for (const gausssim::Parameter& parameter : function.parameters) {
      Scalars values = place(parameter.type);
      if (parameter.is_result) values.assign(values.size(), S(7));
      arguments.push_back(std::move(values));
    }
    return arguments;
  }

  static std::vector<S*> pointers(std::vector<Scalars>& arguments) {
    std::vector<S*> result;
    for (Scalars& values : arguments) result.push_back(values.data());
    return result;
  }

  const CompiledModel<S>& model_;
  gausssim::Interpreter<S> interpreter_;
  typename gausssim::Interpreter<S>::Frame frame_;
  std::map<std::string, Scalars> values_;
  std::mt19937 engine_{5};
  std::size_t compared_ = 0;
};

}  // namespace headertest
