// A quaternion that is not of unit length scales what it should rotate: no function takes such a state without saying so.

#include "catch_shim.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "skater_quaternion.hpp"

namespace skater = gauss::skater_quaternion;
using gauss::Status;

namespace {

/// The model's initial state with its quaternion scaled.
template <class S>
skater::State<S> stretched(const S& factor) {
  skater::State<S> state{};
  initial_state(prepare(skater::Parameters<S>{}), state);
  for (S* component : {&state.e0(), &state.e1(), &state.e2(), &state.e3()}) *component *= factor;
  return state;
}

template <class S>
void every_function_says(const S& factor, Status expected) {
  INFO("quaternion times " << factor);
  const skater::State<S> state = stretched(factor);
  const auto prepared = prepare(skater::Parameters<S>{});
  skater::Derivative<S> derivative{};
  skater::Reactions<S> reactions_found{};
  skater::ReactionForces<S> forces{};
  skater::Energy<S> energies{};
  skater::Compulsion<S> Z{};
  skater::MassMatrix<S> metric{};
  CHECK(rhs(S(0), state, {}, prepared, derivative) == expected);
  CHECK(reactions(S(0), state, {}, prepared, reactions_found) == expected);
  CHECK(rhs_and_reactions(S(0), state, {}, prepared, derivative, reactions_found) == expected);
  CHECK(reaction_forces(S(0), state, {}, prepared, forces) == expected);
  CHECK(energy(S(0), state, prepared, energies) == expected);
  CHECK(compulsion(S(0), state, {}, prepared, derivative, Z) == expected);
  CHECK(mass_matrix(S(0), state, prepared, metric) == expected);
}

template <class S>
Status of_projection(const S& factor) {
  skater::State<S> projected{};
  const Status status = project(S(0), stretched(factor), prepare(skater::Parameters<S>{}), projected);
  if (status == Status::ok) {
    const S norm = projected.e0() * projected.e0() + projected.e1() * projected.e1() + projected.e2() * projected.e2() +
                   projected.e3() * projected.e3();
    CHECK(std::abs(norm - 1) < 4 * std::numeric_limits<S>::epsilon());
  }
  return status;
}

}  // namespace

TEST_CASE("a quaternion that is not of unit length is reported, what integration leaves of it is not") {
  for (const double factor : {0.0, 0.5, 0.98, 1.02, 1.5, 10.0, -2.0}) {
    every_function_says(factor, Status::violated_constraints);
  }
  for (const double factor : {1.0, -1.0, 0.9999, 1.0001}) every_function_says(factor, Status::ok);
  every_function_says(0.98F, Status::violated_constraints);
  every_function_says(1.0001F, Status::ok);
}

TEST_CASE("a state that nobody has filled in is not taken for an attitude") {
  skater::Derivative<double> derivative{};
  CHECK(rhs(0.0, skater::State<double>{}, {}, prepare(skater::Parameters<double>{}), derivative) ==
        Status::violated_constraints);
}

TEST_CASE("residuals measure such a quaternion and project mends it, as far as its length has digits") {
  skater::Residuals<double> residuals_found{};
  CHECK(residuals(0.0, stretched(2.0), {}, prepare(skater::Parameters<double>{}), skater::Derivative<double>{},
                  residuals_found) == Status::ok);
  CHECK(residuals_found.quaternion[0] == Approx(3));
  for (const double factor : {1e-5, 0.5, 2.0, 1e5}) CHECK(of_projection(factor) == Status::ok);
  for (const float factor : {1e-5F, 0.5F, 2.0F, 1e5F}) CHECK(of_projection(factor) == Status::ok);
  for (const double factor : {0.0, 1e-200, 1e-160, 1e160, 1e200, 1e300}) CHECK(of_projection(factor) != Status::ok);
  for (const float factor : {1e-22F, 1e-20F, 1e20F, 1e30F}) CHECK(of_projection(factor) != Status::ok);
}

TEST_CASE("in a batch each lane speaks for itself") {
  using Batch = xsimd::batch<double>;
  alignas(64) double factors[Batch::size];
  for (std::size_t i = 0; i < Batch::size; ++i) factors[i] = i == 1 ? 1.1 : 1.0;
  skater::Derivative<Batch> derivative{};
  const auto status =
      rhs(Batch(0.0), stretched(Batch::load_aligned(factors)), {}, prepare(skater::Parameters<Batch>{}), derivative);
  for (std::size_t i = 0; i < Batch::size; ++i) {
    CHECK(status.lane(i) == (i == 1 ? Status::violated_constraints : Status::ok));
  }
}
