// (3.8) of the paper for every partition: reactions of held coordinates where nonholonomic constraints lean on them, written out for mass points.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "gauss/integrate/elimination.hpp"
#include "gauss/math.hpp"
#include "held_blades.hpp"
#include "mass_points.hpp"
#include "rolling_disc.hpp"
#include "skew_nonholonomic.hpp"
#include "sphere_in_cylinder.hpp"

namespace {

using gauss::Status;
using mass_points::at;
using mass_points::Wide;

constexpr Wide k_epsilon = std::numeric_limits<double>::epsilon();

template <class T>
T sine(const T& x) {
  return gauss::Math<T>::sin(x);
}
template <class T>
T cosine(const T& x) {
  return gauss::Math<T>::cos(x);
}

/// models/skew_nonholonomic.yaml
struct SkewBlade {
  static constexpr int n = 3, k = 2, l = 1, points = 2;
  gauss::skew_nonholonomic::Parameters<double> parameters;
  Wide mass(int p) const { return p == 0 ? parameters.m1 : parameters.m2; }
  Wide gravity() const { return parameters.g; }
  template <class T>
  void held(const T&, T* x) const {
    x[0] = T(0.4), x[1] = T(-0.2);
  }
  template <class T>
  void places(const T* y, T (*r)[3]) const {
    const T &q1 = y[0], &q2 = y[1], &q3 = y[2], &x1 = y[3], &x2 = y[4];
    r[0][0] = q1 + x1 / T(2), r[0][1] = q2 + x1 * q1 / T(3) + x2, r[0][2] = q3 - x2 * q2 / T(4);
    r[1][0] = q3 + x2 / T(3) + q1 / T(5), r[1][1] = q2 - q1 * x2 / T(2) + x1, r[1][2] = q1 + x1 + q2 / T(2);
  }
  template <class T>
  void rows(const T&, const T* y, const T* u, T* phi) const {
    phi[0] = (T(1) + y[0] * y[0]) * u[2] + y[1] * u[0] - u[1] + y[4] * u[3] + T(0.7) * u[4];
  }
};

/// tests/physics/descriptions/held_blades.yaml
struct Blades {
  static constexpr int n = 4, k = 2, l = 2, points = 3;
  gauss::held_blades::Parameters<double> parameters;
  Wide mass(int p) const { return p == 0 ? parameters.m1 : p == 1 ? parameters.m2 : parameters.m3; }
  Wide gravity() const { return parameters.g; }
  template <class T>
  void held(const T& t, T* x) const {
    x[0] = T(0.4) + T(0.1) * sine(T(3) * t), x[1] = T(-0.2);
  }
  template <class T>
  void places(const T* y, T (*r)[3]) const {
    const T &q1 = y[0], &q2 = y[1], &q3 = y[2], &q4 = y[3], &x1 = y[4], &x2 = y[5];
    r[0][0] = q1 + x1 / T(2), r[0][1] = q2 + x1 * q1 / T(3) + x2, r[0][2] = q3 - x2 * q2 / T(4);
    r[1][0] = q3 + x2 / T(3) + q1 / T(5), r[1][1] = q2 - q1 * x2 / T(2) + x1 + q4, r[1][2] = q1 + x1 + q2 / T(2);
    r[2][0] = q4 + x1 * q2 / T(3), r[2][1] = q3 + q4 * q4 / T(6) + x2 * q1, r[2][2] = x2 - q4 / T(2) + q1 / T(3);
  }
  template <class T>
  void rows(const T& t, const T* y, const T* u, T* phi) const {
    phi[0] = u[0] * sine(y[2]) - u[1] * cosine(y[2]) + y[3] * u[4] + T(0.7) * u[5];
    phi[1] = u[2] * cosine(y[0] + y[1]) + u[3] * sine(y[0] + y[1]) + y[1] / T(2) * u[0] - T(0.4) * u[4] + y[2] * u[5] +
             T(0.2) * sine(T(2) * t);
  }
};

/// R_z(psi) R_x(theta) v
template <class T>
void tilted(const T& psi, const T& theta, const T& x, const T& y, const T& z, T* result) {
  const T across = cosine(theta) * y - sine(theta) * z;
  result[0] = cosine(psi) * x - sine(psi) * across;
  result[1] = sine(psi) * x + cosine(psi) * across;
  result[2] = sine(theta) * y + cosine(theta) * z;
}

/// In space, of z-x-z angles.
template <class T>
void spin(const T& psi, const T& theta, const T& psi_dot, const T& theta_dot, const T& phi_dot, T* omega) {
  omega[0] = theta_dot * cosine(psi) + phi_dot * sine(theta) * sine(psi);
  omega[1] = theta_dot * sine(psi) - phi_dot * sine(theta) * cosine(psi);
  omega[2] = psi_dot + phi_dot * cosine(theta);
}

/// models/rolling_disc.yaml: four points have the inertia of the disc. Free: x, y, psi, theta, phi; held: gap.
struct Disc {
  static constexpr int n = 5, k = 1, l = 2, points = 4;
  gauss::rolling_disc::Parameters<double> parameters;
  Wide mass(int) const { return Wide(parameters.m) / 4; }
  Wide gravity() const { return parameters.g; }
  template <class T>
  void held(const T&, T* x) const {
    x[0] = T(0);
  }
  template <class T>
  void places(const T* y, T (*r)[3]) const {
    const T &psi = y[2], &theta = y[3], &phi = y[4], &gap = y[5];
    const Wide reach = Wide(parameters.R) / std::sqrt(Wide(2));
    for (int p = 0; p < points; ++p) {
      const Wide first[4] = {reach, 0, -reach, 0};
      const T a(first[p]), b(first[(p + 3) % 4]);
      tilted(psi, theta, cosine(phi) * a - sine(phi) * b, sine(phi) * a + cosine(phi) * b, T(0), r[p]);
      r[p][0] = r[p][0] + y[0];
      r[p][1] = r[p][1] + y[1];
      r[p][2] = r[p][2] + gap + T(parameters.R) * sine(theta);
    }
  }
  template <class T>
  void rows(const T&, const T* y, const T* u, T* phi) const {
    T omega[3], arm[3];
    spin(y[2], y[3], u[2], u[3], u[4], omega);
    tilted(y[2], y[3], T(0), T(-parameters.R), T(0), arm);
    phi[0] = u[0] + omega[1] * arm[2] - omega[2] * arm[1];
    phi[1] = u[1] + omega[2] * arm[0] - omega[0] * arm[2];
  }
};

/// models/sphere_in_cylinder.yaml: six points on the axes of the ball. Free: chi, zeta, phi, psi, theta; held: rho. Here b^{μi} vanishes.
struct Ball {
  static constexpr int n = 5, k = 1, l = 2, points = 6;
  gauss::sphere_in_cylinder::Parameters<double> parameters;
  Wide mass(int) const { return Wide(parameters.m) / 6; }
  Wide gravity() const { return parameters.g; }
  template <class T>
  void held(const T&, T* x) const {
    x[0] = T(Wide(parameters.R) - Wide(parameters.r));
  }
  template <class T>
  void places(const T* y, T (*r)[3]) const {
    const T &chi = y[0], &zeta = y[1], &phi = y[2], &psi = y[3], &theta = y[4], &rho = y[5];
    // J = 4 m/6 a^2 = 2/5 m r^2
    const T reach(std::sqrt(Wide(3) / 5) * Wide(parameters.r)), none(0);
    for (int p = 0; p < points; ++p) {
      const T a = p % 2 == 0 ? reach : -reach;
      const T x = p / 2 == 0 ? cosine(phi) * a : p / 2 == 1 ? -(sine(phi) * a) : none;
      const T across = p / 2 == 0 ? sine(phi) * a : p / 2 == 1 ? cosine(phi) * a : none;
      tilted(psi, theta, x, across, p / 2 == 2 ? a : none, r[p]);
      r[p][0] = r[p][0] + rho * cosine(chi);
      r[p][1] = r[p][1] + rho * sine(chi);
      r[p][2] = r[p][2] + zeta;
    }
  }
  template <class T>
  void rows(const T&, const T* y, const T* u, T* phi) const {
    const T R(parameters.R), r(parameters.r);
    phi[0] = (R - r) * u[0] + r * u[3] + r * u[2] * cosine(y[4]);
    phi[1] = u[1] - r * u[4] * sine(y[3] - y[0]) + r * u[2] * sine(y[4]) * cosine(y[3] - y[0]);
  }
};

#define HEADER_OF(type, name_space)                                                                            \
  struct type##Header {                                                                                        \
    using Parameters = gauss::name_space::Parameters<double>;                                                  \
    using State = gauss::name_space::State<double>;                                                            \
    using Derivative = gauss::name_space::Derivative<double>;                                                  \
    using Reactions = gauss::name_space::Reactions<double>;                                                    \
    static constexpr int n = gauss::name_space::n_v;                                                           \
    static_assert(n == type::n && gauss::name_space::n_q == n && gauss::name_space::n_constraints == type::l); \
    static_assert(sizeof(Reactions) == sizeof(double) * (type::l * (1 + n) + type::k),                         \
                  "multipliers, each with its forces; then held coordinates");                                 \
  }
HEADER_OF(SkewBlade, skew_nonholonomic);
HEADER_OF(Blades, held_blades);
HEADER_OF(Disc, rolling_disc);
HEADER_OF(Ball, sphere_in_cylinder);

/// Every choice of l out of n.
std::vector<std::vector<int>> choices(int n, int l) {
  std::vector<std::vector<int>> result;
  for (int bits = 0; bits < 1 << n; ++bits) {
    std::vector<int> one;
    for (int i = 0; i < n; ++i)
      if (bits >> i & 1) one.push_back(i);
    if (static_cast<int>(one.size()) == l) result.push_back(one);
  }
  return result;
}

struct Worst {
  Wide accelerations = 0, reactions = 0;  ///< in units of kappa eps
  Wide basis = 0;
  Wide least_lean = std::numeric_limits<Wide>::infinity();  ///< change of a reaction, by its size, if b^{μi} were 0
  int partitions = 0, singular = 0;
};

/// Held coordinates stand behind constraints.
template <class Mechanism, class Reactions>
const double* held_of(const Reactions& reactions) {
  return reinterpret_cast<const double*>(&reactions) + Mechanism::l * (1 + Mechanism::n);
}

template <class Mechanism>
void compare(const mass_points::Instant<Mechanism>& instant, const std::vector<int>& dependent, const double* a,
             const double* held, Worst& worst) {
  const mass_points::Motion motion = instant.motion(dependent);
  if (!(motion.condition < 1e6L)) {
    ++worst.singular;
    return;
  }
  ++worst.partitions;
  Wide size = 0, miss = 0, force = instant.size_of_forces(), lean = 0;
  for (int i = 0; i < Mechanism::n; ++i) {
    size = std::max(size, std::abs(motion.accelerations[at(i)]));
    miss = std::max(miss, std::abs(motion.accelerations[at(i)] - a[i]));
  }
  worst.accelerations = std::max(worst.accelerations, miss / size / (motion.condition * k_epsilon));
  for (int j = 0; j < Mechanism::k; ++j) {
    force = std::max(force, std::abs(motion.reactions[at(j)]));
    lean = std::max(lean, std::abs(motion.reactions[at(j)] - motion.without_b[at(j)]));
  }
  for (int j = 0; j < Mechanism::k; ++j)
    worst.reactions =
        std::max(worst.reactions, std::abs(motion.reactions[at(j)] - held[j]) / force / (motion.condition * k_epsilon));
  worst.least_lean = std::min(worst.least_lean, lean / force);
}

/// Random states on the constraints, and every partition of each.
template <class Mechanism, class Header, class Check>
Worst over_states(int count, unsigned seed, Check&& check) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-1, 1);
  const Mechanism mechanism;
  const auto prepared = prepare(typename Header::Parameters{});
  Worst worst;
  for (int done = 0; done < count; ++done) {
    const double t = part(random);
    typename Header::State state{};
    REQUIRE(initial_state(prepared, state) == Status::ok);
    for (double& value : state.values) value += part(random) / 2;
    REQUIRE(project(t, state, prepared, state) == Status::ok);
    typename Header::Derivative derivative{};
    typename Header::Reactions forces{};
    REQUIRE(rhs(t, state, {}, prepared, derivative) == Status::ok);
    REQUIRE(reactions(t, state, {}, prepared, forces) == Status::ok);
    const mass_points::Instant<Mechanism> instant(mechanism, t, state.values);
    worst.basis = std::max(worst.basis, instant.error_of_dual_basis());
    for (const auto& dependent : choices(Mechanism::n, Mechanism::l)) {
      compare(instant, dependent, derivative.values + Mechanism::n, held_of<Mechanism>(forces), worst);
      check(instant, t, state, prepared, dependent, worst);
    }
  }
  return worst;
}

template <class Mechanism, class Header>
Worst over_states(int count, unsigned seed) {
  return over_states<Mechanism, Header>(count, seed, [](auto&&...) {});
}

void check_worst(const Worst& worst) {
  INFO(worst.partitions << " partitions, " << worst.singular << " singular; accelerations "
                        << static_cast<double>(worst.accelerations) << ", reactions "
                        << static_cast<double>(worst.reactions) << " of kappa eps; without b^{mu i} off by "
                        << static_cast<double>(worst.least_lean) << " at least");
  CHECK(worst.basis < 1e-13L);
  CHECK(worst.accelerations <= 100);
  CHECK(worst.reactions <= 100);
  CHECK(worst.partitions > 0);
}

}  // namespace

TEST_CASE(
    "(3.8) by every partition gives the reactions that the model emits, where constraints lean on held coordinates") {
  const Worst skew = over_states<SkewBlade, SkewBladeHeader>(200, 1);
  check_worst(skew);
  CHECK(skew.partitions >= 2 * 200);
  CHECK(skew.least_lean > 1e-6L);
  const Worst disc = over_states<Disc, DiscHeader>(100, 2);
  check_worst(disc);
  CHECK(disc.least_lean > 1e-6L);
}

TEST_CASE("where they do not lean, b^{mu i} is zero for every partition: the ball in the cylinder") {
  const Worst ball = over_states<Ball, BallHeader>(50, 3);
  check_worst(ball);
  CHECK(ball.least_lean < 1e-15L);
}

TEST_CASE("a solution for any held partition has the reactions of (3.8) by that partition") {
  using System = gauss::held_blades::LinearSystem<double>;
  Wide largest = 0;
  int carried = 0;
  const auto by_elimination = [&](const auto& instant, double t, const auto& state, const auto& prepared,
                                  const std::vector<int>& dependent, Worst&) {
    System system;
    REQUIRE(linear_system(t, state, {}, prepared, system) == Status::ok);
    gauss::integrate::Partition<Blades::n, Blades::l> partition;
    partition.rank = Blades::l;
    for (bool& is_taken : partition.is_taken) is_taken = true;
    for (const int i : dependent) partition.is_dependent[i] = true;
    gauss::LinearSolution<double, Blades::n, Blades::l> solution;
    const auto rule = gauss::rank_of_velocities<double>(Blades::l);
    if (!gauss::integrate::Elimination<double, Blades::n, Blades::l>(system, rule).solve(partition, solution)) return;
    gauss::held_blades::Reactions<double> forces{};
    REQUIRE(reactions_of_solution(t, state, {}, prepared, solution, forces) == Status::ok);
    const mass_points::Motion motion = instant.motion(dependent);
    if (!(motion.condition < 1e6L)) return;
    ++carried;
    Wide force = instant.size_of_forces();
    for (const Wide reaction : motion.reactions) force = std::max(force, std::abs(reaction));
    for (int j = 0; j < Blades::k; ++j)
      largest = std::max(largest, std::abs(motion.reactions[at(j)] - held_of<Blades>(forces)[j]) / force /
                                      (motion.condition * k_epsilon));
  };
  const Worst blades = over_states<Blades, BladesHeader>(200, 4, by_elimination);
  check_worst(blades);
  CHECK(blades.least_lean > 1e-6L);
  INFO(carried << " partitions, " << static_cast<double>(largest) << " of kappa eps");
  CHECK(carried == blades.partitions);
  CHECK(largest <= 100);
}
