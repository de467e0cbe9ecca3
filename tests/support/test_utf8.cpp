#include "catch_shim.hpp"
#include "support/utf8.hpp"

using namespace gaussgen::support;

namespace {

bool valid(std::string_view text) {
  const CodePoint point = code_point_at(text, 0);
  return point.valid && point.size == text.size();
}

}  // namespace

TEST_CASE("well-formed sequences of one to four bytes are read") {
  CHECK(valid("a"));
  CHECK(valid("\xC3\xBC"));
  CHECK(valid("\xE2\x88\x92"));
  CHECK(valid("\xF0\x9F\x98\x80"));
  CHECK(code_point_at("\xE2\x88\x92", 0).value == 0x2212);
}

TEST_CASE("overlong forms, surrogates and values beyond Unicode are refused") {
  CHECK_FALSE(valid("\xC0\xAF"));
  CHECK_FALSE(valid("\xE0\x80\xAF"));
  CHECK_FALSE(valid("\xED\xA0\x80"));
  CHECK_FALSE(valid("\xF4\x90\x80\x80"));
  CHECK_FALSE(valid("\xFF"));
}

TEST_CASE("a sequence cut short is one invalid byte") {
  CHECK_FALSE(code_point_at("\xE2\x88", 0).valid);
  CHECK(code_point_at("\xE2\x88", 0).size == 1);
  CHECK_FALSE(code_point_at("\xE2zz", 0).valid);
}

TEST_CASE("tabs and line breaks are no control characters") {
  CHECK_FALSE(is_control('\t'));
  CHECK_FALSE(is_control('\n'));
  CHECK(is_control(0x1B));
  CHECK(is_control(0x7F));
  CHECK(is_control(0x85));
}

TEST_CASE("bidirectional controls and zero-width characters are invisible") {
  for (const char32_t value : {0x202AU, 0x202EU, 0x2066U, 0x2069U, 0x200BU, 0x200EU, 0xFEFFU})
    CHECK(is_invisible(value));
  CHECK_FALSE(is_invisible(' '));
  CHECK_FALSE(is_invisible(0x03B8));
}

TEST_CASE("what a terminal would obey is replaced, line ends between lines are not") {
  CHECK(without_controls("no \x1B[31mfile\r 'caf\xE9'\n\tθ") ==
        "no \xEF\xBF\xBD[31mfile\xEF\xBF\xBD 'caf\xEF\xBF\xBD'\n\tθ");
}
