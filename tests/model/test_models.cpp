#include <filesystem>

#include "building.hpp"
#include "catch_shim.hpp"
#include "support/files.hpp"

namespace fs = std::filesystem;
namespace support = gaussgen::support;

namespace {

support::Source source_of(const fs::path& path) {
  std::string why;
  return {path.string(), support::read_file(path.string(), why).value(), support::read_regular_file};
}

}  // namespace

TEST_CASE("every model of the repository is accepted without a finding") {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(GAUSS_SOURCE_DIR) / "models")) {
    if (entry.path().extension() != ".yaml") continue;
    const test::Built model(source_of(entry.path()));
    INFO(gaussgen::support::render(model.diagnostics, model.source));
    CHECK(model.codes().empty());
    ++count;
  }
  CHECK(count >= 4);
}
