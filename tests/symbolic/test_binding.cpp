#include "catch_shim.hpp"
#include "symbolic/binding.hpp"

using namespace gaussgen::symbolic;

namespace {

std::vector<std::string> labels(std::size_t n) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(std::to_string(i));
  return result;
}

}  // namespace

TEST_CASE("blocks that do not touch are inverted one by one, small ones explicitly", "[symbolic]") {
  const GiNaC::realsymbol a("a"), b("b"), c("c");
  Bindings bindings;
  const Matrix inverse = bindings.invert("M", labels(3), labels(3), {{0, a, 0}, {b, 0, 1}, {1, 0, c}}, false);
  CHECK(bindings.all().empty());
  CHECK(inverse[1][0].is_equal(1 / ex(a)));
  CHECK(inverse[0][0].is_zero());
  CHECK(inverse[0][1].is_equal(c / (b * c - 1)));
  CHECK(inverse[2][2].is_equal(b / (b * c - 1)));
}

TEST_CASE("larger inverses stay symbols, a symmetric one with one symbol per pair", "[symbolic]") {
  const GiNaC::realsymbol a("a");
  Bindings bindings;
  const Matrix inverse = bindings.invert("M", labels(3), labels(3), {{2, a, 1}, {a, 3, a}, {1, a, 4}}, true);
  REQUIRE(bindings.all().size() == 1);
  CHECK(GiNaC::is_a<GiNaC::symbol>(inverse[0][2]));
  CHECK(inverse[0][2].is_equal(inverse[2][0]));
}

TEST_CASE("a matrix that is singular by structure is refused", "[symbolic]") {
  Bindings bindings;
  CHECK_THROWS(bindings.invert("M", labels(2), labels(2), {{1, 1}, {0, 0}}, false));
}

TEST_CASE("numbers and symbols need no definition", "[symbolic]") {
  const GiNaC::realsymbol a("a");
  Bindings bindings;
  CHECK(bindings.define("n", 3).is_equal(3));
  CHECK(bindings.define("s", a).is_equal(a));
  CHECK(bindings.all().empty());
  CHECK_FALSE(bindings.define("d", a + 1).is_equal(a + 1));
  CHECK(bindings.all().size() == 1);
}
