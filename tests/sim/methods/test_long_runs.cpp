// What very many symplectic steps do to the energy.
#include <cmath>

#include "catch_shim.hpp"
#include "gauss/integrate/symmetric_composition.hpp"
#include "problems.hpp"

namespace {

using Model = gausssim::MotionModel<double>;
using problems::Kepler;
using namespace gauss::integrate;

struct Misses {
  double early = 0, late = 0;  ///< largest error of the energy in the first and in the last tenth
};

template <class Stepper>
Misses energy_misses(long steps, double h) {
  const Model model(Kepler<double>::functions());
  Model::State state{Kepler<double>::at(0)};
  Model::Energy start, now;
  REQUIRE(model.energy(0, state, start) == gauss::Status::ok);
  Stepper stepper;
  Misses misses;
  for (long k = 0; k < steps; ++k) {
    if (!stepper.step(model, static_cast<double>(k) * h, h, state).is_taken()) FAIL("step " << k);
    if (k % 16 != 0) continue;
    model.energy(0, state, now);
    const double miss = std::abs(now.total - start.total);
    if (k < steps / 10) misses.early = std::max(misses.early, miss);
    if (k >= steps - steps / 10) misses.late = std::max(misses.late, miss);
  }
  return misses;
}

}  // namespace

TEST_CASE("over 400 000 steps the energy stays within rounding with compensated sums, and wanders off without") {
  constexpr long k_steps = 400'000;
  constexpr double k_step = 0.03;  // the error of the method is below rounding
  const Misses compensated = energy_misses<SymmetricComposition<Model>>(k_steps, k_step);
  const Misses plain = energy_misses<SymmetricComposition<Model, KahanLi8<double>, false>>(k_steps, k_step);
  INFO("compensated " << compensated.early << ", " << compensated.late << "; plain " << plain.early << ", "
                      << plain.late);
  CHECK(compensated.late < 3 * compensated.early);
  CHECK(compensated.late < 2e-14);
  CHECK(plain.late > 3 * compensated.late);
}

TEST_CASE("over 100 000 steps the error of the energy does not grow with the symplectic methods of low order") {
  const Misses verlet = energy_misses<Verlet<Model>>(100'000, 0.01);
  const Misses mclachlan = energy_misses<McLachlan4<Model>>(100'000, 0.05);
  INFO(verlet.early << ", " << verlet.late << "; " << mclachlan.early << ", " << mclachlan.late);
  CHECK(verlet.late < 1.2 * verlet.early);
  CHECK(mclachlan.late < 1.2 * mclachlan.early);
}
