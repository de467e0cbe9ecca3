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

support::Diagnostics findings(support::Source& source) {
  support::Diagnostics diagnostics;
  const bool is_compiled = compile(source, {}, diagnostics, {}).has_value();
  CHECK(is_compiled == !diagnostics.has_errors());
  return diagnostics;
}

std::string rendered(const fs::path& path) {
  support::Source source = source_of(path);
  const support::Diagnostics found = findings(source);
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
    if (code.id == support::code::k_no_paper_route.id) continue;  // of another route
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
