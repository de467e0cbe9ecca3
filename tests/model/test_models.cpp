#include <filesystem>
#include <fstream>
#include <sstream>

#include "building.hpp"
#include "catch_shim.hpp"

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("every model of the repository is accepted without a finding") {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(GAUSS_SOURCE_DIR) / "models")) {
    if (entry.path().extension() != ".yaml") continue;
    const test::Built model(text_of(entry.path()), entry.path().filename().string());
    INFO(gaussgen::support::render(model.diagnostics, model.source));
    CHECK(model.codes().empty());
    ++count;
  }
  CHECK(count >= 4);
}
