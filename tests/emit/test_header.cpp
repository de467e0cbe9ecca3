#include <sstream>

#include "catch_shim.hpp"
#include "emit/header.hpp"
#include "units.hpp"

using gaussgen::emit::emit_header;

namespace {

std::string emitted(const std::string& name) {
  const gausstest::Sample sample = gausstest::sample(name);
  return emit_header(sample.graph, sample.unit);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++found;
  return found;
}

}  // namespace

TEST_CASE("the same unit gives the same bytes") {
  for (const std::string& name : gausstest::sample_names()) {
    const gausstest::Sample sample = gausstest::sample(name);
    CHECK(emit_header(sample.graph, sample.unit) == emit_header(sample.graph, sample.unit));
    CHECK(emit_header(sample.graph, sample.unit) == emitted(name));
  }
}

TEST_CASE("nodes that nobody asked for leave no trace") {
  gausstest::Sample sample = gausstest::springs();
  gaussgen::ir::Graph& graph = sample.graph;
  const auto x = graph.use(sample.unit.configuration[0].symbol);
  auto litter = x;
  for (int i = 0; i < 100; ++i) litter = graph.call(gaussgen::ir::Function::exp, {litter});
  CHECK(emit_header(graph, sample.unit) == emitted("springs"));
}

TEST_CASE("every header carries the prelude, and needs the standard library only") {
  for (const std::string& name : gausstest::sample_names()) {
    const std::string text = emitted(name);
    CHECK(count(text, std::string(gaussgen::emit::prelude())) == 1);
    CHECK(count(text, "#include") == 5);
    for (const char* each : {"<cmath>", "<cstdint>", "<cstring>", "<limits>", "<type_traits>"})
      CHECK(count(text, std::string("#include ") + each) == 1);
  }
}

TEST_CASE("lines are short, and none ends with a space or a backslash by accident") {
  for (const std::string& name : gausstest::sample_names()) {
    const std::string text = emitted(name);
    std::istringstream lines(text.substr(text.rfind("\nnamespace ")));
    std::string line;
    while (std::getline(lines, line)) {
      INFO(line);
      // String tables hold what users wrote.
      CHECK((line.size() <= 110 || line.find('"') != std::string::npos));
      CHECK((line.empty() || (line.back() != ' ' && line.back() != '\\')));
    }
  }
}

TEST_CASE("sine and cosine of one angle are one call, a power is a product, a denominator divides once") {
  const std::string pendulum = emitted("pendulum");
  CHECK(count(pendulum, "Math<S>::sincos(theta, sin_theta, cos_theta);") == 2);
  CHECK(count(pendulum, "prepared.inv_m_l_2 = S(1) / (m * l_2);") == 1);
  CHECK(count(pendulum, "derivative.theta_ddot() = theta_ddot;") == 2);
}

TEST_CASE("what other functions call a thing is no reason to number it here: x_2 is a square") {
  const std::string text = emitted("namesakes");
  CHECK(count(text, "K_2") == 0);
  CHECK(count(text, "const S r_2_over_J = r * r / J;") == 1);
  CHECK(count(text, "const S K = S(1) / m + r_2_over_J;") == 1);
  CHECK(count(text, "const S K = r * r / J;") == 1);
  CHECK(count(text, "state.x() = x;") == 1);
  CHECK(count(text, "state.x() = x_new;") == 1);
  CHECK(count(text, "const S pivot = ") == 1);
  CHECK(count(text, "const S x_x_dot = x * x_dot;") == 1);
}

TEST_CASE("no decision is taken on data, and nothing is allocated or thrown") {
  for (const std::string name : {"pendulum", "springs", "zoo"}) {  // the fourth has such words in its comments
    const std::string text = emitted(name);
    const std::string model = text.substr(text.rfind("\nnamespace "));
    for (const char* word : {"if (", " ? ", "= new", "throw", "std::", "while ("}) CHECK(count(model, word) == 0);
  }
}
