// Model files and the exact text that a user sees for them. GAUSS_UPDATE=1 rewrites the texts; read the
// difference before committing it.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "catch_shim.hpp"
#include "model/build.hpp"
#include "pipeline.hpp"
#include "support/error_codes.hpp"
#include "support/files.hpp"

namespace fs = std::filesystem;
using namespace gaussgen;

namespace {

const fs::path k_folder = fs::path(GAUSS_SOURCE_DIR) / "tests" / "diagnostics";

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Messages name files from the root of the project, wherever that is.
support::Source source_of(const fs::path& path) {
  const auto read_part = [](const std::string& name, std::string& why) {
    return support::read_regular_file(std::string(GAUSS_SOURCE_DIR) + "/" + name, why);
  };
  return {"tests/diagnostics/" + path.filename().string(), read(path), read_part};
}

support::Diagnostics findings(support::Source& source, bool only_check = false) {
  support::Diagnostics diagnostics;
  PipelineOptions options;
  options.only_check = only_check;
  const bool is_compiled = compile(source, options, diagnostics, {}).has_value();
  CHECK(is_compiled == !diagnostics.has_errors());
  return diagnostics;
}

std::string rendered(const fs::path& path, bool only_check = false) {
  support::Source source = source_of(path);
  const support::Diagnostics found = findings(source, only_check);
  return support::render(found, source);
}

std::vector<fs::path> cases() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(k_folder)) {
    if (entry.path().extension() == ".yaml") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

fs::path expectation_of(fs::path model) { return model.replace_extension(".txt"); }

/// Where keys of these names stand in the text of a model.
std::vector<std::size_t> ends_of_keys(const std::string& text) {
  std::vector<std::size_t> ends;
  for (const char* key : {"gauss",       "name",   "parameters", "coordinates", "orientations", "joints", "frames",
                          "points",      "bodies", "particles",  "constraints", "forces",       "speeds", "submodels",
                          "counts",      "count",  "tables",     "inputs",      "quantities",   "type",   "child",
                          "parent",      "mass",   "quaternion", "position",    "at",           "on",     "file",
                          "orientation", "value",  "angles",     "axis",        "centre",       "held_at"}) {
    const std::string word = std::string(key) + ":";
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      const char before = at == 0 ? '\n' : text[at - 1];
      if (std::string(" \n{").find(before) != std::string::npos) ends.push_back(at + word.size() - 1);
    }
  }
  return ends;
}

bool updating() { return std::getenv("GAUSS_UPDATE") != nullptr; }

}  // namespace

TEST_CASE("every faulty model is reported with exactly the expected text") {
  REQUIRE(cases().size() >= 250);
  for (const fs::path& path : cases()) {
    INFO(path.filename().string());
    const std::string text = rendered(path);
    CHECK_FALSE(text.empty());
    if (updating()) {
      std::ofstream(expectation_of(path), std::ios::binary) << text;
    } else {
      CHECK(text == read(expectation_of(path)));
    }
  }
}

TEST_CASE("a check finds what a generation finds, without forming the outputs") {
  for (const fs::path& path : cases()) {
    INFO(path.filename().string());
    CHECK(rendered(path, true) == read(expectation_of(path)));
  }
}

TEST_CASE("a file is named after a code that it raises") {
  for (const fs::path& path : cases()) {
    INFO(path.filename().string());
    std::string code = path.filename().string().substr(0, 4);
    code[0] = static_cast<char>(code[0] - 'a' + 'A');
    CHECK(rendered(path).find("[" + code + "]") != std::string::npos);
  }
}

TEST_CASE("every finding says what to do") {
  for (const fs::path& path : cases()) {
    support::Source source = source_of(path);
    const support::Diagnostics all = findings(source);
    for (const support::Diagnostic& found : all.all()) {
      INFO(path.filename().string() << ": " << found.message);
      CHECK_FALSE(found.hint.empty());
    }
  }
}

TEST_CASE("every code has a case") {
  std::set<std::string> seen;
  for (const fs::path& path : cases()) seen.insert(path.filename().string().substr(1, 3));
  for (const support::ErrorCode& code : support::k_all_codes) {
    INFO(code.id << ": " << code.meaning);
    CHECK(seen.count(std::string(code.id).substr(1)) == 1);
  }
  for (const support::ErrorCode& code : support::k_stage_codes) {
    // Of another route, or of a strategy that nobody chose.
    if (code.id == support::code::k_no_paper_route.id || code.id == support::code::k_no_tree.id) continue;
    INFO(code.id << ": " << code.meaning);
    CHECK(seen.count(std::string(code.id).substr(1)) == 1);
  }
}

TEST_CASE("no expected text is left without its model") {
  for (const auto& entry : fs::directory_iterator(k_folder)) {
    if (entry.path().extension() != ".txt" || entry.path().filename() == "CMakeLists.txt") continue;
    INFO(entry.path().filename().string());
    fs::path model = entry.path();
    CHECK(fs::exists(model.replace_extension(".yaml")));
  }
}

TEST_CASE("a slip in a key brings no errors but those about keys") {
  const fs::path models = fs::path(GAUSS_SOURCE_DIR) / "models";
  const auto read_part = [&](const std::string& name, std::string& why) {
    return support::read_regular_file((models / name).string(), why);
  };
  for (const auto& entry : fs::directory_iterator(models)) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string text = read(entry.path());
    for (const std::size_t end : ends_of_keys(text)) {
      INFO(entry.path().filename().string() << ", byte " << end);
      support::Source source(entry.path().filename().string(), std::string(text).insert(end, "q"), read_part);
      support::Diagnostics found;
      model::build_model(source, found);
      const support::Source& place = source;
      for (const support::Diagnostic& finding : found.all()) {
        INFO(place.line_text(finding.span.begin) << ": " << finding.message);
        const bool is_about_keys =
            finding.code == support::code::k_unknown_key.id || finding.code == support::code::k_missing_key.id;
        CHECK((is_about_keys || finding.severity == support::Severity::warning));
      }
    }
  }
}
