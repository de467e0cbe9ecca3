// A search of a tree made by hand: when it ends is told by how far it came.

#include <vector>

#include "catch_shim.hpp"
#include "sim/interpreter/interpreter.hpp"

namespace cpp = gaussgen::emit::cpp;

namespace {

/// `state.values[0] = from.values[0] + S(5e-14)`
cpp::Function step() {
  cpp::Function function;
  function.type = "StatusOf<S>";
  function.name = "step";
  function.arguments = {{"const State<S>&", "from"}, {"State<S>&", "state"}};
  const cpp::Expression moved = cpp::sum({cpp::atom("from.values[0]"), cpp::call("S", {cpp::atom("5e-14")})});
  function.body = {cpp::Assignment{cpp::atom("state.values[0]"), moved}, cpp::Return{cpp::call("StatusOf<S>", {})}};
  return function;
}

/// Eight steps at most, as emit/functions.cpp writes them.
cpp::Function search(const char* by_one) {
  cpp::Function function;
  function.type = "StatusOf<S>";
  function.name = "search";
  function.arguments = {{"State<S>&", "state"}};
  const cpp::Expression status = cpp::call("step", {cpp::atom("state"), cpp::atom("state")});
  const cpp::Expression taken =
      cpp::call("steps.take", {status, cpp::atom("before.values"), cpp::atom("state.values"), cpp::atom("by_one")});
  cpp::Loop loop{"i", "0", "8", {}, "steps.goes_on()"};
  loop.body.push_back({cpp::Definition{"const State<S>", "before", cpp::atom("state")}});
  loop.body.push_back(
      {cpp::Assignment{cpp::atom("status"), cpp::call("Math<S>::worse", {cpp::atom("status"), taken})}});
  function.body = {cpp::Definition{"StatusOf<S>", "status", cpp::call("StatusOf<S>", {})},
                   cpp::Definition{"const int", "by_one[1]", cpp::list({cpp::atom(by_one)})},
                   cpp::Declaration{"detail::Newton<S>", {"steps"}}, std::move(loop), cpp::Return{cpp::atom("status")}};
  return function;
}

double end_of_search(double begin, const char* by_one) {
  cpp::File tree;
  cpp::Struct state;
  state.name = "State";
  state.members = {{"S", "values", {"1"}, std::nullopt, ""}};
  tree.items = {state, step(), search(by_one)};
  const gausssim::Interpreter<double> run(tree);
  auto frame = run.frame();
  double* const arguments[] = {&begin};
  CHECK(run.call(run.find("search"), arguments, frame) == gauss::Status::ok);
  return begin;
}

double after(int steps, double begin) {
  for (int i = 0; i < steps; ++i) begin = begin + 5e-14;
  return begin;
}

}  // namespace

TEST_CASE("a search ends after a step that moves a component by nearly nothing of its size") {
  CHECK(end_of_search(1, "0") == after(1, 1));
  CHECK(end_of_search(1e-3, "0") == after(8, 1e-3));
}

TEST_CASE("what is measured by 1 as well has arrived where its own size would not do") {
  CHECK(end_of_search(1e-3, "1") == after(1, 1e-3));
}
