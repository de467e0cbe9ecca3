// Reactions as forces and moments on bodies: their sum by Newton on bare points, each one by its virtual work.

#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "strategy/emitted_numbers.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

constexpr double k_wrench_tolerance = 1e-14;

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 vec3(const Vec& v) { return {v.at(0), v.at(1), v.at(2)}; }

/// The mass points of one body; bodies come in the order of the model, six points for a rigid one.
struct Points {
  std::string body;
  bool is_rigid = false;
  std::size_t first = 0;
  std::size_t last = 0;
};

std::vector<Points> points_of(const Mechanics& mechanics, const BareSystem& bare) {
  std::vector<Points> result;
  std::size_t next = 0;
  for (const auto& body : *mechanics.kinematics.bodies) {
    const std::size_t count = body.is_rigid ? 6 : 1;
    result.push_back({body.name, body.is_rigid, next, next + count});
    next += count;
  }
  REQUIRE(next == bare.mass.size());
  return result;
}

/// Σ m v / Σ m
Vec3 mean(const BareSystem& bare, const Points& points, const std::vector<Vec3>& v) {
  Vec3 sum{0, 0, 0};
  Real mass = 0;
  for (std::size_t p = points.first; p < points.last; ++p) {
    mass += bare.mass[p];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += bare.mass[p] * v[p][i];
  }
  return {sum[0] / mass, sum[1] / mass, sum[2] / mass};
}

struct Wrench {
  Vec3 force{0, 0, 0};
  Vec3 moment{0, 0, 0};
};

/// Σ m (a - field) and its moment about the mass centre.
Wrench newton(const BareSystem& bare, const Points& points, const std::vector<Vec3>& a) {
  const std::vector<Vec3> r = bare.positions(bare.y, bare.t);
  const Vec3 centre = mean(bare, points, r);
  Wrench sum;
  for (std::size_t p = points.first; p < points.last; ++p) {
    Vec3 force = minus(a[p], bare.field);
    for (Real& component : force) component *= bare.mass[p];
    const Vec3 moment = cross(minus(r[p], centre), force);
    for (std::size_t i = 0; i < 3; ++i) {
      sum.force[i] += force[i];
      sum.moment[i] += moment[i];
    }
  }
  return sum;
}

/// The small rotation δθ of δr = δr_G + δθ × (r - r_G), as Σ ρ × δr = (Σ ρ² - ρ ρᵀ) δθ.
Vec3 rotation(const BareSystem& bare, const Points& points, const std::vector<Vec3>& moved) {
  const std::vector<Vec3> r = bare.positions(bare.y, bare.t);
  const Vec3 centre = mean(bare, points, r);
  Mat matrix(3, Vec(3, 0));
  Vec right(3, 0);
  for (std::size_t p = points.first; p < points.last; ++p) {
    const Vec3 arm = minus(r[p], centre);
    const Vec3 turned = cross(arm, moved[p]);
    for (std::size_t i = 0; i < 3; ++i) {
      right[i] += turned[i];
      for (std::size_t j = 0; j < 3; ++j) matrix[i][j] += (i == j ? dot(arm, arm) : Real(0)) - arm[i] * arm[j];
    }
  }
  return vec3(solve(matrix, right));
}

/// Work of emitted forces and moments of one constraint in the displacement along y^A.
Real work(const std::map<std::string, Vec>& fields, const std::string& constraint, const std::optional<Vec3>& point,
          const Mechanics& mechanics, const BareSystem& bare, std::size_t A) {
  const std::vector<Vec3> moved = displacements(bare, A);
  Real sum = 0;
  for (const Points& points : points_of(mechanics, bare)) {
    const auto force = fields.find(constraint + ".force_on_" + points.body);
    if (force == fields.end()) continue;
    sum += dot(vec3(force->second), mean(bare, points, moved));
    if (!points.is_rigid) continue;
    const Vec3 turn = rotation(bare, points, moved);
    // A moment about P: the force acts at P, and P moves with the body.
    if (point)
      sum += dot(vec3(force->second), cross(turn, minus(*point, mean(bare, points, bare.positions(bare.y, bare.t)))));
    sum += dot(vec3(fields.at(constraint + ".moment_on_" + points.body)), turn);
  }
  return sum;
}

/// What the model says in `point:`, computed here.
std::optional<Vec3> stated_point(const std::string& model, const std::string& constraint, const Case& c) {
  const Vec& y = c.bare.y;
  if (model == "sphere_in_cylinder_quaternion")
    return Vec3{c.values.at("R") * cos(y[0]), c.values.at("R") * sin(y[0]), y[1]};
  if (model != "released_top" || constraint != "edge") return std::nullopt;
  const Real l = c.values.at("l");
  return Vec3{y[5] - l, y[0], y[1] + l / 3};
}

bool is_stated(const std::map<std::string, Vec>& fields, const std::string& constraint) {
  const auto first = fields.lower_bound(constraint + ".force_on_");
  return first != fields.end() && first->first.rfind(constraint + ".force_on_", 0) == 0;
}

}  // namespace

TEST_CASE("the sum of all constraint forces on a body, and their moment, are Newton's of its bare points") {
  for (const BareModel& model : bare_models()) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Case c = model.at(seed);
      EmittedNumbers emitted(c);
      const auto a = [&] {
        Vec all = minimise(c.bare, probe(c.bare)).accelerations;
        all.insert(all.end(), c.bare.held_acceleration.begin(), c.bare.held_acceleration.end());
        return accelerations(c.bare, all);
      }();
      auto fields = emitted.fields("reaction_forces");
      INFO(model.name << ", seed " << seed);
      for (const Points& points : points_of(emitted.mechanics(), c.bare)) {
        const Wrench expected = newton(c.bare, points, a);
        const Vec& force = fields.at("on_" + points.body + ".force");
        CHECK(deviation(force, Vec(expected.force.begin(), expected.force.end())) < k_wrench_tolerance);
        CHECK(fields.count("on_" + points.body + ".moment") == (points.is_rigid ? 1U : 0U));
        if (!points.is_rigid) continue;
        const Vec& moment = fields.at("on_" + points.body + ".moment");
        CHECK(deviation(moment, Vec(expected.moment.begin(), expected.moment.end())) < k_wrench_tolerance);
      }
    }
  }
}

TEST_CASE("the forces and moments of one constraint work as lambda beta_A, or R_j, along every coordinate") {
  std::vector<std::string> stated;
  for (const BareModel& model : bare_models()) {
    const Case c = model.at(4);
    EmittedNumbers emitted(c);
    const Mechanics& mechanics = emitted.mechanics();
    const Probe p = probe(c.bare);
    const Motion motion = minimise(c.bare, p);
    auto fields = emitted.fields("reaction_forces");
    INFO(model.name);
    for (std::size_t mu = 0; mu < mechanics.dynamics.l(); ++mu) {
      const std::string& name = mechanics.dynamics.constraints[mu];
      if (!is_stated(fields, name)) continue;
      stated.push_back(model.name + "/" + name);
      for (std::size_t A = 0; A < c.bare.y.size(); ++A) {
        INFO(name << ", coordinate " << A);
        CHECK(deviation(work(fields, name, stated_point(model.name, name, c), mechanics, c.bare, A),
                        motion.lambda[mu] * p.beta[mu][A]) < k_wrench_tolerance);
      }
    }
    for (const auto j : mechanics.symbols.held.indices()) {
      const std::string& name = mechanics.symbols.held[j].name;
      if (!is_stated(fields, name)) continue;
      stated.push_back(model.name + "/" + name);
      for (std::size_t A = 0; A < c.bare.y.size(); ++A) {
        const Real expected = A == c.bare.free_count + j.value ? motion.R_x[j.value] : Real(0);
        INFO(name << ", coordinate " << A);
        CHECK(deviation(work(fields, name, std::nullopt, mechanics, c.bare, A), expected) < k_wrench_tolerance);
      }
    }
  }
  // Six components each, so this determines them; the models without enough coordinates state none.
  CHECK_THAT(stated, Catch::UnorderedEquals(std::vector<std::string>{
                         "sphere_in_cylinder/rolling_around", "sphere_in_cylinder/rolling_along",
                         "sphere_in_cylinder/rho", "sphere_in_cylinder_quaternion/rolling_around",
                         "sphere_in_cylinder_quaternion/rolling_along", "sphere_in_cylinder_quaternion/rho",
                         "skew_chart/s", "released_top/edge", "released_top/blade", "released_top/x"}));
}
