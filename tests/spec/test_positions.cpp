#include "catch_shim.hpp"
#include "reading.hpp"

using test::Read;

TEST_CASE("a plain scalar maps to itself") {
  const Read read("a: x + nope\n");
  CHECK(read.behind("a", "nope") == "nope");
  CHECK(read.source.text(read.at("a").span) == "x + nope");
}

TEST_CASE("a plain scalar over two lines maps each word to its line") {
  const Read read("a: x +\n   nope\n   * 2\n");
  CHECK(read.at("a").scalar.text == "x + nope * 2");
  CHECK(read.behind("a", "nope") == "nope");
  CHECK(read.source.position(read.at("a").scalar.span_of(4, 5).begin).line == 2);
}

TEST_CASE("doubled quotes in single quotes do not shift what follows") {
  const Read read("a: 'it''s nope'\n");
  CHECK(read.at("a").scalar.text == "it's nope");
  CHECK(read.behind("a", "nope") == "nope");
  CHECK(read.source.text(read.at("a").span) == "'it''s nope'");
}

TEST_CASE("escapes in double quotes do not shift what follows") {
  const Read read("a: \"\\x41\\u00e9\\\"\\t nope\"\n");
  CHECK(read.behind("a", "nope") == "nope");
  CHECK(read.source.text(read.at("a").span) == "\"\\x41\\u00e9\\\"\\t nope\"");
}

TEST_CASE("a letter right behind an escape has its own place") {
  for (const char* escape : {"\\x41", "\\u0041", "\\U00000041", "\\\"", "\\\\"}) {
    const Read read("a: \"" + std::string(escape) + "nope\"\n");
    INFO(escape);
    CHECK(read.behind("a", "nope") == "nope");
  }
}

TEST_CASE("a line joined by a backslash does not shift what follows") {
  const Read read("a: \"x + \\\n   nope\"\n");
  CHECK(read.at("a").scalar.text == "x + nope");
  CHECK(read.behind("a", "nope") == "nope");
}

TEST_CASE("folded and literal blocks map through indentation and comments in their header") {
  const Read read("a: >- # header\n    x\n    + nope\n\n    * 2\nb: |\n  x\n    nope\n");
  CHECK(read.at("a").scalar.text == "x + nope\n* 2");
  CHECK(read.behind("a", "nope") == "nope");
  CHECK(read.behind("a", "2") == "2");
  CHECK(read.behind("b", "nope") == "nope");
}

TEST_CASE("letters of several bytes, DOS line ends and a byte order mark do not shift places") {
  const Read read("\xEF\xBB\xBF# \xCE\xB8\r\n\xC3\xBC: x\r\na: nope\r\n");
  CHECK(read.behind("a", "nope") == "nope");
  CHECK(read.source.position(read.at("a").span.begin).line == 3);
  CHECK(read.source.position(read.at("a").span.begin).column == 4);
}

TEST_CASE("past the end of a text is the place behind it") {
  const Read read("a: xy\n");
  const auto span = read.at("a").scalar.span_of(2, 3);
  CHECK(span.begin == 5);
  CHECK(span.end == 5);
}

TEST_CASE("keys know their places") {
  const Read read("a: 1\n\"b c\": 2\n");
  CHECK(read.source.text(read.root->entries[1].key.span) == "\"b c\"");
}
