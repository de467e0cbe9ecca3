// What there are no instructions for is refused while a tree is compiled, with its function; what there is, is told by name.

#include <string>

#include "catch_shim.hpp"
#include "sim/interpreter/interpreter.hpp"
#include "sim/interpreter/tree_of.hpp"

namespace cpp = gaussgen::emit::cpp;

namespace {

/// `StatusOf<S> f(const S& x) { const S y = value; … }`
cpp::File tree_with(cpp::Statement statement) {
  cpp::Function function;
  function.type = "StatusOf<S>";
  function.name = "f";
  function.arguments = {{"const S&", "x"}};
  function.body = {std::move(statement), cpp::Return{cpp::call("StatusOf<S>", {})}};
  cpp::File file;
  file.items.emplace_back(std::move(function));
  return file;
}

std::string refusal(cpp::Statement statement) {
  try {
    (void)gausssim::compile(tree_with(std::move(statement)));
  } catch (const gausssim::NotRunnable& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of(cpp::Expression value) { return refusal(cpp::Definition{"const S", "y", std::move(value)}); }

const cpp::Expression k_x = cpp::atom("x");

}  // namespace

TEST_CASE("what has no instructions is refused with the function that it is in") {
  CHECK(refusal_of(k_x).empty());
  const std::string head = "the function 'f' cannot be interpreted: ";
  CHECK(refusal_of(cpp::call("Math<S>::gamma", {k_x})) == head + "Math<S>::gamma of 1 arguments");
  CHECK(refusal_of(cpp::call("Math<S>::sin", {k_x, k_x})) == head + "Math<S>::sin of 2 arguments");
  CHECK(refusal_of(cpp::call("lookup", {k_x})) == head + "a call of 'lookup'");
  CHECK(refusal_of(cpp::call("S", {k_x})) == head + "'x' is no number");
  CHECK(refusal_of(cpp::atom("z")) == head + "'z' is not known");
  CHECK(refusal_of(cpp::atom("x.y")) == head + "'x' has no members");
  CHECK(refusal_of(cpp::atom("x[0]")) == head + "'x[0]' is no value");
  CHECK(refusal_of(cpp::atom("x - 1")) == head + "'x - 1' is no name of a value");
  CHECK(refusal_of(cpp::list({k_x})) == head + "a list where a value is expected");
  CHECK(refusal(cpp::Declaration{"Matrix<S>", {"m"}}) == head + "the type 'Matrix'");
  CHECK(refusal(cpp::Alias{"Other", "double"}) == head + "the type 'Other'");
  CHECK(refusal(cpp::Evaluation{k_x}) == head + "a statement without effect");
  CHECK(refusal(cpp::Loop{"i", "0", "m", {}}) == head + "'m' is no whole number");
}

TEST_CASE("an index outside of an array is refused") {
  cpp::File tree = tree_with(cpp::Declaration{"S", {"piece[2]"}});
  auto& body = std::get<cpp::Function>(tree.items[0]).body;
  body.insert(body.begin() + 1, cpp::Statement(cpp::Assignment{cpp::atom("piece[2]"), k_x}));
  CHECK_THROWS_WITH(gausssim::compile(tree), Catch::Contains("[2] is outside of an array"));
}

TEST_CASE("functions and structs are told by name, shape and place") {
  const gausssim::Interpreter<double> run(
      headertest::compiled_model("models/sphere_in_cylinder.yaml rhs reactions jacobian").tree);
  CHECK(run.find("no_such_function") == -1);
  CHECK(run.find("dense") == -1);
  CHECK(run.size_of("State") == 10);
  CHECK(run.size_of("NoSuchStruct") == 0);
  const gausssim::Function& rhs = run.program().functions[static_cast<std::size_t>(run.find("rhs"))];
  REQUIRE(rhs.parameters.size() == 5);
  CHECK(rhs.parameters[0].type == "S");
  CHECK(rhs.parameters[1].type == "State");
  CHECK(rhs.parameters[4].name == "derivative");
  CHECK(rhs.parameters[4].is_result);
  const gausssim::Layout* const reactions = run.program().struct_of("Reactions");
  REQUIRE(reactions != nullptr);
  const auto generalized = reactions->places.find("rolling_around.generalized");
  REQUIRE(generalized != reactions->places.end());
  CHECK(reactions->members[generalized->second].shape == gausssim::Shape{5});
  REQUIRE_FALSE(run.program().patterns.empty());
  const gausssim::Pattern& pattern = run.program().patterns.front();
  CHECK(pattern.row_begin.size() == static_cast<std::size_t>(pattern.rows) + 1);
}
