#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "ir/differentiate.hpp"
#include "ir/vector3.hpp"
#include "kinematics/frames.hpp"
#include "kinematics/place_symbols.hpp"
#include "kinematics/relative_places.hpp"

namespace gaussgen::kinematics {

/// Turns the user's expressions into nodes. They never pass through GiNaC, whose order and signs change from run to run
/// (docs/decisions/0001).
class Expressions {
 public:
  /// With `fold`, parameters are replaced by their numbers; with `limits`, products such as sin(q)/q have theirs.
  Expressions(const model::Model& model, const Symbols& symbols, ir::Graph& graph, bool fold = false,
              bool limits = true);
  Expressions(const Expressions&) = delete;  // the frames refer to these
  Expressions& operator=(const Expressions&) = delete;

  ir::Expr operator()(const model::Ast& ast);
  ir::Vector3 operator()(const std::array<model::Ast, 3>& vector);
  ir::Expr operator()(const std::string& symbol) { return resolved(symbol); }

  /// Total time derivative along the motion with accelerations left out: d/dt of a position expression is its velocity,
  /// of a velocity expression its part that holds no acceleration (theory, section 4: h, Θ, η).
  ir::Expr rate(ir::Expr expression) {
    return (defining_ ? *defining_ : carries_velocities_ ? carried_derivative_ : time_derivative_)(expression);
  }
  ir::Vector3 rate(const ir::Vector3& v) { return {rate(v[0]), rate(v[1]), rate(v[2])}; }

  /// Whether velocities of places are those of the frames that carry them and what is between, each under a name: what is shared along a chain is written
  /// once then, and what would cancel between two of them stays.
  void carry_velocities(bool carries) { carries_velocities_ = carries; }

  /// The last frame that carries all of these, from where they may as well be seen: space where it does not move.
  std::size_t carrier_of(const std::set<std::size_t>& frames) const { return relative_places_.moving_carrier(frames); }

  /// q̇ as functions of q and u.
  const support::Indexed<ConfigurationIndex, ir::Expr>& configuration_rates() const { return configuration_rates_; }

  /// ∂u/∂q̇ of the speeds that the model defines, which have to have an inverse that is found; empty without them.
  const std::vector<std::vector<ir::Expr>>& speed_matrix() const { return speed_matrix_; }
  bool has_rates() const { return has_rates_; }

  /// What these speeds are where no coordinate moves that is not held: 0, but for those that are measured against something.
  const std::vector<ir::Expr>& speeds_at_rest() const { return speeds_at_rest_; }

  Frames& frames() { return frames_; }

  /// The same as from a frame that carries what is asked for.
  Frames& frames_from(std::size_t base);

  /// From now on places in expressions are symbols of `places`; nullptr: what they are in space.
  void watch(PlaceSymbols* places) { watched_ = places; }

  ir::Graph& graph() const { return graph_; }

  /// As functions of reactions limits of friction are asked for: whether these are their symbols, even where there are none of in this regime.
  void show_reactions(bool as_symbols) { shows_reactions_ = as_symbols; }

  /// What stands for the reactions of the model from now on; before, they are their symbols.
  void set_reactions(std::vector<ir::Expr> reactions) { reactions_ = std::move(reactions); }

  ir::Expr number(const support::Rational& value) const { return {graph_, graph_.constant(value)}; }
  ir::Expr symbol(ir::SymbolId id) const { return {graph_, graph_.use(id)}; }

 private:
  ir::Expr formed(const model::Ast& ast);
  /// Parts that are the same from a frame that moves are formed there.
  ir::Expr formed_from_carriers(const model::Ast& ast);
  ir::Expr resolved(const std::string& name);
  ir::Expr slip(std::size_t friction, std::size_t direction);
  ir::Expr axis(std::size_t index);
  ir::Expr watched(const PlaceSymbols::Component& component);
  ir::Expr place(std::size_t frame, std::size_t component);
  ir::Expr folded(std::size_t parameter);
  ir::Expr call(const model::Ast& ast);
  ir::Expr cases(const model::Ast& piecewise);
  void seed_rates();
  /// Rates of held coordinates, of quaternions and of t, which no speed of the model replaces.
  void seed_what_speeds_leave(ir::Directional& derivative);
  std::vector<ir::Expr> rates_from_speeds();
  std::array<ir::Expr, 4> quaternion_rates(std::size_t orientation);

  const model::Model& model_;
  const Symbols& symbols_;
  ir::Graph& graph_;
  bool fold_;
  bool limits_;
  std::unordered_map<std::size_t, ir::Expr> folded_;  ///< values of parameters
  support::Indexed<ConfigurationIndex, ir::Expr> configuration_rates_;
  ir::Directional time_derivative_;
  ir::Directional carried_derivative_;  ///< likewise, with velocities from frame to frame
  bool carries_velocities_ = false;
  std::optional<ir::Directional> defining_;  ///< with the rates as symbols, where they are not known yet
  std::vector<std::vector<ir::Expr>> speed_matrix_;
  std::vector<ir::Expr> speeds_at_rest_;
  bool has_rates_ = true;
  Frames frames_;
  std::map<std::size_t, std::unique_ptr<Frames>> frames_from_;
  RelativePlaces relative_places_;
  Frames* seen_ = &frames_;          ///< of which places and axes in expressions are
  bool looks_for_carriers_ = false;  ///< in an expression with places, as long as they are those in space
  PlaceSymbols* watched_ = nullptr;
  bool shows_reactions_ = false;
  std::vector<ir::Expr> reactions_;  ///< empty: they are not found yet
};

/// The rational value of a constant expression, such as an exponent.
support::Rational constant_value(const model::Ast& ast);

}  // namespace gaussgen::kinematics
