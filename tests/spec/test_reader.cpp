#include "catch_shim.hpp"
#include "reading.hpp"

using gaussgen::spec::NodeKind;
using test::Read;

TEST_CASE("maps keep the order of the file") {
  const Read read("z: 1\na: 2\nm: 3\n");
  REQUIRE(read.root);
  REQUIRE(read.root->entries.size() == 3);
  CHECK(read.root->entries[0].key.text == "z");
  CHECK(read.root->entries[1].key.text == "a");
  CHECK(read.root->entries[2].key.text == "m");
}

TEST_CASE("a key without value, a tilde and null are empty") {
  const Read read("a:\nb: ~\nc: null\nd: ''\n");
  CHECK(read.at("a").kind == NodeKind::empty);
  CHECK(read.at("b").kind == NodeKind::empty);
  CHECK(read.at("c").kind == NodeKind::empty);
  CHECK(read.at("d").kind == NodeKind::scalar);
}

TEST_CASE("numbers and booleans stay the text that was written") {
  const Read read("a: 010\nb: yes\nc: 0x10\nd: 1e400\n");
  CHECK(read.at("a").scalar.text == "010");
  CHECK(read.at("b").scalar.text == "yes");
  CHECK(read.at("c").scalar.text == "0x10");
  CHECK(read.at("d").scalar.text == "1e400");
}

TEST_CASE("lists and maps nest") {
  const Read read("a: [[1, 2], {b: 3}]\n");
  REQUIRE(read.at("a").items.size() == 2);
  CHECK(read.at("a").items[0].items[1].scalar.text == "2");
  CHECK(read.at("a").items[1].entries[0].value.scalar.text == "3");
}

TEST_CASE("a document marker at the start is fine") { CHECK(Read("---\na: 1\n").root); }

TEST_CASE("quoted scalars are not plain") {
  const Read read("a: 'x'\nb: \"x\"\nc: x\n");
  CHECK_FALSE(read.at("a").plain);
  CHECK_FALSE(read.at("b").plain);
  CHECK(read.at("c").plain);
}
