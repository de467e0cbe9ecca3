#include "catch_shim.hpp"
#include "support/suggest.hpp"

using namespace gaussgen::support;

TEST_CASE("a slip of the pen finds its word") {
  CHECK(closest("psy", {"phi", "psi", "chi"}) == "psi");
  CHECK(closest("coordinate", {"coordinates", "constraints"}) == "coordinates");
  CHECK(closest("intial", {"initial", "inertia"}) == "initial");
}

TEST_CASE("swapped letters are one slip") { CHECK(closest("msas", {"mass", "moss"}) == "mass"); }

TEST_CASE("another case of the same letters is the nearest of all") {
  CHECK(closest("theta", {"beta", "Theta"}) == "Theta");
}

TEST_CASE("a single letter is not taken for another one") {
  CHECK(closest("x", {"y", "z"}).empty());
  CHECK(closest("x", {"y", "X"}) == "X");
}

TEST_CASE("what resembles nothing gets no suggestion") {
  CHECK(did_you_mean("friction", {"uniform", "potential"}).empty());
  CHECK(closest("", {"a"}).empty());
  CHECK(closest(std::string(1000, 'a'), {"aa"}).empty());
}

TEST_CASE("equal distances give the first candidate") { CHECK(closest("ab1", {"ab2", "ab3"}) == "ab2"); }
