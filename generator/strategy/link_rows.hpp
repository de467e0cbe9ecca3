#pragma once
// What constraints say of the accelerations of links: rows with few entries, where the same rows over speeds have one for each
// coordinate before the link (docs/decisions/0007).

#include <functional>
#include <string>

#include "kinematics/kinematics.hpp"
#include "strategy/ldl.hpp"
#include "strategy/link_axes.hpp"
#include "strategy/link_motion.hpp"

namespace gaussgen::strategy {

/// linear·a + angular·α of a link, in its axes.
struct LinkTerm {
  std::size_t link;
  ir::Vector3 linear;
  ir::Vector3 angular;
};

/// coefficient * du/dt
struct SpeedTerm {
  std::size_t speed;
  ir::Expr coefficient;
};

/// Σ terms + rest = 0, over links or over speeds.
struct LinkRow {
  std::string name;
  std::vector<LinkTerm> links;
  std::vector<SpeedTerm> speeds;
  ir::Expr rest;
  ir::Expr fall;  ///< what free fall, which Z has in it, adds to the terms of links
};

/// factor * multiplier of a row
struct Share {
  std::size_t row;
  ir::Expr factor;
};

struct LinkRows {
  std::vector<LinkRow> rows;
  std::vector<std::vector<Share>> multipliers;  ///< of constraints
  /// Links along whose component an acceleration follows from rows that are here because of it, though nothing in the model moves
  /// freely along it: the third direction of rolling.
  std::vector<std::pair<std::size_t, std::size_t>> released;
};

struct ConstraintProblem {
  const kinematics::Kinematics& kinematics;
  Matrix b;  ///< over free speeds: b du/dt + drift = 0
  Vector b_drift;
  std::function<ir::Expr(ir::Expr)> rate_of;  ///< d/dt of what depends on coordinates
  std::function<bool(ir::Expr)> vanishes;     ///< in every state, whatever form the expression has
  /// A - Q along a speed, of accelerations, by the metric over all speeds; none where that would be long.
  std::function<ir::Expr(std::size_t speed, const Vector& a)> excess;
  std::function<double(ir::Expr)> value_of;  ///< at some point; none where parameters may take any value
  /// With parameters as in the model and, where there are coordinates in it, at some point; infinite where it has no value.
  std::function<double(ir::Expr)> estimate;
  /// Added to b du/dt of each constraint beside what velocities make of it: what is left of an equation where nothing moves. None of it: empty.
  Vector residuals;
};

/// Which rows are those of places on links, and what they say.
class LinkRowBuilder {
 public:
  /// Lets the axes of wheels follow the places where they touch.
  LinkRowBuilder(const ConstraintProblem& problem, kinematics::Linkage& linkage);

  LinkRows rows(LinkMotion& motion, Steps& steps) const;

 private:
  /// What a constraint acts on: a place that belongs to a link now.
  struct Spot {
    std::size_t link;
    std::size_t place;  ///< frame
    ir::Vector3 direction;
  };
  struct PlacedRow {
    std::size_t constraint;  ///< or beyond them, an idle slip
    std::size_t axes;        ///< frame
    std::vector<Spot> spots;
  };
  /// Rows along axes of space over the same places.
  struct Group {
    std::array<std::optional<std::size_t>, 3> along;  ///< index into placed_
  };

  std::optional<PlacedRow> placed(std::size_t constraint, const kinematics::ConstraintRow& row) const;
  bool can_be_placed(const kinematics::ConstraintAction& action) const;
  void follow_contacts();
  void find_groups();
  void add_to_groups(std::size_t index);
  void release_or_drop(Group& group);

  static std::size_t first_of(const Group& group);
  std::size_t axes_of(const Group& group) const;
  void add(const Group& group, LinkMotion& motion, LinkAxes& in_space, Steps& steps, LinkRows& result) const;
  void add(const PlacedRow& row, LinkMotion& motion, Steps& steps, LinkRows& result) const;
  void add_over_speeds(std::size_t constraint, LinkRows& result) const;

  ir::Vector3 position(const Spot& spot) const;
  void add_term(const Spot& spot, const ir::Vector3& direction, LinkMotion& motion, LinkRow& row) const;
  LinkRow empty_row(std::size_t index) const;
  void set_fall(ir::Expr fall, LinkRow& row) const;
  bool is_idle(std::size_t index) const { return placed_[index]->constraint >= problem_.b.size(); }
  const kinematics::ConstraintRow& row_of(std::size_t index) const;
  /// What a row says beside the motion of its places.
  ir::Expr rest_beside(std::size_t index) const;
  ir::Expr number(int value) const { return {graph_, graph_.constant(value)}; }

  const ConstraintProblem& problem_;
  kinematics::Linkage& linkage_;
  ir::Graph& graph_;
  std::vector<std::optional<PlacedRow>> placed_;  ///< of constraints, then of idle slips
  std::vector<Group> groups_;
  std::vector<std::pair<std::size_t, std::size_t>> released_;
};

}  // namespace gaussgen::strategy
