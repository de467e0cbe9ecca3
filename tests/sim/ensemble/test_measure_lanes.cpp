// Rows for the report of a study. They need a compiler; without one there are none, with a reason.
#include "catch_shim.hpp"
#include "sim/engine/toolchain.hpp"
#include "sim/ensemble/measure_lanes.hpp"

namespace {

std::optional<gausssim::PreparedModel> prepared(const char* model) {
  gausssim::Request request;
  request.file = std::string(GAUSS_SOURCE_DIR) + "/models/" + model + ".yaml";
  int code = 0;
  return gausssim::prepare(
      request, [](gausssim::Scene&) {}, code);
}

}  // namespace

TEST_CASE("what lanes and threads are worth is measured beside one thread") {
  std::string why;
  if (!gausssim::find_toolchain(why)) return;
  const auto model = prepared("kepler");
  REQUIRE(model);
  gausssim::LanesEffort effort;
  effort.seconds = 0.05;
  effort.threads = 2;
  const auto rows = gausssim::measure_lanes(*model, effort, why);
  INFO(why);
  REQUIRE(rows.size() >= 2);
  CHECK(rows.front().lanes == 1);
  CHECK(rows.front().threads == 1);
  CHECK(rows.front().ratio == 1);
  CHECK(rows.back().threads == 2);
  for (const auto& row : rows) {
    CHECK(row.trajectories == rows.front().trajectories);
    CHECK(row.trajectories_per_s > 0);
    CHECK(row.ratio == Approx(row.trajectories_per_s / rows.front().trajectories_per_s));
    WARN(row.lanes << " lanes, " << row.threads << " threads: " << row.trajectories_per_s << "/s, ratio " << row.ratio);
  }
}
