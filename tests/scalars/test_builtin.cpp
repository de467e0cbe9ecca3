#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "catch_shim.hpp"
#include "formulas.hpp"

using gausstest::largest_error;

// Errors are in units of eps (|a| + |b| + 1); a formula off by a term is off by 1e6 units and more.
constexpr double k_bound = 64;

TEST_CASE("emitted code in float agrees with formulas written by hand") { CHECK(largest_error<float>() < k_bound); }
TEST_CASE("emitted code in double agrees with formulas written by hand") { CHECK(largest_error<double>() < k_bound); }
TEST_CASE("emitted code in long double agrees with formulas written by hand, to its own digits") {
  CHECK(largest_error<long double>() < k_bound);
}

TEST_CASE("the state is an array of coordinates and speeds, and names are views of it") {
  gauss::springs::State<double> state{};
  state.y_dot() = 7;
  CHECK(state.values[3] == 7);
  static_assert(gauss::springs::n_q == 2 && gauss::springs::n_v == 2 && gauss::springs::n_constraints == 0);
  static_assert(std::is_trivially_copyable_v<gauss::springs::State<double>>);
  static_assert(sizeof(gauss::springs::State<double>) == 4 * sizeof(double));
}

TEST_CASE("values that are not finite are reported") {
  namespace model = gauss::pendulum;
  const auto prepared = model::prepare(model::Parameters<double>{});
  model::Derivative<double> derivative{};
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {infinity, -infinity, std::nan("")}) {
    const model::State<double> state{{0.1, 0.2}};
    model::Inputs<double> inputs;
    inputs.torque = bad;
    CHECK(model::rhs(0.0, state, inputs, prepared, derivative) == gauss::Status::not_finite);
  }
  CHECK(model::rhs(0.0, {{0.1, 0.2}}, {}, prepared, derivative) == gauss::Status::ok);
}

TEST_CASE("finite values of any size are not reported") {
  using M = gauss::Math<double>;
  const double largest = std::numeric_limits<double>::max();
  CHECK_FALSE(M::not_finite(largest, -largest, largest, 0.0, std::numeric_limits<double>::denorm_min()));
  CHECK(M::not_finite(1.0, 2.0, std::nan("")));
}

namespace {

template <class S>
void has_exact_conditions() {
  using M = gauss::Math<S>;
  using gauss::Status;
  CHECK(M::epsilon() == std::numeric_limits<S>::epsilon());
  CHECK(M::less(S(1), S(2)));
  CHECK_FALSE(M::less(S(1), S(1)));
  CHECK_FALSE(M::less(S(2), S(1)));
  CHECK_FALSE(M::less(std::numeric_limits<S>::quiet_NaN(), S(1)));
  CHECK(M::at_most(S(1), S(2)));
  CHECK(M::at_most(S(1), S(1)));
  CHECK_FALSE(M::at_most(S(2), S(1)));
  CHECK_FALSE(M::at_most(std::numeric_limits<S>::quiet_NaN(), S(1)));
  CHECK(M::select(true, S(1), S(2)) == S(1));
  CHECK(M::select(false, S(1), S(2)) == S(2));
  CHECK(M::any(false, false, true));
  CHECK_FALSE(M::any(false, false, false));
  CHECK(M::status(true, true, true, true) == Status::singular_mass_matrix);
  CHECK(M::status(false, true, true, true) == Status::not_finite);
  CHECK(M::status(false, true, false, true) == Status::violated_constraints);
  CHECK(M::status(false, true, false, false) == Status::dependent_constraints);
  CHECK(M::worse(Status::dependent_constraints, Status::not_finite) == Status::not_finite);
  CHECK(M::worse(Status::violated_constraints, Status::dependent_constraints) == Status::violated_constraints);
  CHECK(M::worse(Status::ok, Status::dependent_constraints) == Status::dependent_constraints);
  CHECK(M::status(false, false, false) == Status::ok);
}

}  // namespace

TEST_CASE(
    "less is strict and at_most is not, any needs one, the status that leaves least is stated, epsilon is that of the "
    "type") {
  has_exact_conditions<float>();
  has_exact_conditions<double>();
  has_exact_conditions<long double>();
}

// The C library's own pair hides it here; elsewhere it is what emitted code calls.
TEST_CASE("sine and cosine together are those alone, without the C library's pair, too") {
  double sine = 0;
  double cosine = 0;
  gauss::StandardMath<double>::sincos(0.3, sine, cosine);
  CHECK(sine == std::sin(0.3));
  CHECK(cosine == std::cos(0.3));
}

TEST_CASE("a status is called what it is") {
  const auto text = [](gauss::Status status) { return std::string(gauss::name(status)); };
  CHECK(text(gauss::Status::ok) == "ok");
  CHECK(text(gauss::Status::singular_mass_matrix) == "singular mass matrix");
  CHECK(text(gauss::Status::dependent_constraints) == "dependent constraints");
  CHECK(text(gauss::Status::not_finite) == "not finite");
  CHECK(text(gauss::Status::violated_constraints) == "violated constraints");
}

TEST_CASE("a vanishing mass is reported as a singular mass matrix") {
  namespace model = gauss::springs;
  model::Parameters<double> parameters;
  parameters.m2 = 0;
  model::Derivative<double> derivative{};
  CHECK(model::rhs(0.0, {{1, 2, 3, 4}}, {}, model::prepare(parameters), derivative) ==
        gauss::Status::singular_mass_matrix);
  CHECK(std::strcmp(name(gauss::Status::singular_mass_matrix), "singular mass matrix") == 0);
}

TEST_CASE("formulas follow the parameters that they depend on") {
  namespace model = gauss::springs;
  model::Parameters<double> parameters;
  parameters.a = 2;
  CHECK(model::prepare(parameters).k3 == Approx(10));
}

TEST_CASE("tables describe the model to drivers that do not know it") {
  namespace model = gauss::linux_;
  CHECK(std::strcmp(model::name_of_model, "linux") == 0);
  CHECK(std::strcmp(model::parameter_table[0].name, "I") == 0);
  CHECK(std::strcmp(model::parameter_table[0].about, "first\n#error second\\\nint x = \"\xE2\x80\xAE; ?\?/") == 0);
  CHECK(model::parameter_table[model::n_parameters].name == nullptr);
  model::Parameters<double> parameters;
  parameters.*model::parameter_members<double>[0] = 42;
  CHECK(parameters.I_ == 42);
  CHECK(model::parameter_members<double>[model::n_parameters] == nullptr);
  CHECK(model::input_members<double>[1] == &model::Inputs<double>::prepared_);
}
