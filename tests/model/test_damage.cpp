// Models with random damage: whatever the text, reading ends with a model or with findings inside the text.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "building.hpp"
#include "catch_shim.hpp"

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> k_pieces = {"(",         ")",
                                           "[",         "]",
                                           "{",         "}",
                                           ",",         ":",
                                           ": ",        "\n",
                                           "  ",        "\t",
                                           "#",         " #",
                                           "'",         "\"",
                                           "\\",        "&a",
                                           "*a",        "!t",
                                           "- ",        "? ",
                                           "| ",        ">\n",
                                           "---\n",     "...\n",
                                           "%",         "^",
                                           "^64",       "**",
                                           "/0",        "1e308",
                                           "-",         "+",
                                           ".",         "_",
                                           "dot(",      "sin(",
                                           "atan2(",    "t",
                                           "pi",        "null",
                                           "~",         "\xCE\xB8",
                                           "\xFF",      "\xEF\xBB\xBF",
                                           "\r",        "x_dot",
                                           "held_at: ", "<<: "};

std::vector<std::string> seeds() {
  std::vector<fs::path> paths;
  for (const char* folder : {"models", "tests/diagnostics"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(GAUSS_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".yaml") paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t limit) { return random_() % limit; }

  void apply(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    switch (below(4)) {
      case 0: text.insert(at, k_pieces[below(k_pieces.size())]); break;
      case 1: text.erase(at, 1 + below(8)); break;
      case 2: text.insert(at, text.substr(below(text.size() + 1), below(40))); break;
      default:
        text = text.substr(0, at) + k_pieces[below(k_pieces.size())] + text.substr(std::min(text.size(), at + 1));
        break;
    }
  }

 private:
  std::mt19937 random_;
};

void check(const std::string& text) {
  const test::Built built(text);
  CHECK(built.model.has_value() == !built.diagnostics.has_errors());
  for (const auto& finding : built.diagnostics.all()) {
    CHECK(finding.span.begin <= text.size());
    CHECK(finding.span.begin <= finding.span.end);
  }
  CHECK(gaussgen::support::render(built.diagnostics, built.source).empty() == built.diagnostics.all().empty());
}

}  // namespace

TEST_CASE("no damage to a model makes reading fail otherwise than by findings") {
  const std::vector<std::string> texts = seeds();
  for (unsigned seed = 0; seed < 3'000; ++seed) {
    Damage damage(seed);
    std::string text = texts[damage.below(texts.size())];
    for (std::size_t i = damage.below(4) + 1; i > 0; --i) damage.apply(text);
    INFO("seed " << seed);
    REQUIRE_NOTHROW(check(text));
  }
}
