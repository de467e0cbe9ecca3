#include "catch_shim.hpp"
#include "support/source.hpp"

using gaussgen::support::Source;

TEST_CASE("lines and columns count from one") {
  const Source source("m.yaml", "ab\ncd\n");
  CHECK(source.position(0).line == 1);
  CHECK(source.position(0).column == 1);
  CHECK(source.position(4).line == 2);
  CHECK(source.position(4).column == 2);
  CHECK(source.line(4) == 2);
}

TEST_CASE("a column counts characters and not bytes") {
  const Source source("m.yaml", "\xCE\xB8=x");
  CHECK(source.position(2).column == 2);
  CHECK(source.position(3).column == 3);
}

TEST_CASE("a line comes without its line break, also one of DOS") {
  const Source source("m.yaml", "first\r\nsecond");
  CHECK(source.line_at(2) == "first");
  CHECK(source.line_at(9) == "second");
}

TEST_CASE("an offset at the end of the text lies in the last line") {
  CHECK(Source("m.yaml", "").position(0).line == 1);
  CHECK(Source("m.yaml", "").line_at(0).empty());
  CHECK(Source("m.yaml", "a\n").position(2).line == 2);
}

TEST_CASE("a span outside the text gives what is inside") {
  const Source source("m.yaml", "abc");
  CHECK(source.text({1, 9}) == "bc");
  CHECK(source.text({7, 9}).empty());
  CHECK(source.text({2, 1}).empty());
}
