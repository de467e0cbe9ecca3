// Hidden: what a call costs, interpreted and compiled (test_interpreter "[.speed]").

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

#include "catch_shim.hpp"
#include "sim/interpreter/interpreter.hpp"
#include "sim/interpreter/compiled.hpp"
#include "sim/interpreter/tree_of.hpp"

namespace {

/// Of the fastest of some rounds, in nanoseconds.
double time_of(const std::function<void()>& work, int times) {
  double best = 1e300;
  for (int round = 0; round < 20; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) work();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
    best = std::min(best, taken.count() / times);
  }
  return best;
}

void measure(const headertest::CompiledModel<double>& model) {
  const gaussgen::emit::cpp::File tree = headertest::compiled_model(model.model).tree;
  const double compilation = time_of([&] { (void)gausssim::compile(tree); }, 3);
  const gausssim::Interpreter<double> run(tree);
  auto frame = run.frame();
  const auto make = [&](const char* type) { return std::vector<double>(std::max<std::size_t>(run.size_of(type), 1)); };
  std::vector<double> t(1), parameters = make("Parameters"), inputs = make("Inputs"), prepared = make("Prepared"),
                            state = make("State"), derivative = make("Derivative");
  const auto call = [&](const char* name, std::vector<double*> arguments) {
    if (run.find(name) >= 0) (void)run.call(run.find(name), arguments.data(), frame);
  };
  call("Parameters", {parameters.data()});
  call("prepare", {parameters.data(), prepared.data()});
  call("initial_state", {prepared.data(), state.data()});
  double* const arguments[] = {t.data(), state.data(), inputs.data(), prepared.data(), derivative.data()};
  const int rhs = run.find("rhs");
  const double interpreted = time_of([&] { (void)run.call(rhs, arguments, frame); }, 2000);
  double compiled = 0;
  for (const auto& function : model.functions) {
    if (function.name == "rhs") compiled = time_of([&] { (void)function.call(arguments); }, 2000);
  }
  std::printf(
      "%s: rhs %.0f ns interpreted, %.0f ns compiled (with copies of its arguments); %zu instructions in %.2f ms\n",
      model.model.c_str(), interpreted, compiled, run.program().code.size(), compilation / 1e6);
}

}  // namespace

TEST_CASE("rhs, interpreted and compiled", "[.speed]") {
  for (const headertest::CompiledModel<double>& model : headertest::compiled_models<double>()) {
    for (const char* const name :
         {"models/sphere_in_cylinder.yaml", "models/double_pendulum.yaml", "models/chain.yaml n=10"}) {
      if (model.model == name) measure(model);
    }
  }
}
