// The benchmark bicycle, against Newton's and Euler's equations of its bodies and against what is published about it.
#include <complex>

#include "bicycle.hpp"
#include "states.hpp"

using reference::number;

namespace bike = gauss::bicycle;

GAUSS_MODEL(Bicycle, bike);

namespace {

void check_forces(const reference::Json& sample, const bike::State<double>& state, const bike::Inputs<double>& inputs,
                  const bike::Prepared<double>& prepared, double tolerance) {
  const double t = number(sample["t"]);
  const reference::Json& expected = sample["forces"];
  const double margin = tolerance * physics::size_of_forces(expected);
  bike::JointReactions<double> joints;
  REQUIRE(joint_reactions(t, state, inputs, prepared, joints) == gauss::Status::ok);
  physics::check_joint(expected, "rear_axle", joints.rear_axle, margin);
  physics::check_joint(expected, "head_set", joints.head_set, margin);
  physics::check_joint(expected, "front_axle", joints.front_axle, margin);
  bike::ReactionForces<double> forces;
  REQUIRE(reaction_forces(t, state, inputs, prepared, forces) == gauss::Status::ok);
  const std::array<double, 3> rear{forces.rear_along_x.force_on_rear_wheel[0],
                                   forces.rear_along_y.force_on_rear_wheel[1],
                                   forces.rear_height.force_on_rear_contact[2]};
  const std::array<double, 3> front{forces.front_along_x.force_on_front_wheel[0],
                                    forces.front_along_y.force_on_front_wheel[1],
                                    forces.front_height.force_on_front_contact[2]};
  physics::check_vector(expected["rear_contact"], rear, margin);
  physics::check_vector(expected["front_contact"], front, margin);
}

using Real = long double;

/// Accelerations of lean and steer near the upright run at speed v, where yaw and pitch turn as small angles make them.
std::array<Real, 2> near_upright(const bike::Prepared<Real>& p, Real v, const std::array<Real, 4>& small) {
  const auto [lean, steer, lean_dot, steer_dot] = small;
  bike::State<Real> state{};
  state.lean() = lean;
  state.steer() = steer;
  state.lean_dot() = lean_dot;
  state.steer_dot() = steer_dot;
  const bike::Parameters<Real> defaults;
  state.yaw_dot() = (v * steer + defaults.c * steer_dot) * std::cos(defaults.lam) / defaults.w;
  state.x_dot() = v;
  state.rear_turn_dot() = -v / defaults.rR;
  state.front_turn_dot() = -v / defaults.rF;
  bike::Derivative<Real> derivative;
  REQUIRE(rhs(Real(0), state, bike::Inputs<Real>{}, p, derivative) == gauss::Status::ok);
  return {derivative.lean_ddot(), derivative.steer_ddot()};
}

/// d(lean_ddot, steer_ddot) / d small[k], by central differences extrapolated once.
std::array<Real, 2> slope(const bike::Prepared<Real>& p, Real v, std::size_t k) {
  const auto central = [&](Real h) {
    std::array<Real, 4> small{};
    small[k] = h;
    const auto ahead = near_upright(p, v, small);
    small[k] = -h;
    const auto back = near_upright(p, v, small);
    return std::array<Real, 2>{(ahead[0] - back[0]) / (2 * h), (ahead[1] - back[1]) / (2 * h)};
  };
  const auto fine = central(1e-4L), coarse = central(2e-4L);
  return {(4 * fine[0] - coarse[0]) / 3, (4 * fine[1] - coarse[1]) / 3};
}

}  // namespace

TEST_CASE(
    "a bicycle leans, steers and rolls as Newton and Euler say, with the forces in axles, head set and contacts") {
  const auto file = reference::read("bicycle");
  const auto prepared = prepare(bike::Parameters<double>{});
  for (const auto& sample : file["expected"]["states"]) {
    bike::Inputs<double> inputs;
    inputs.steer_torque = number(sample["inputs"]["steer_torque"]);
    physics::check_accelerations<Bicycle>(sample, inputs, prepared, 1e-12);
    check_forces(sample, physics::state_of<Bicycle>(sample["state"]), inputs, prepared, 1e-12);
  }
}

TEST_CASE("a bicycle that starts leaning runs as Newton and Euler say") {
  const auto file = reference::read("bicycle");
  const auto prepared = prepare(bike::Parameters<double>{});
  const bike::Inputs<double> inputs;
  bike::State<double> start;
  REQUIRE(initial_state(prepared, start) == gauss::Status::ok);
  physics::follow<Bicycle>(file["expected"]["motion"], prepared, inputs, start,
                           [&](const auto& sample, double, const auto& state) {
                             physics::check_state<Bicycle>(sample["state"], state, 1e-10);
                             check_forces(sample, state, inputs, prepared, 1e-10);
                           });
}

TEST_CASE("a leaning bicycle accelerates as published in 2007") {
  const auto file = reference::read("bicycle");
  const auto prepared = prepare(bike::Parameters<double>{});
  // Table 1 has 12 to 14 digits.
  physics::check_accelerations<Bicycle>(file["expected"]["published"], bike::Inputs<double>{}, prepared, 1e-13);
}

TEST_CASE("small leans and steers of a bicycle have the matrices and the eigenvalues of the benchmark") {
  const auto file = reference::read("bicycle_whipple_linear");
  const auto matrix = [&](const char* name, std::size_t row, std::size_t column) {
    return static_cast<Real>(number(file["expected"]["high_precision"][name][row][column]));
  };
  const Real g = number(file["params"]["g"]);
  const auto prepared = prepare(bike::Parameters<Real>{});
  REQUIRE(file["expected"]["eigenvalues"].size() > 5);
  for (const auto& entry : file["expected"]["eigenvalues"]) {
    const Real v = number(entry["v"]);
    INFO("v = " << static_cast<double>(v));
    std::array<std::array<Real, 2>, 4> slopes{};
    for (std::size_t k = 0; k < 4; ++k) slopes[k] = slope(prepared, v, k);
    // M qdd = -(g K0 + v^2 K2) q - v C1 qd
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t i = 0; i < 2; ++i) {
        const Real found = matrix("M", i, 0) * slopes[k][0] + matrix("M", i, 1) * slopes[k][1];
        const Real expected =
            k < 2 ? -g * matrix("K0", i, k) - v * v * matrix("K2", i, k) : -v * matrix("C1", i, k - 2);
        CHECK(static_cast<double>(found - expected) ==
              Approx(0).margin(1e-10 * static_cast<double>(1000 + 100 * v * v)));
      }
    }
    for (const auto& pair : entry["eigenvalues_re_im"]) {
      using Complex = std::complex<Real>;
      const Complex s(number(pair[0]), number(pair[1]));
      const auto element = [&](std::size_t i, std::size_t k) {
        return (i == k ? s * s : Complex(0)) - slopes[k + 2][i] * s - slopes[k][i];
      };
      const Complex determinant = element(0, 0) * element(1, 1) - element(0, 1) * element(1, 0);
      CHECK(static_cast<double>(std::abs(determinant) / std::pow(1 + std::abs(s), 4)) == Approx(0).margin(1e-9));
    }
  }
}
