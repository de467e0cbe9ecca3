#include <string>

#include "catch_shim.hpp"
#include "support/diagnostics.hpp"

using namespace gaussgen::support;

namespace {

std::string rendered(const std::string& text, Span span, const std::string& hint = {}) {
  Diagnostics diagnostics;
  diagnostics.error("E031", span, "a message", hint);
  return render(diagnostics, Source("m.yaml", text));
}

/// Line `index` of a rendered finding.
std::string line_of(const std::string& text, int index) {
  std::size_t begin = 0;
  for (int i = 0; i < index; ++i) begin = text.find('\n', begin) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("a finding shows place, code, line, caret and hint") {
  const std::string text(11, '\n');
  CHECK(rendered(text + "a: psy + 1\n", {14, 17}, "did you mean 'psi'?") ==
        "m.yaml:12:4: error[E031]: a message\n"
        " 12 | a: psy + 1\n"
        "    |    ^~~\n"
        "    = hint: did you mean 'psi'?\n");
}

TEST_CASE("findings come in the order of the text, whatever the order of the checks") {
  Diagnostics diagnostics;
  diagnostics.error("E031", {4, 5}, "second");
  diagnostics.warning("W050", {0, 1}, "first");
  const std::string text = render(diagnostics, Source("m.yaml", "a\nb\nc\n"));
  CHECK(text.find("warning[W050]: first") < text.find("error[E031]: second"));
}

TEST_CASE("a warning is not an error") {
  Diagnostics diagnostics;
  diagnostics.warning("W050", {0, 1}, "idle");
  CHECK_FALSE(diagnostics.has_errors());
  diagnostics.error("E031", {0, 1}, "bad");
  CHECK(diagnostics.has_errors());
  CHECK(diagnostics.all().size() == 2);
}

TEST_CASE("a caret stands below its character behind tabs and letters of several bytes") {
  CHECK(line_of(rendered("\tx", {1, 2}), 2) == "   |  ^");
  CHECK(line_of(rendered("\xCE\xB8 x", {3, 4}), 2) == "   |   ^");
  CHECK(line_of(rendered("e\xCC\x81 x", {4, 5}), 2) == "   |   ^");
  CHECK(line_of(rendered("\xE4\xB8\xAD x", {4, 5}), 2) == "   |    ^");
}

TEST_CASE("an empty span has a caret") {
  CHECK(line_of(rendered("ab", {2, 2}), 2) == "   |   ^");
  CHECK(line_of(rendered("", {0, 0}), 2) == "   | ^");
}

TEST_CASE("a span over several lines is marked to the end of its first line") {
  CHECK(line_of(rendered("ab\ncd", {1, 5}), 2) == "   |  ^");
  CHECK(line_of(rendered("abc\ncd", {1, 6}), 2) == "   |  ^~");
}

TEST_CASE("a long line is shown through a window around the caret") {
  const std::string text = std::string(500, 'a') + "X" + std::string(500, 'b');
  const std::string shown = rendered(text, {500, 501});
  const std::string line = line_of(shown, 1);
  CHECK(line.size() < 200);
  CHECK(line[line_of(shown, 2).find('^')] == 'X');
  CHECK(line.find("...") != std::string::npos);
}

TEST_CASE("the window of an error near the end of a long line ends with the line") {
  const std::string shown = rendered(std::string(500, 'a') + "X", {500, 501});
  CHECK(line_of(shown, 1).back() == 'X');
  CHECK(line_of(shown, 1)[line_of(shown, 2).find('^')] == 'X');
}

TEST_CASE("nothing that a terminal obeys reaches the output") {
  const std::string shown = rendered(
      "a\x1B[31m\xE2\x80\xAE"
      "b",
      {0, 1}, "\x1B[0m");
  CHECK(shown.find('\x1B') == std::string::npos);
  CHECK(shown.find("\xE2\x80\xAE") == std::string::npos);
}

TEST_CASE("a message stays in one line") {
  Diagnostics diagnostics;
  diagnostics.error("E031", {0, 1}, "two\nlines");
  CHECK(line_of(render(diagnostics, Source("m.yaml", "a")), 0) == "m.yaml:1:1: error[E031]: two lines");
}

TEST_CASE("after a hundred findings the rest is counted") {
  Diagnostics diagnostics;
  for (std::uint32_t i = 0; i < 103; ++i) diagnostics.error("E031", {i, i + 1}, "again");
  CHECK(render(diagnostics, Source("m.yaml", std::string(103, 'a'))).find("and 3 more findings") != std::string::npos);
}

TEST_CASE("the same mistake in copies of an entry is shown once, with the names of all that have it") {
  Diagnostics diagnostics;
  for (const char* name : {"p_1", "p_2", "p_13"})
    diagnostics.error("E010", {0, 1}, std::string("particle '") + name + "' is odd");
  diagnostics.error("E010", {0, 1}, "particle 'q' is odd");
  const std::string text = render(diagnostics, Source("m.yaml", "a"));
  CHECK(text.find("'p_1'") != std::string::npos);
  CHECK(text.find("particle 'p_1' is odd; likewise 'p_2', 'p_13'\n") != std::string::npos);
  CHECK(text.find("particle 'p_2'") == std::string::npos);
  CHECK(text.find("'q'") != std::string::npos);
}

TEST_CASE("of many copies a few are named, and the others counted") {
  Diagnostics diagnostics;
  for (int i = 1; i <= 9; ++i) diagnostics.error("E010", {0, 1}, "particle 'p_" + std::to_string(i) + "' is odd");
  CHECK(render(diagnostics, Source("m.yaml", "a"))
            .find("'p_1' is odd; likewise 'p_2', 'p_3', 'p_4', 'p_5' and 4 more\n") != std::string::npos);
}

TEST_CASE("copies with the very same mistake are not listed") {
  Diagnostics diagnostics;
  for (int i = 0; i < 3; ++i) diagnostics.error("E010", {0, 1}, "there is no parameter 'k'");
  CHECK(render(diagnostics, Source("m.yaml", "a")).find("likewise") == std::string::npos);
}
