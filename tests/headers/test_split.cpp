// Functions in parts, and in a file of their own, compute the bits of those in one piece. Compiled without contraction.

#include <cmath>
#include <cstring>
#include <random>

#include "catch_shim.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "split_parts/bicycle.hpp"
#include "split_parts/humanoid.hpp"
#include "split_parts/spatial_chain_4.hpp"
#include "split_whole/bicycle.hpp"
#include "split_whole/humanoid.hpp"
#include "split_whole/spatial_chain_4.hpp"

namespace {

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  static_assert(sizeof(A) == sizeof(B));
  return std::memcmp(&a, &b, sizeof(A)) == 0;
}

template <class To, class From>
To as(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(static_cast<void*>(&to), &from, sizeof(To));
  return to;
}

/// States near the initial one, and beyond: the same numbers for both.
template <class State>
State moved(const State& start, int which) {
  std::mt19937 random(static_cast<unsigned>(which));
  std::uniform_real_distribution<double> any(-1, 1);
  State state = start;
  for (auto& value : state.values) value = value + decltype(value + value)(0.05 * which * any(random));
  return state;
}

}  // namespace

// Runs a function of both, with results named by their struct; all have a status.
#define GAUSS_SAME(function, Result, ...)                                 \
  do {                                                                    \
    INFO(#function);                                                      \
    whole::Result<S> expected{};                                          \
    parts::Result<S> found{};                                             \
    const auto status = whole::function(__VA_ARGS__(whole), expected);    \
    CHECK(same_bits(parts::function(__VA_ARGS__(parts), found), status)); \
    CHECK(same_bits(found, expected));                                    \
  } while (false)

#define GAUSS_MOTION(model) t, model##_state, model##_inputs, model##_prepared
#define GAUSS_PLACE(model) t, model##_state, model##_prepared

#define GAUSS_BOTH(S)                                                 \
  const auto whole_prepared = whole::prepare(whole::Parameters<S>{}); \
  const auto parts_prepared = parts::prepare(parts::Parameters<S>{}); \
  CHECK(same_bits(parts_prepared, whole_prepared));                   \
  const whole::Inputs<S> whole_inputs{};                              \
  const parts::Inputs<S> parts_inputs{};                              \
  whole::State<S> start{};                                            \
  (void)whole::initial_state(whole_prepared, start);                  \
  const S t(0.25);

TEST_CASE("all functions of the bicycle have the same bits in parts, also where a result is the argument") {
  namespace whole = gauss::whole::bicycle;
  namespace parts = gauss::parts::bicycle;
  using S = double;
  GAUSS_BOTH(S)
  for (int which = 0; which < 20; ++which) {
    const auto whole_state = moved(start, which);
    const auto parts_state = as<parts::State<S>>(whole_state);
    GAUSS_SAME(rhs, Derivative, GAUSS_MOTION);
    GAUSS_SAME(reactions, Reactions, GAUSS_MOTION);
    GAUSS_SAME(reaction_forces, ReactionForces, GAUSS_MOTION);
    GAUSS_SAME(joint_reactions, JointReactions, GAUSS_MOTION);
    GAUSS_SAME(energy, Energy, GAUSS_PLACE);
    GAUSS_SAME(mass_matrix, MassMatrix, GAUSS_PLACE);
    GAUSS_SAME(project, State, GAUSS_PLACE);
    whole::State<S> expected = whole_state;
    parts::State<S> found = parts_state;
    (void)whole::project(t, expected, whole_prepared, expected);
    (void)parts::project(t, found, parts_prepared, found);
    CHECK(same_bits(found, expected));
  }
}

TEST_CASE("so has the Jacobian of a chain") {
  namespace whole = gauss::whole::spatial_chain_4;
  namespace parts = gauss::parts::spatial_chain_4;
  using S = double;
  GAUSS_BOTH(S)
  for (int which = 0; which < 20; ++which) {
    const auto whole_state = moved(start, which);
    const auto parts_state = as<parts::State<S>>(whole_state);
    GAUSS_SAME(jacobian, Jacobian, GAUSS_MOTION);
  }
}

TEST_CASE("rates of the humanoid have the same bits in parts of the usual size, compiled in their own file") {
  namespace whole = gauss::whole::humanoid;
  namespace parts = gauss::parts::humanoid;
  using S = double;
  GAUSS_BOTH(S)
  for (int which = 0; which < 10; ++which) {
    const auto whole_state = moved(start, which);
    const auto parts_state = as<parts::State<S>>(whole_state);
    GAUSS_SAME(rhs, Derivative, GAUSS_MOTION);
    GAUSS_SAME(mass_matrix, MassMatrix, GAUSS_PLACE);
  }
}

TEST_CASE("what is not finite is reported by functions in parts") {
  namespace parts = gauss::parts::humanoid;
  const auto prepared = parts::prepare(parts::Parameters<double>{});
  parts::State<double> state{};
  REQUIRE(parts::initial_state(prepared, state) == gauss::Status::ok);
  for (double& value : state.values) {
    const double kept = value;
    value = std::nan("");
    parts::Derivative<double> derivative;
    CHECK(parts::rhs(0.0, state, {}, prepared, derivative) == gauss::Status::not_finite);
    value = kept;
  }
}

TEST_CASE("parts take other types than the file of their own was compiled for") {
  namespace whole = gauss::whole::humanoid;
  namespace parts = gauss::parts::humanoid;
  using S = xsimd::batch<double>;
  GAUSS_BOTH(S)
  const auto whole_state = moved(start, 1);
  const auto parts_state = as<parts::State<S>>(whole_state);
  whole::Derivative<S> expected;
  parts::Derivative<S> found;
  const auto status = whole::rhs(t, whole_state, whole_inputs, whole_prepared, expected);
  CHECK_FALSE(parts::rhs(t, parts_state, parts_inputs, parts_prepared, found).any());
  CHECK_FALSE(status.any());
  CHECK(same_bits(found, expected));
}
