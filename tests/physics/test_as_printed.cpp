// The three slips of the paper that change physics (docs/theory.md, section 9), shown instead of asserted. The figures are
// those that the demo prints.
#include "catch_shim.hpp"
#include "sphere/slips.hpp"

TEST_CASE("(3.6) with the printed sign gives other accelerations than the multipliers (3.4)") {
  const sphere::EliminationSlip slip = sphere::elimination_sign();
  CHECK(slip.printed == Approx(44).margin(0.5));
  CHECK(slip.corrected < 1e-12);
}

TEST_CASE("the printed sign of the second rolling constraint makes the contact slip") {
  const sphere::RollingSlip slip = sphere::rolling_along();
  CHECK(slip.printed.contact_speed_at_start == Approx(0.12).margin(0.001));
  CHECK(slip.corrected.contact_speed_at_start < 1e-12);
  CHECK(slip.printed.contact_speed > 1);
  CHECK(slip.corrected.contact_speed < 1e-12);
}

TEST_CASE("the printed sign of the second rolling constraint makes a height that is not harmonic") {
  const sphere::RollingSlip slip = sphere::rolling_along();
  CHECK(slip.printed.change > 1);
  CHECK(slip.corrected.change < 1e-10);
}

TEST_CASE(
    "the printed sign of the second rolling constraint runs into the Euler singularity, and the simulation says so") {
  const sphere::RollingSlip slip = sphere::rolling_along();
  CHECK(slip.printed.end < sphere::RollingSlip::k_duration);
  CHECK(slip.corrected.end == sphere::RollingSlip::k_duration);
}

TEST_CASE("the normal force is -m (R - r) chi'^2, not -m R chi'^2 as printed") {
  const sphere::ReactionSlip slip = sphere::normal_reaction();
  CHECK(slip.emitted == Approx(slip.corrected).epsilon(1e-14));
  CHECK(std::abs(slip.emitted - slip.printed) > 0.1 * std::abs(slip.printed));
}
