// Types beside those of test_scalars: other multiprecision numbers and dual numbers, for a few models; and what each type says
// of states that are not to be trusted.

#include <boost/multiprecision/cpp_bin_float.hpp>
#ifdef GAUSS_TEST_MPFR
#include <boost/multiprecision/mpfr.hpp>
#endif
#ifdef GAUSS_TEST_FLOAT128
#include "gauss/scalar/float128.hpp"
#endif

#include "catch_shim.hpp"
#include "compute.hpp"
#include "four_bar.hpp"
#include "functions.hpp"
#include "gauss/scalar/dual.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "samples.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"

GAUSS_MAKE_TESTED(gauss::four_bar)
GAUSS_MAKE_TESTED(gauss::functions)
GAUSS_MAKE_TESTED(gauss::sphere_in_cylinder)
GAUSS_MAKE_TESTED(gauss::sphere_in_cylinder_quaternion)

namespace {

using gauss::Status;
using headertest::Wide;
namespace mp = boost::multiprecision;

constexpr std::size_t k_states = 10;
/// Of the largest value, in 50 digits handed over in three doubles, which is 48: conditions are up to some thousand.
const Wide k_bar("1e-42");

template <class M, class S>
void agrees_with_50_digits() {
  INFO(M::name);
  const auto wide = headertest::computed<M, Wide>();
  const auto samples = headertest::random_samples(headertest::computed<M, double>(), k_states, false);
  REQUIRE(samples.size() == k_states);
  const auto expected = wide.answers(samples);
  const auto found = headertest::computed<M, S>().answers(samples);
  for (std::size_t s = 0; s < k_states; ++s) {
    // One step of Newton from digits of a double is the whole way for 50 digits, and not for 100.
    CHECK(headertest::all_ok(found[s].statuses));
    CHECK(headertest::all_ok(expected[s].statuses));
    for (std::size_t p = 0; p < headertest::k_parts.size(); ++p) {
      INFO(headertest::k_parts[p]);
      const Wide size = headertest::largest(expected[s].parts[p]);
      CHECK(headertest::largest_difference(found[s].parts[p], expected[s].parts[p]) <= k_bar * size);
    }
  }
}

template <class S>
void models_agree_with_50_digits() {
  agrees_with_50_digits<gauss::four_bar::Tested, S>();
  agrees_with_50_digits<gauss::functions::Tested, S>();
  agrees_with_50_digits<gauss::sphere_in_cylinder::Tested, S>();
  agrees_with_50_digits<gauss::sphere_in_cylinder_quaternion::Tested, S>();
}

Status first(Status status) { return status; }
template <class Mask>
Status first(const gauss::BatchStatus<Mask>& status) {
  return status.lane(0);
}

/// A model at its initial state, or beside it.
template <class M, class S>
struct Case {
  typename M::template Parameters<S> parameters{};
  typename M::template State<S> state{};
  S t = S(0);

  Case() { REQUIRE(first(initial_state(prepare(parameters), state)) == Status::ok); }
  Status status() const {
    typename M::template Derivative<S> derivative;
    return first(rhs(t, state, typename M::template Inputs<S>{}, prepare(parameters), derivative));
  }
};

template <class S>
void says_what_is_wrong(const char* type) {
  INFO(type);
  using Ball = Case<gauss::sphere_in_cylinder::Tested, S>;
  using Turning = Case<gauss::sphere_in_cylinder_quaternion::Tested, S>;
  CHECK(Ball().status() == Status::ok);
  CHECK(Turning().status() == Status::ok);

  Ball massless;
  massless.parameters.m = S(0);
  CHECK(massless.status() == Status::singular_mass_matrix);
  Ball sliding;
  sliding.parameters.r = S(0);
  CHECK(sliding.status() != Status::ok);
  Ball nowhere;
  nowhere.state.values[1] = S(0) / (nowhere.state.values[1] - nowhere.state.values[1]);
  CHECK(nowhere.status() == Status::not_finite);
  Ball never;
  never.t = never.t / (never.t - never.t);
  CHECK(never.status() == Status::not_finite);
  Turning stretched;
  for (int i = 2; i < 6; ++i) stretched.state.values[i] = stretched.state.values[i] * S(2);
  CHECK(stretched.status() == Status::violated_constraints);
}

}  // namespace

TEST_CASE("100 digits agree with 50") { models_agree_with_50_digits<mp::cpp_bin_float_100>(); }

#ifdef GAUSS_TEST_MPFR
TEST_CASE("50 digits of MPFR, whose sums and products are expression templates, agree with 50 of Boost") {
  models_agree_with_50_digits<mp::mpfr_float_50>();
}
#endif

TEST_CASE("every type says the same of a state that is not to be trusted") {
  says_what_is_wrong<float>("float");
  says_what_is_wrong<double>("double");
  says_what_is_wrong<long double>("long double");
  says_what_is_wrong<mp::cpp_bin_float_50>("cpp_bin_float_50");
#ifdef GAUSS_TEST_MPFR
  says_what_is_wrong<mp::mpfr_float_50>("mpfr_float_50");
#endif
#ifdef GAUSS_TEST_FLOAT128
  says_what_is_wrong<__float128>("__float128");
#endif
  says_what_is_wrong<xsimd::batch<float>>("batch<float>");
  says_what_is_wrong<xsimd::batch<double>>("batch<double>");
  says_what_is_wrong<gauss::Dual<double, 3>>("Dual<double, 3>");
  says_what_is_wrong<gauss::Dual<float, 1>>("Dual<float, 1>");
  says_what_is_wrong<gauss::Dual<xsimd::batch<double>, 2>>("Dual<batch<double>, 2>");
}

TEST_CASE("the values of dual numbers are those of their type, to rounding") {
  using M = gauss::sphere_in_cylinder::Tested;
  using S = gauss::Dual<double, 2>;
  for (const headertest::Sample& sample :
       headertest::random_samples(headertest::computed<M, double>(), k_states, false)) {
    const auto expected = headertest::results<M, double>(headertest::point<M, double>(sample));
    const auto found = headertest::results<M, S>(headertest::point<M, S>(sample));
    CHECK(found.statuses == expected.statuses);
    for (int i = 0; i < M::n_q + M::n_v; ++i)
      CHECK(found.derivative.values[i].value == Approx(expected.derivative.values[i]).epsilon(1e-13).margin(1e-13));
    CHECK(found.reactions.rho.generalized.value == Approx(expected.reactions.rho.generalized).epsilon(1e-13));
  }
}
