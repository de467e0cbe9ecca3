#include "catch_shim.hpp"
#include "emit/text.hpp"

using namespace gaussgen::emit;

TEST_CASE("a comment stays on its line and ends nothing") {
  CHECK(comment_text("mass of the ball, µ = 0.3") == "mass of the ball, µ = 0.3");
  CHECK(comment_text("a\nint b;") == "a int b;");
  CHECK(comment_text("a\r\n\tb\x01") == "a   b");
  CHECK(comment_text("*/ #error") == "* / #error");
  CHECK(comment_text("tail \\") == "tail \\ .");
  CHECK(comment_text("tail ?\?/") == "tail ? ?/");
  CHECK(comment_text("\xE2\x80\xAEright to left\xE2\x80\xA8new line") == "right to left new line");
  CHECK(comment_text("\xFF") == "?");
}

TEST_CASE("a string literal reads back as the text") {
  CHECK(string_literal("kg*m^2") == "\"kg*m^2\"");
  CHECK(string_literal("\"\\") == "\"\\\"\\\\\"");
  CHECK(string_literal("a\n1") == "\"a\\0121\"");
  CHECK(string_literal("?\?/") == "\"?\\?/\"");
  CHECK(string_literal("\xE2\x80\xAE") == "\"\\342\\200\\256\"");
}

TEST_CASE("no line of a wrapped comment ends with a backslash") {
  CHECK(wrapped("aaa \\ bbb", 5) == "aaa \\ .\nbbb");
}

TEST_CASE("columns of a table are aligned by what is seen, not by bytes") {
  CHECK(table_text({{"µ", "1"}, {"ab", "2"}}, "") == "µ   1\nab  2");
}
