#include <filesystem>

#include "catch_shim.hpp"
#include "model_files.hpp"

namespace fs = std::filesystem;

// Parts of models are tested with the models that they are parts of, families by tests/cli/test_families.py.
TEST_CASE("the properties are tested on every file below models/") {
  const fs::path models = fs::path(GAUSS_SOURCE_DIR) / "models";
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(models)) {
    const fs::path folder = entry.path().parent_path();
    if (entry.path().extension() != ".yaml" || folder == models / "parts" || folder == models / "families") continue;
    found.push_back(fs::relative(entry.path(), models).replace_extension().generic_string());
  }
  CHECK(found.size() >= 11);
  CHECK_THAT(agreement::model_files(), Catch::UnorderedEquals(found));
}
