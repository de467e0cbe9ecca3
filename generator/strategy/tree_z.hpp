#pragma once
// Z of a tree of links and the rows of its constraints, brought from the leaves to the ground: what stands then are the
// components at the minimum over those before them, and a form over the multipliers.

#include <map>
#include <set>

#include "strategy/bar.hpp"
#include "strategy/bounds.hpp"
#include "strategy/ldl.hpp"
#include "strategy/mass_bounds.hpp"
#include "strategy/own_components.hpp"
#include "strategy/quadratic_form.hpp"
#include "strategy/tree.hpp"

namespace gaussgen::strategy {

/// How components with inertia follow a multiplier.
struct Response {
  ir::Expr squares, compliance, inertia;

  void add(ir::Expr pivot, ir::Expr coefficient);

  /// The largest inertia over the least, or nearly.
  ir::Expr spread() const { return compliance * inertia / pow(squares, 2); }
};

/// Rows that close within what a link carries, and their multipliers over what stays of it.
struct ClosedLoop {
  std::vector<std::size_t> rows;
  std::vector<Eliminated> multipliers;  ///< in order; the factors are those of the multipliers that follow, too
  Vector inverses;                      ///< of the pivots of S
};

class TreeZ {
 public:
  TreeZ(const TreeProblem& problem, const TreeForm& form, ir::Expr epsilon, Steps& steps);
  TreeZ(const TreeZ&) = delete;  // the motion refers to the links
  TreeZ& operator=(const TreeZ&) = delete;

 protected:
  /// False where some acceleration has no inertia in any configuration.
  bool minimise();

  static kinematics::Linkage prepared(const kinematics::Linkage& linkage, const TreeForm& form);
  static std::size_t most_rows(const TreeProblem& problem);
  static Component a(std::size_t link, std::size_t k) { return 6 * link + k; }
  static Component alpha(std::size_t link, std::size_t k) { return 6 * link + 3 + k; }
  Component shared(std::size_t speed) const { return 6 * links_.size() + speed; }
  Component first_dual() const { return 6 * links_.size() + problem_.forces.size(); }
  Component dual(std::size_t row) const { return first_dual() + row; }
  bool is_of_link(Component c) const { return c < 6 * links_.size(); }
  bool is_dual(Component c) const { return c >= first_dual(); }
  bool is_linear(Component c) const { return is_of_link(c) && c % 6 < 3; }
  bool by_link() const { return form_.drift == Drift::by_link; }
  bool is_shift(std::size_t i) const { return links_[i].kind == kinematics::Link::Kind::shift; }
  Component first_of_joint(std::size_t i) const { return is_shift(i) ? a(i, 0) : alpha(i, 0); }
  std::string axis_of(Component c) const;
  std::string name_of(Component c) const;
  std::string name_of(Component i, Component j) const;
  ir::Expr one() const { return {graph_, graph_.constant(1)}; }
  ir::Expr force(std::size_t speed) const {
    return per_power_ * (form_.puts_loads_on_links ? problem_.forces_beside : problem_.forces)[speed];
  }
  std::vector<char> acted_on() const;

  bool mixes_speeds();

  // Constraints.
  void place_rows();
  void place_loads();
  void find_bare_links();
  void add_rows(std::size_t i);
  void add_term(const LinkTerm& term, std::size_t r);
  void act(Component c, std::size_t speed, ir::Expr per);
  void impose_rows(std::size_t i, std::vector<Component>& free);
  std::optional<std::size_t> safest(std::size_t r, const std::vector<Component>& free) const;
  /// What a row that is put in adds to components: inertia of the one that leaves.
  std::vector<std::pair<Component, Addition>> additions(std::size_t r, Component c) const;
  void add_bounds(std::size_t r, Component c);
  bool drowns_others(std::size_t r, Component c) const;
  ir::Expr largest(Component c) const;

  // Loops that close on a link (tree_loops.cpp).
  void place_loops();
  /// False where a row is nothing in any configuration.
  bool close_loops(std::size_t i);
  bool resolve(ClosedLoop& loop, std::size_t at, ir::Expr diagonal);
  std::vector<std::size_t> closing_at(std::size_t i) const;
  bool is_closed(std::size_t r) const { return is_closed_[r] != 0; }

  // From the leaves to the ground.
  /// Of the body itself (theory section 6): ½ a·m a + a·(α × f) + ½ α·I α, with what velocities and the drift do.
  void add_body(std::size_t i);
  void add_mass(std::size_t i);
  std::vector<Component> components(std::size_t i) const;
  /// Its own components of the joint, where nothing else minimises over them.
  std::vector<Component> own_of_joint(std::size_t i) const;
  bool inward(std::size_t i);
  void act_on(std::size_t i, int factor);
  std::vector<Component> free_to_float(const FloatingBase& floating);
  bool has_no_inertia(const Eliminated& e) const;
  Eliminated minimise(std::size_t i, Component c);
  ir::Expr trusted(Component c) const;
  ir::Expr rounding_of_sum(ir::Expr pivot) const;
  void pass_bounds(std::size_t i);
  ir::Expr bound_along(std::size_t i, std::size_t speed) const;
  void pass_on(std::size_t i);
  void disturb_origin(std::size_t i);
  void add_shared(std::size_t i, std::size_t k, std::vector<LinearTerm>& terms) const;
  bool is_own(const kinematics::Freedom& freedom) const { return own_.is_owned[freedom.speed.value] != 0; }
  void shift(std::size_t i);
  void turn(std::size_t i);
  void turn_freely(const kinematics::Link& link, Component from, Component to);

  // Bars (bar.hpp).
  void remember_end(std::size_t i);
  std::optional<Bar> bar_at(std::size_t i, Component c) const;
  bool is_only_child(std::size_t i) const;
  Eliminated minimise_bar(std::size_t i, Component c, const Bar& bar);
  std::optional<Lever> lever_of(std::size_t i, const Bar& bar, const PostponedBlock& block) const;
  void replace_block(std::size_t i, std::size_t axis, const PlaneBlock& block);
  PlaneBlock block_of(std::size_t i, std::size_t axis) const;
  void pass_block(std::size_t i);
  std::optional<std::size_t> divide_block(std::size_t i);
  bool minimise_shared(std::size_t i);
  ir::Expr drift_of(const LinkTerm& term) const;

  const TreeProblem& problem_;
  TreeForm form_;
  Steps& steps_;
  ir::Graph& graph_;
  ir::Expr epsilon_;
  ir::Expr zero_;
  kinematics::Linkage linkage_;
  std::vector<kinematics::Link>& links_;
  std::vector<std::size_t> carriers_;  ///< of links: before spins were hung elsewhere
  std::vector<MassProperties> properties_;
  Vector moved_;  ///< masses of the links before that are counted with these
  std::vector<MassBound> bounds_;
  LinkMotion motion_;
  ir::Rational per_power_, per_force_, per_length_;
  LinkRows rows_;
  OwnComponents own_;
  QuadraticForm Z_;
  Vector masses_;                                             ///< at the origins, where they are the same in all axes
  std::vector<std::vector<Eliminated>> eliminated_, shared_;  ///< by link, in order
  std::vector<std::vector<std::size_t>> waiting_;             ///< rows, by link
  std::vector<std::vector<std::pair<std::size_t, const LinkTerm*>>> terms_of_;  ///< of rows, by link
  /// On a link, in its axes, at its origin.
  struct Load {
    ir::Vector3 force, moment;
  };
  /// What turns with a link, in the axes across that of the turn.
  struct Turned {
    std::size_t axis;
    PostponedBlock block;
  };
  struct End {
    PlaneVector offset;
    PlaneBlock block;
  };
  std::map<std::size_t, Turned> postponed_;         ///< by link: its block of Z_ is numerators
  std::map<std::size_t, ir::Expr> determinants_;    ///< by link, of the block in the plane that was divided last
  std::map<std::size_t, End> ends_;                 ///< by the link that turns
  std::vector<std::vector<std::size_t>> children_;  ///< by link
  std::map<std::size_t, Load> loads_;               ///< by link
  std::vector<char> is_bare_;                       ///< by link: neither it nor what it carries has mass, or is held
  std::vector<Imposed> imposed_;
  std::set<Component> is_imposed_;
  std::vector<std::vector<std::size_t>> closing_;  ///< rows over speeds, by the link that carries all these move
  std::vector<char> is_closed_;                    ///< by row
  std::map<std::size_t, ClosedLoop> loops_;        ///< by link
  std::vector<std::pair<ir::Expr, ir::Expr>> loop_margins_;  ///< of the pivots of S there
  std::map<Component, Response> responses_;                  ///< of multipliers
  std::vector<std::pair<ir::Expr, ir::Expr>> margins_;       ///< of pivots
  std::vector<std::pair<ir::Expr, ir::Expr>> row_margins_;   ///< likewise, of rows that were put in
  bool is_clean_ = true;                                     ///< nothing was minimised yet, so nothing has cancelled
  std::size_t pivots_ = 0;
};

}  // namespace gaussgen::strategy
