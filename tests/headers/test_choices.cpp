// What is not a number stays so through every choice, and is of no account where it is not chosen.

#include <limits>

#include "catch_shim.hpp"
#include "choices.hpp"
#include "gauss/scalar/xsimd.hpp"

namespace {

namespace choices = gauss::choices;
using gauss::Status;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// With the function of log(x) that `which` names as the force.
template <class S>
gauss::StatusOf<S> status(const S& x, const S& which, choices::Derivative<S>& derivative) {
  choices::Inputs<S> inputs;
  inputs.which = which;
  const auto prepared = prepare(choices::Parameters<S>{});
  choices::State<S> state;
  for (S& value : state.values) value = S(0);
  state.x() = x;
  return rhs(S(0), state, inputs, prepared, derivative);
}

}  // namespace

TEST_CASE("no choice hides what is not a number") {
  for (int which = 0; which < 14; ++which) {
    INFO("function " << which);
    choices::Derivative<double> derivative{};
    CHECK(status(0.5, double(which), derivative) == Status::ok);
    CHECK(status(-1.0, double(which), derivative) == Status::not_finite);
  }
}

TEST_CASE("a case that is not chosen may be NaN or overflow") {
  choices::Derivative<double> derivative{};
  CHECK(status(-1.0, -1.0, derivative) == Status::ok);  // log(x) is not chosen
  CHECK(derivative.a_ddot() == 7);
  CHECK(status(-1.0, -2.0, derivative) == Status::ok);  // exp(1000 - 1000 which) overflows
  CHECK(derivative.a_ddot() == 8);
}

TEST_CASE("lanes of a batch choose for themselves") {
  using Batch = xsimd::batch<double>;
  double x[Batch::size], which[Batch::size];
  for (std::size_t i = 0; i < Batch::size; ++i) {
    x[i] = i % 2 == 0 ? 0.5 : -1.0;
    which[i] = 5;
  }
  choices::Derivative<Batch> derivative{};
  const auto found = status(Batch::load_unaligned(x), Batch::load_unaligned(which), derivative);
  for (std::size_t i = 0; i < Batch::size; ++i) {
    CHECK(found.lane(i) == (i % 2 == 0 ? Status::ok : Status::not_finite));
  }
}

TEST_CASE("a table of what is not a number is none, and so are its derivatives") {
  for (const double value :
       {choices::line(k_nan), choices::line_d1(k_nan), choices::curve(k_nan), choices::curve_d1(k_nan)}) {
    CHECK(value != value);
  }
}
