#include "strategy/release.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "strategy/metric.hpp"
#include "support/disjoint_sets.hpp"

namespace gaussgen::strategy {

using kinematics::BodyIndex;
using kinematics::BodyMotion;
using kinematics::FullIndex;

namespace {

using Columns = support::Indexed<FullIndex, ir::Vector3>;

bool moves(const Columns& columns, FullIndex i) {
  const ir::Vector3& column = columns[i];
  return !column[0].is_zero() || !column[1].is_zero() || !column[2].is_zero();
}

/// Which of the three directions occur in a Jacobian at all.
std::array<bool, 3> directions(const Columns& columns) {
  std::array<bool, 3> used{};
  for (const ir::Vector3& column : columns) {
    for (std::size_t row = 0; row < 3; ++row) used[row] = used[row] || !column[row].is_zero();
  }
  return used;
}

std::size_t number(const std::array<bool, 3>& used) {
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

/// A set of coordinates and what the bodies that they move have in common.
struct Group {
  std::size_t freedoms = 0;
  std::optional<std::array<bool, 3>> translations;
  std::optional<std::array<bool, 3>> rotations;
  bool is_uniform = true;  ///< all bodies move in the same directions

  void add(const BodyMotion& body) {
    add(directions(body.J), translations);
    if (body.is_rigid) add(directions(body.W), rotations);
  }

 private:
  void add(const std::array<bool, 3>& used, std::optional<std::array<bool, 3>>& common) {
    freedoms += number(used);
    is_uniform = is_uniform && (!common || *common == used);
    common = used;
  }
};

std::vector<std::size_t> coordinates_of(const BodyMotion& body) {
  std::vector<std::size_t> result;
  for (const FullIndex i : body.J.indices()) {
    if (moves(body.J, i) || (body.is_rigid && moves(body.W, i))) result.push_back(i.value);
  }
  return result;
}

}  // namespace

bool is_invertible(const Dynamics& dynamics, const std::vector<std::size_t>& coordinates) {
  return dynamics.dependent_rows(metric_over(dynamics, coordinates)).empty();
}

Release::Release(const Dynamics& dynamics) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  const std::size_t count = kinematics.symbols.full_count();
  support::DisjointSets groups(count);  // of coordinates that move a common body
  for (const BodyMotion& body : *kinematics.bodies) {
    const std::vector<std::size_t> own = coordinates_of(body);
    for (const std::size_t i : own) groups.join(own.front(), i);
  }
  std::vector<Group> group(count);
  for (const BodyMotion& body : *kinematics.bodies) {
    const std::vector<std::size_t> own = coordinates_of(body);
    if (!own.empty()) group[groups.of(own.front())].add(body);
  }
  std::vector<std::vector<std::size_t>> members(count);
  for (std::size_t i = 0; i < count; ++i) members[groups.of(i)].push_back(i);
  released_.assign(count, 0);
  for (std::size_t g = 0; g < count; ++g) {
    const std::size_t coordinates = members[g].size();
    if (coordinates == 0 || !group[g].is_uniform || coordinates != group[g].freedoms) continue;
    if (!is_invertible(dynamics, members[g])) continue;
    for (const std::size_t i : members[g]) released_[i] = 1;
  }
}

std::vector<std::size_t> Release::released() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < released_.size(); ++i) {
    if (released_[i] != 0) result.push_back(i);
  }
  return result;
}

}  // namespace gaussgen::strategy
