// Bounds of what is left of Z (strategy/mass_bounds.hpp), which say how large the rounding in a pivot can be, against bare points: Z of the
// points of a tree, minimised over its free hinges by elimination, at many states.

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "catch_shim.hpp"
#include "strategy/mass_bounds.hpp"

namespace {

using gaussgen::ir::Expr;
using gaussgen::ir::Graph;
using gaussgen::ir::Rational;
using gaussgen::ir::Vector3;
using gaussgen::kinematics::k_ground;
using gaussgen::kinematics::Link;
using namespace gaussgen::strategy;

using Real = long double;
using Vec = std::array<Real, 3>;
using Axes = std::array<Vec, 3>;  ///< columns, in the axes of the base
using Row = std::vector<Real>;

constexpr Real k_rounding = 1e-15L;

struct Point {
  int mass;
  std::array<int, 3> place;  ///< in the axes of its link
};

struct Member {
  Link::Kind kind;
  std::size_t parent;
  std::size_t axis;           ///< of a turn
  std::array<int, 3> offset;  ///< of a shift
  bool is_free;               ///< Z is minimised over its turn
  std::vector<Point> points;
};

using Tree = std::vector<Member>;  ///< parents first

Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec resolved(const Axes& axes, const std::array<int, 3>& v) {
  Vec result{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) result[l] += axes[k][l] * v[k];
  }
  return result;
}

Axes turned(Axes axes, std::size_t axis, Real angle) {
  const Vec p = axes[(axis + 1) % 3], q = axes[(axis + 2) % 3];
  for (std::size_t l = 0; l < 3; ++l) {
    axes[(axis + 1) % 3][l] = std::cos(angle) * p[l] + std::sin(angle) * q[l];
    axes[(axis + 2) % 3][l] = -std::sin(angle) * p[l] + std::cos(angle) * q[l];
  }
  return axes;
}

/// Three angles for each member: a turn has the first, a free one all of them.
using State = std::vector<std::array<Real, 3>>;

struct Pose {
  Axes axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec origin{};
};

std::vector<Pose> poses(const Tree& tree, const State& state) {
  std::vector<Pose> result;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Member& member = tree[i];
    Pose pose = member.parent == k_ground ? Pose{} : result[member.parent];
    if (member.kind == Link::Kind::shift) {
      const Vec way = resolved(pose.axes, member.offset);
      for (std::size_t k = 0; k < 3; ++k) pose.origin[k] += way[k];
    } else if (member.kind == Link::Kind::turn) {
      pose.axes = turned(pose.axes, member.axis, state[i][0]);
    } else {
      for (std::size_t axis = 0; axis < 3; ++axis) pose.axes = turned(pose.axes, axis, state[i][axis]);
    }
    result.push_back(pose);
  }
  return result;
}

struct Hinge {
  std::size_t member;
  Vec axis, place;
};

std::vector<Hinge> free_hinges(const Tree& tree, const std::vector<Pose>& at) {
  std::vector<Hinge> result;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (!tree[i].is_free) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (tree[i].kind == Link::Kind::free || axis == tree[i].axis)
        result.push_back({i, at[i].axes[axis], at[i].origin});
    }
  }
  return result;
}

bool carries(const Tree& tree, std::size_t carrier, std::size_t i) {
  while (i != carrier && i != k_ground) i = tree[i].parent;
  return i == carrier;
}

/// Z over the acceleration of the origin of the base (0 to 2) and its angular acceleration (3 to 5), at its minimum over the hinges.
std::vector<Row> articulated(const Tree& tree, const State& state) {
  const std::vector<Pose> at = poses(tree, state);
  const std::vector<Hinge> hinges = free_hinges(tree, at);
  const std::size_t n = 6 + hinges.size();
  std::vector<Row> Z(n, Row(n, 0));
  for (std::size_t i = 0; i < tree.size(); ++i) {
    for (const Point& point : tree[i].points) {
      Vec r = resolved(at[i].axes, point.place);
      for (std::size_t k = 0; k < 3; ++k) r[k] += at[i].origin[k];
      std::vector<Vec> moved(n, Vec{});
      for (std::size_t k = 0; k < 3; ++k) {
        moved[k][k] = 1;
        moved[3 + k] = cross(moved[k], r);
      }
      for (std::size_t h = 0; h < hinges.size(); ++h) {
        const Hinge& hinge = hinges[h];
        if (!carries(tree, hinge.member, i)) continue;
        moved[6 + h] = cross(hinge.axis, {r[0] - hinge.place[0], r[1] - hinge.place[1], r[2] - hinge.place[2]});
      }
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) Z[a][b] += point.mass * dot(moved[a], moved[b]);
      }
    }
  }
  for (std::size_t last = n; last-- > 6;) {
    if (Z[last][last] < 1e-12L) continue;  // nothing is moved that the hinges behind it do not move
    for (std::size_t a = 0; a < last; ++a) {
      const Real factor = Z[a][last] / Z[last][last];
      for (std::size_t b = 0; b < last; ++b) Z[a][b] -= factor * Z[last][b];
    }
  }
  return Z;
}

class Numbers {
 public:
  Expr number(int value) { return {graph, graph.constant(value)}; }

  Real value(Expr e) const {
    REQUIRE(graph[e.id()].kind == gaussgen::ir::Kind::constant);
    return gaussgen::support::to_double(graph[e.id()].value);
  }

  MassBound own(const std::vector<Point>& points) {
    MassProperties sum{number(0), gaussgen::ir::zero3(graph), {none(), none(), none()}};
    for (const Point& point : points) {
      const Expr m = number(point.mass);
      sum.mass += m;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
        sum.first[k] += number(point.mass * point.place[k]);
        sum.inertia[k][k] += number(point.mass * (point.place[p] * point.place[p] + point.place[q] * point.place[q]));
      }
    }
    return MassBound::of(sum);
  }

  /// As Z is minimised: from the leaves, about the origin and in the axes of the base.
  MassBound bound(const Tree& tree) {
    MassBound base = own({});
    std::vector<MassBound> bounds;
    for (const Member& member : tree) bounds.push_back(own(member.points));
    for (std::size_t i = tree.size(); i-- > 0;) {
      const Member& member = tree[i];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (member.is_free && (member.kind == Link::Kind::free || axis == member.axis)) bounds[i].minimise(axis);
      }
      (member.parent == k_ground ? base : bounds[member.parent]).add(passed_on(link(member), bounds[i]));
    }
    return base;
  }

 private:
  Vector3 none() { return gaussgen::ir::zero3(graph); }

  Link link(const Member& member) {
    const Vector3 offset{number(member.offset[0]), number(member.offset[1]), number(member.offset[2])};
    return {member.kind, member.parent, 0,  "link", offset, member.axis, {}, {}, gaussgen::ir::identity3(graph),
            none(),      none(),        {}, {},     {}};
  }

  Graph graph;
};

struct Limits {
  Real mass;
  Vec moment, inertia;
  Real trace;
};

Limits limits(const Tree& tree) {
  Numbers numbers;
  const MassBound bound = numbers.bound(tree);
  Limits result{numbers.value(bound.mass), {}, {}, numbers.value(bound.inertia.sum())};
  for (std::size_t k = 0; k < 3; ++k) {
    result.moment[k] = numbers.value(bound.moment.along(k));
    result.inertia[k] = numbers.value(bound.inertia.along(k));
  }
  return result;
}

class Random {
 public:
  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(engine_); }
  Real real() { return std::uniform_real_distribution<Real>(-1, 1)(engine_); }

  Tree tree() {
    Tree result;
    const int count = whole(1, 7);
    for (int i = 0; i < count; ++i) {
      const bool is_first = result.empty() || whole(0, 9) == 0;
      const std::size_t parent = is_first ? k_ground : result.size() - 1 - static_cast<std::size_t>(whole(0, i / 2));
      const int kind = whole(0, 5);
      const auto axis = static_cast<std::size_t>(whole(0, 2));
      const bool is_free = whole(0, 1) == 0;
      if (kind < 3) {
        result.push_back({Link::Kind::shift, parent, 0, {whole(-3, 3), whole(-3, 3), whole(-3, 3)}, false, points()});
      } else {
        result.push_back({kind < 5 ? Link::Kind::turn : Link::Kind::free, parent, axis, {}, is_free, points()});
      }
    }
    result.back().points.push_back(point());
    return result;
  }

  State state(const Tree& tree) {
    State result;
    for (std::size_t i = 0; i < tree.size(); ++i) {
      // Right angles and straight ones are where bounds are reached.
      const auto angle = [&] { return whole(0, 1) == 0 ? 3.2L * real() : std::acos(0.0L) * whole(-2, 2); };
      result.push_back({angle(), angle(), angle()});
    }
    return result;
  }

 private:
  Point point() { return {whole(1, 9), {whole(-3, 3), whole(-3, 3), whole(-3, 3)}}; }

  std::vector<Point> points() {
    std::vector<Point> result;
    for (int count = whole(0, 2); count > 0; --count) result.push_back(point());
    return result;
  }

  std::mt19937 engine_{20261123};
};

/// ½ mass a·a + |a| moment |α| + ½ inertia α·α with α along one axis, against Z.
void check_along(const std::vector<Row>& Z, const Limits& limits, std::size_t axis, const Vec& a, Real alpha) {
  Real value = alpha * alpha * Z[3 + axis][3 + axis];
  for (std::size_t k = 0; k < 3; ++k) {
    value += 2 * alpha * a[k] * Z[3 + axis][k];
    for (std::size_t l = 0; l < 3; ++l) value += a[k] * a[l] * Z[k][l];
  }
  const Real bound = limits.mass * dot(a, a) + 2 * std::sqrt(dot(a, a)) * limits.moment[axis] * std::abs(alpha) +
                     limits.inertia[axis] * alpha * alpha;
  const Real scale = limits.mass * dot(a, a) + (Z[3 + axis][3 + axis] + limits.inertia[axis] + 1) * alpha * alpha;
  CHECK(static_cast<double>(value) <= static_cast<double>(bound + 1000 * k_rounding * scale));
}

void check_state(const Tree& tree, const Limits& limits, const State& state, Random& random) {
  const std::vector<Row> Z = articulated(tree, state);
  const Real rounding = 1000 * k_rounding * (limits.mass + limits.trace);
  CHECK(static_cast<double>(Z[3][3] + Z[4][4] + Z[5][5]) <= static_cast<double>(limits.trace + rounding));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    check_along(Z, limits, axis, {0, 0, 0}, 1);
    for (int k = 0; k < 4; ++k)
      check_along(Z, limits, axis, {random.real(), random.real(), random.real()}, 3 * random.real());
  }
}

/// A member that turns about z and one that leads along x, by length, with a point at its end.
void add_bar(Tree& tree, int length, int mass, bool is_free) {
  const std::size_t before = tree.empty() ? k_ground : tree.size() - 1;
  tree.push_back({Link::Kind::turn, before, 2, {}, is_free, {}});
  tree.push_back({Link::Kind::shift, tree.size() - 1, 0, {length, 0, 0}, false, {{mass, {0, 0, 0}}}});
}

}  // namespace

TEST_CASE("what is left of Z at its minimum over the hinges of a tree stays below its bound, in any state") {
  Random random;
  for (int i = 0; i < 400; ++i) {
    const Tree tree = random.tree();
    const Limits bound = limits(tree);
    INFO("tree " << i);
    for (int k = 0; k < 25; ++k) check_state(tree, bound, random.state(tree), random);
  }
}

TEST_CASE("the bound of an arm whose joints are held is its moment of inertia where it is stretched out") {
  for (int count = 1; count <= 5; ++count) {
    Tree arm;
    for (int i = 0; i < count; ++i) add_bar(arm, i + 1, 2 * i + 1, false);
    const Real most = articulated(arm, State(arm.size()))[5][5];
    INFO(count << " bars");
    CHECK(static_cast<double>(limits(arm).inertia[2]) == Approx(static_cast<double>(most)).epsilon(1e-14));
  }
}

TEST_CASE("the bound of an arm whose joints are free is reached where all that hangs on the first bar is drawn along") {
  for (int count = 1; count <= 5; ++count) {
    Tree arm;
    for (int i = 0; i < count; ++i) add_bar(arm, i + 1, 2 * i + 1, i > 0);
    State state(arm.size());
    if (count > 1)
      state[2][0] = std::acos(0.0L);  // the second bar stands across the first, and the others lie along it
    const Real most = articulated(arm, state)[5][5];
    INFO(count << " bars");
    CHECK(static_cast<double>(limits(arm).inertia[2]) == Approx(static_cast<double>(most)).epsilon(1e-14));
  }
}

TEST_CASE("axes that turn into each other share a bound of at most three times what one of them reaches") {
  const std::vector<Point> rod{{2, {0, 3, 0}}, {1, {0, -2, 0}}};
  for (const std::size_t axis : {0U, 2U}) {
    const Tree turned{{Link::Kind::turn, k_ground, axis, {}, false, rod}};
    const Tree anyhow{{Link::Kind::free, k_ground, 0, {}, false, rod}};
    const Limits one = limits(turned), all = limits(anyhow);
    const Real most = 2 * 9 + 1 * 4;
    const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
    INFO("about "
         << "xyz"[axis]);
    CHECK(static_cast<double>(one.inertia[p]) == static_cast<double>(most));
    CHECK(static_cast<double>(one.inertia[q]) == static_cast<double>(most));
    CHECK(static_cast<double>(one.inertia[axis]) == static_cast<double>(most));
    CHECK(static_cast<double>(all.inertia[0]) <= static_cast<double>(3 * most));
    CHECK(static_cast<double>(all.trace) == static_cast<double>(2 * most));
  }
}
