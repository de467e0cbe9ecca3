#include "catch_shim.hpp"
#include "reading.hpp"

using gaussgen::spec::NodeKind;
using test::Read;

TEST_CASE("a call with two arguments in a list is one item") {
  const Read read("a: [0, atan2(y, x), 1]\n");
  REQUIRE(read.at("a").items.size() == 3);
  CHECK(read.at("a").items[1].scalar.text == "atan2(y,x)");
  CHECK(read.source.text(read.at("a").items[1].span) == "atan2(y, x)");
}

TEST_CASE("nested calls are put together") {
  const Read read("a: [atan2(atan2(a, b), (c)), 2]\n");
  REQUIRE(read.at("a").items.size() == 2);
  CHECK(read.at("a").items[0].scalar.text == "atan2(atan2(a,b),(c))");
}

TEST_CASE("a call with two arguments in a map is one value") {
  const Read read("a: {potential: atan2(y, x), about: words}\n");
  REQUIRE(read.at("a").entries.size() == 2);
  CHECK(read.at("a").entries[0].value.scalar.text == "atan2(y,x)");
  CHECK(read.at("a").entries[1].key.text == "about");
}

TEST_CASE("equal arguments in a map are no duplicate keys") { CHECK(Read("a: {p: f(x, x, x)}\n").root); }

TEST_CASE("a place behind the comma is where it stands in the file") {
  const Read read("a: [atan2(y, nope)]\n");
  const auto& scalar = read.at("a").items[0].scalar;
  const std::size_t begin = scalar.text.find("nope");
  CHECK(read.source.text(scalar.span_of(begin, begin + 4)) == "nope");
}

TEST_CASE("items that no joining balances stay as they are") {
  CHECK(Read("a: [f(x, y, 1]\n").at("a").items.size() == 3);
  CHECK(Read("a: [f(x, 'y)', 1]\n").at("a").items.size() == 3);
  CHECK(Read("a: [x), f(y]\n").at("a").items.size() == 2);
  CHECK(Read("a: [f(x, y))(]\n").at("a").items.size() == 2);
}

TEST_CASE("a key with a value is never taken for an argument") {
  CHECK(Read("a: {p: f(x, y): 1}\n").at("a").entries.size() == 2);
}

TEST_CASE("a block list is not touched") { CHECK(Read("a:\n  - f(x\n  - y)\n").at("a").items.size() == 2); }

TEST_CASE("a long list of open brackets is read in no time") {
  std::string text = "a: [";
  for (int i = 0; i < 50'000; ++i) text += "(,";
  CHECK(Read(text + "1]\n").root);
}
