#include "strategy/row_groups.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ir/traverse.hpp"
#include "support/disjoint_sets.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::ConstraintIndex;
using kinematics::FreeIndex;

namespace {

using Set = std::set<std::size_t>;

/// Coordinates and speeds, where those that are about the same motion are one: a coordinate and its rate, a quaternion and the angular velocity.
class Motions {
 public:
  explicit Motions(const kinematics::Kinematics& kinematics)
      : coordinates_(kinematics.symbols.configuration.size()), parts_(coordinates_ + kinematics.symbols.speeds.size()) {
    const kinematics::Symbols& symbols = kinematics.symbols;
    for (const ConfigurationIndex i : symbols.configuration.indices())
      place_.emplace(symbols.configuration[i].symbol.index, i.value);
    for (const FreeIndex i : symbols.speeds.indices())
      place_.emplace(symbols.speeds[i].symbol.index, coordinates_ + i.value);
    for (const ConfigurationIndex i : symbols.configuration.indices()) {
      for (const std::size_t place : places_in(kinematics.configuration_rates[i])) parts_.join(i.value, place);
    }
  }

  std::size_t of_speed(std::size_t i) const { return parts_.of(coordinates_ + i); }

  void add_from(Expr e, Set& motions) const {
    for (const std::size_t place : places_in(e)) motions.insert(parts_.of(place));
  }

 private:
  std::vector<std::size_t> places_in(Expr e) const {
    std::vector<std::size_t> places;
    for (const ir::NodeId id : ir::post_order(e.graph(), {e.id()})) {
      const ir::Node& node = e.graph()[id];
      if (node.kind != ir::Kind::symbol) continue;
      if (const auto found = place_.find(node.symbol.index); found != place_.end()) places.push_back(found->second);
    }
    return places;
  }

  std::size_t coordinates_;
  support::DisjointSets parts_;
  std::map<std::uint32_t, std::size_t> place_;  ///< by index of the symbol
};

struct Row {
  Set moved;  ///< motions that have an entry in it
  Set about;  ///< and those that entries depend on
  bool is_left = true;
};

std::vector<Row> rows_of(const Dynamics& dynamics) {
  const Motions motions(*dynamics.kinematics);
  std::vector<Row> rows(dynamics.l());
  for (std::size_t mu = 0; mu < rows.size(); ++mu) {
    for (std::size_t i = 0; i < dynamics.n(); ++i) {
      if (dynamics.b[mu][i].is_zero()) continue;
      rows[mu].moved.insert(motions.of_speed(i));
      motions.add_from(dynamics.b[mu][i], rows[mu].about);
    }
    rows[mu].about.insert(rows[mu].moved.begin(), rows[mu].moved.end());
    if (const auto& f = dynamics.kinematics->constraints[ConstraintIndex{mu}].f) motions.add_from(*f, rows[mu].about);
  }
  return rows;
}

bool has_own(const Row& row, const std::vector<Row>& rows) {
  return std::any_of(row.moved.begin(), row.moved.end(), [&](std::size_t motion) {
    return std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
      return &other != &row && other.is_left && other.about.count(motion) > 0;
    });
  });
}

void leave_out_those_with_own(std::vector<Row>& rows) {
  bool goes_on = true;
  while (goes_on) {
    goes_on = false;
    for (Row& row : rows) {
      if (!row.is_left || !has_own(row, rows)) continue;
      row.is_left = false;
      goes_on = true;
    }
  }
}

bool have_common(const Set& a, const Set& b) {
  return std::any_of(a.begin(), a.end(), [&](std::size_t motion) { return b.count(motion) > 0; });
}

}  // namespace

std::vector<std::optional<std::size_t>> row_groups(const Dynamics& dynamics) {
  std::vector<Row> rows = rows_of(dynamics);
  leave_out_those_with_own(rows);
  support::DisjointSets parts(rows.size());
  for (std::size_t mu = 0; mu < rows.size(); ++mu) {
    for (std::size_t nu = 0; nu < mu; ++nu) {
      if (rows[mu].is_left && rows[nu].is_left && have_common(rows[mu].about, rows[nu].about)) parts.join(mu, nu);
    }
  }
  std::vector<std::optional<std::size_t>> groups;
  for (std::size_t mu = 0; mu < rows.size(); ++mu)
    groups.push_back(rows[mu].is_left ? std::optional(parts.of(mu)) : std::nullopt);
  return groups;
}

}  // namespace gaussgen::strategy
