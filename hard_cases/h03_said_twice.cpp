// Constraints that say the same, beside closed forms: a bob on a sphere by a length and again by squares, and a door on two hinges.

#include <algorithm>
#include <cmath>
#include <string>

#include "process.hpp"
#include "registry.hpp"
#include "said_twice.hpp"
#include "two_hinge_door.hpp"
#include "without_rank.hpp"

namespace hard_cases {

namespace {

namespace bob = gauss::said_twice;
namespace door = gauss::two_hinge_door;

constexpr int k_states = 200;

struct Vector {
  double x = 0, y = 0, z = 0;
};
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// About z.
Vector turned(const Vector& a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y, a.z};
}

void grow(double& largest, const Vector& found, const Vector& exact, double size) {
  for (const double difference : {found.x - exact.x, found.y - exact.y, found.z - exact.z})
    hard_cases::grow(largest, difference / size);
}

struct Errors {
  double acceleration = 0, force = 0;
};

struct Found {
  Errors ours, naive;
  double unmarked =
      0;  ///< calls whose status is another one, or that do not name the rows that share their load and no other
  double seconds_ours = 0, seconds_naive = 0;
};

/// Which rows have no multiplier of their own, as names of the model with a space behind each.
template <class Mobility, class Table>
std::string shared(const Mobility& found, const Table& table) {
  std::string names;
  int mu = 0;
  for (const double is_shared : found.is_shared) {
    if (is_shared == 1) names += std::string(table[mu].name) + " ";
    ++mu;
  }
  return names;
}

struct BobMotion {
  Vector acceleration, force, across;  ///< of all constraints; of the plane alone
};

/// m l theta'' = -m g sin theta + W cos u cos theta in the plane; nothing but the plane bears the wind across.
BobMotion bob_in_plane(const bob::Parameters<double>& p, double theta, double rate) {
  const Vector along{std::cos(p.u), std::sin(p.u), 0}, up{0, 0, 1}, normal{std::sin(p.u), -std::cos(p.u), 0};
  const double s = std::sin(theta), c = std::cos(theta);
  const double theta_ddot = (-p.g * s + p.W / p.m * std::cos(p.u) * c) / p.l;
  BobMotion result;
  result.acceleration =
      (p.l * (theta_ddot * c - rate * rate * s)) * along + (p.l * (theta_ddot * s + rate * rate * c)) * up;
  result.force = p.m * result.acceleration + Vector{-p.W, 0, p.m * p.g};
  result.across = (-p.W * std::sin(p.u)) * normal;
  return result;
}

/// b^T lambda by gradients of its own, from multipliers in the order rod, plane, sphere.
Vector force_on_bob(const bob::Parameters<double>& p, const Vector& place, const double (&multipliers)[3]) {
  return (multipliers[0] / p.l + 2 * p.k * multipliers[2]) * place +
         multipliers[1] * Vector{std::sin(p.u), -std::cos(p.u), 0};
}

Found bob_said_twice() {
  const bob::Parameters<double> p;
  const auto prepared = prepare(p);
  Found result;
  for (int i = 0; i < k_states; ++i) {
    const double theta = 3 * std::sin(0.7 * i), rate = 4 * std::cos(1.3 * i);
    const BobMotion exact = bob_in_plane(p, theta, rate);
    const Vector place = turned({p.l * std::sin(theta), 0, -p.l * std::cos(theta)}, p.u);
    const Vector speed = rate * turned({p.l * std::cos(theta), 0, p.l * std::sin(theta)}, p.u);
    const bob::State<double> state{{place.x, place.y, place.z, speed.x, speed.y, speed.z}};
    const double size = p.g + p.l * rate * rate;

    Stopwatch of_ours;
    bob::Derivative<double> rates{};
    bob::Reactions<double> reactions{};
    const bool is_known = rhs(0.0, state, {}, prepared, rates) == gauss::Status::ok;
    const gauss::Status of_reactions = bob::reactions(0.0, state, {}, prepared, reactions);
    result.seconds_ours += of_ours.seconds();
    const double* a = rates.values + 3;
    grow(result.ours.acceleration, {a[0], a[1], a[2]}, exact.acceleration, size);
    const double multipliers[] = {reactions.rod.multiplier, reactions.plane.multiplier, reactions.sphere.multiplier};
    grow(result.ours.force, force_on_bob(p, place, multipliers), exact.force, p.m * size);
    grow(result.ours.force, force_on_bob(p, {}, multipliers), exact.across, p.m * size);
    bob::Mobility<double> found{};
    const bool is_counted = mobility(0.0, state, {}, prepared, found) == gauss::Status::ok && found.mobility == 1;
    if (!is_known || !is_counted || of_reactions != gauss::Status::dependent_constraints ||
        shared(found, bob::constraint_table) != "rod sphere ")
      ++result.unmarked;

    Stopwatch of_naive;
    bob::LinearSystem<double> system{};
    (void)linear_system(0.0, state, {}, prepared, system);
    double x[6];
    eliminate_all<3, 3>(system, x);
    result.seconds_naive += of_naive.seconds();
    grow(result.naive.acceleration, {x[0], x[1], x[2]}, exact.acceleration, size);
    grow(result.naive.force, force_on_bob(p, place, {x[3], x[4], x[5]}), exact.force, p.m * size);
  }
  return result;
}

struct DoorMotion {
  double angle_ddot;
  Vector acceleration, force, moment;  ///< of the mass centre; of all constraints, about it
};

/// (Jz + m w^2) theta'' = m w (across · gravity), and what the hinges bear by momentum and angular momentum.
DoorMotion door_on_its_line(const door::Parameters<double>& p, double angle, double rate) {
  const Vector out = turned({1, 0, 0}, angle), across = turned({0, 1, 0}, angle);
  DoorMotion result{};
  result.angle_ddot = -p.m * p.w * p.g * std::sin(p.s) * std::cos(angle) / (p.Jz + p.m * p.w * p.w);
  result.acceleration = (p.w * result.angle_ddot) * across + (-p.w * rate * rate) * out;
  result.force = p.m * result.acceleration + (p.m * p.g) * Vector{0, std::sin(p.s), std::cos(p.s)};
  // J omega is (Jxz, Jyz, Jz) rate in the door, which turns.
  result.moment = turned({p.Jxz * result.angle_ddot - p.Jyz * rate * rate,
                          p.Jyz * result.angle_ddot + p.Jxz * rate * rate, p.Jz * result.angle_ddot},
                         angle);
  return result;
}

/// From multipliers of upper, upper_line, lower, lower_line: forces on the door along the axes of space, and their moments about its mass centre.
void grow_door(double& largest, const door::Parameters<double>& p, double angle, const DoorMotion& exact,
               const double (&multipliers)[12], double size) {
  const double heights[] = {p.h, p.h + p.d, -p.h, -p.h - p.d};
  Vector force, moment;
  for (int k = 0; k < 4; ++k) {
    const Vector each{multipliers[3 * k], multipliers[3 * k + 1], multipliers[3 * k + 2]};
    force = force + each;
    moment = moment + cross(turned({-p.w, 0, heights[k]}, angle), each);
  }
  grow(largest, force, exact.force, size);
  grow(largest, moment, exact.moment, size);
}

Found door_on_two_hinges() {
  const door::Parameters<double> p;
  const auto prepared = prepare(p);
  Found result;
  for (int i = 0; i < k_states; ++i) {
    const double angle = 3 * std::sin(0.7 * i), rate = 2 * std::cos(1.3 * i);
    const DoorMotion exact = door_on_its_line(p, angle, rate);
    const Vector place = turned({p.w, 0, 0}, angle), speed = rate * turned({0, p.w, 0}, angle);
    const door::State<double> state{{place.x, place.y, place.z, std::cos(angle / 2), 0, 0, std::sin(angle / 2), speed.x,
                                     speed.y, speed.z, 0, 0, rate}};
    const double size = p.g + rate * rate;

    Stopwatch of_ours;
    door::Derivative<double> rates{};
    door::Reactions<double> reactions{};
    const bool is_known = rhs(0.0, state, {}, prepared, rates) == gauss::Status::ok;
    const gauss::Status of_reactions = door::reactions(0.0, state, {}, prepared, reactions);
    result.seconds_ours += of_ours.seconds();
    const double* a = rates.values + 7;
    grow(result.ours.acceleration, {a[0], a[1], a[2]}, exact.acceleration, size);
    grow(result.ours.acceleration, {a[3], a[4], a[5]}, {0, 0, exact.angle_ddot}, size);
    grow_door(result.ours.force, p, angle, exact,
              {reactions.upper_x.multiplier, reactions.upper_y.multiplier, reactions.upper_z.multiplier,
               reactions.upper_line_x.multiplier, reactions.upper_line_y.multiplier, reactions.upper_line_z.multiplier,
               reactions.lower_x.multiplier, reactions.lower_y.multiplier, reactions.lower_z.multiplier,
               reactions.lower_line_x.multiplier, reactions.lower_line_y.multiplier, reactions.lower_line_z.multiplier},
              p.m * size);
    door::Mobility<double> found{};
    const bool is_counted = mobility(0.0, state, {}, prepared, found) == gauss::Status::ok && found.mobility == 1;
    const std::string names = shared(found, door::constraint_table);
    if (!is_known || !is_counted || of_reactions != gauss::Status::dependent_constraints ||
        names.find("upper_") == std::string::npos || names.find("lower_") == std::string::npos)
      ++result.unmarked;

    Stopwatch of_naive;
    door::LinearSystem<double> system{};
    (void)linear_system(0.0, state, {}, prepared, system);
    double x[18];
    eliminate_all<6, 12>(system, x);
    result.seconds_naive += of_naive.seconds();
    grow(result.naive.acceleration, {x[0], x[1], x[2]}, exact.acceleration, size);
    grow(result.naive.acceleration, {x[3], x[4], x[5]}, {0, 0, exact.angle_ddot}, size);
    grow_door(result.naive.force, p, angle, exact,
              {x[6], x[7], x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15], x[16], x[17]}, p.m * size);
  }
  return result;
}

/// Of a model of this folder: 0 if the generator says W054 and all these words in it, which are names and the mobility.
double unnamed(const std::string& model, std::initializer_list<const char*> words) {
  const Outcome outcome =
      run_program("'" GAUSS_GEN "' --check '" GAUSS_SOURCE_DIR "/hard_cases/models/" + model + ".yaml'");
  bool is_named = outcome.exit_code == 0 && outcome.said.find("W054") != std::string::npos;
  for (const char* word : words) is_named = is_named && outcome.said.find(word) != std::string::npos;
  return is_named ? 0 : 1;
}

void add(const char* id, const std::string& what, const Found& found, std::vector<Figure>& figures) {
  const std::string states = ", " + std::to_string(k_states) + " states";
  figures.push_back({id, "accelerations of " + what + ", beside a closed form" + states, "1", found.naive.acceleration,
                     found.ours.acceleration, 1e-13, found.seconds_naive, found.seconds_ours});
  figures.push_back({std::string(id) + ".force", "force and moment of all its constraints", "1", found.naive.force,
                     found.ours.force, 1e-13, found.seconds_naive, found.seconds_ours});
}

}  // namespace

std::vector<Figure> said_twice() {
  std::vector<Figure> figures;
  const Found of_bob = bob_said_twice(), of_door = door_on_two_hinges();
  add("H03.twice", "a bob whose sphere is said by a length, and by squares a thousand times as large", of_bob, figures);
  add("H03.door", "a door on two hinges of one line", of_door, figures);
  figures.push_back({"H03.named", "of 400 calls, those that do not name the pair and only it, or have another status",
                     "1", std::nullopt, of_bob.unmarked + of_door.unmarked, 0});
  figures.push_back({"H03.generated", "of 3 models, those whose pair and mobility the generator does not name", "1",
                     std::nullopt,
                     unnamed("said_twice", {"'rod'", "'sphere'", "mobility 1"}) +
                         unnamed("two_hinge_door", {"'upper", "'lower", "mobility 1"}) +
                         unnamed("table", {"'leg_A'", "'leg_B'", "'leg_C'", "'leg_D'", "mobility 0"}),
                     0});
  return figures;
}

}  // namespace hard_cases
