// One NaN or infinity in what a function is given is enough, whether or not anything is computed from it.

#include <limits>

#include "catch_shim.hpp"
#include "compute.hpp"
#include "plain_models.hpp"

namespace {

using headertest::Point;
using headertest::results;

template <class S>
const S k_bad[] = {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity(),
                   -std::numeric_limits<S>::infinity()};

template <class M>
Point<M, double> start() {
  Point<M, double> at;
  at.t = 0.3;
  (void)initial_state(prepare(at.parameters), at.state);
  // Away from zeros, which hide what they are multiplied with, but with quaternions of unit length.
  for (double& value : at.state.values) value += 0.1;
  (void)project(at.t, typename M::template State<double>(at.state), prepare(at.parameters), at.state);
  return at;
}

template <class M>
void check(const std::string& what, const Point<M, double>& at, bool is_input) {
  const auto found = results<M, double>(at);
  INFO(M::name << ": " << what);
  CHECK(found.statuses[0] != gauss::Status::ok);
  if (is_input) return;
  // Neither takes inputs.
  CHECK(found.statuses[1] != gauss::Status::ok);
  CHECK(found.statuses[2] != gauss::Status::ok);
}

template <class M>
void refuses_what_is_not_finite() {
  const Point<M, double> good = start<M>();
  INFO(M::name);
  CHECK(headertest::all_ok(results<M, double>(good).statuses));
  for (const double bad : k_bad<double>) {
    Point<M, double> at = good;
    at.t = bad;
    check("time", at, false);
    for (int i = 0; i < M::n_q + M::n_v; ++i) {
      at = good;
      at.state.values[i] = bad;
      check("state " + std::to_string(i), at, false);
    }
    const auto inputs = M::template inputs<double>();
    for (int i = 0; inputs[i] != nullptr; ++i) {
      at = good;
      at.inputs.*inputs[i] = bad;
      check("input " + std::to_string(i), at, true);
    }
  }
}

}  // namespace

TEST_CASE("one component of time, state or inputs that is not finite gives a status other than ok in the same call") {
#define GAUSS_TESTED_MODEL(name_space) refuses_what_is_not_finite<name_space::Tested>();
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
}

namespace {

template <class S>
bool all_finite(const std::vector<S>& values) {
  for (const S value : values) {  // false for infinities and NaN alike
    if (!(value - value == 0)) return false;
  }
  return true;
}

// Speeds so large that squares of them overflow, though each is finite.
template <class M>
void says_when_a_result_overflows() {
  Point<M, double> at = start<M>();
  for (int i = M::n_q; i < M::n_q + M::n_v; ++i) at.state.values[i] = 1e200 * (i - M::n_q + 1);
  const auto found = results<M, double>(at);
  INFO(M::name);
  const auto finite = [](const auto& result) { return all_finite(headertest::scalars<double>(result)); };
  CHECK((found.statuses[0] != gauss::Status::ok || (finite(found.derivative) && finite(found.reactions))));
  typename M::template Derivative<double> derivative{};
  const gauss::Status status = rhs(at.t, at.state, at.inputs, prepare(at.parameters), derivative);
  CHECK((status != gauss::Status::ok || finite(derivative)));
  CHECK(found.statuses[1] == gauss::Status::not_finite);
  CHECK_FALSE(finite(found.energies));
  // Equations of positions may be violated by a state that is finite.
  CHECK((found.statuses[2] != gauss::Status::ok || finite(found.projected)));
}

}  // namespace

TEST_CASE("finite arguments whose results overflow give a status other than ok, too") {
#define GAUSS_TESTED_MODEL(name_space) says_when_a_result_overflows<name_space::Tested>();
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
}
