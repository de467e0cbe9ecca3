#pragma once
// Z as a quadratic function of acceleration components, and the steps by which its minimum is found one component at a time
// (theory section 4; docs/decisions/0007).

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// Number of an acceleration component, in the order in which they are named.
using Component = std::size_t;

/// coefficient * w_component
struct LinearTerm {
  Component component;
  ir::Expr coefficient;
};

/// w_along + arm w, with `ratio` = 1 - arm factor_along in a form without a difference.
struct Lever {
  Component along;
  ir::Expr arm;
  ir::Expr ratio;
};

/// A component at the minimum, over those that stay: w = offset - Σ factor_j w_j.
struct Eliminated {
  Component component;
  ir::Expr pivot;
  ir::Expr offset;
  std::vector<LinearTerm> factors;
  std::optional<Lever> lever;  ///< where w is best found by what moves at the end of a lever
};

/// A component that a row of constraints says, w = offset - Σ factor_j w_j, and what its own row of Z was: with
/// P_cλ λ + Σ row_j w_j + linear = 0 it gives the multiplier.
struct Imposed {
  Eliminated component;
  Component dual;
  std::vector<LinearTerm> row;
  ir::Expr linear;
};

/// ½ wᵀ P w + pᵀ w, up to what does not depend on w. Only what is not zero is kept.
class QuadraticForm {
 public:
  /// `name_of` names the entry of two components in emitted code, or the linear part of one that is given twice.
  using NameOf = std::function<std::string(Component, Component, bool is_linear)>;

  /// Between components from `first_dual` on, entries are sums until they are complete: `minimise` gives these no names, so that sin² + cos² in
  /// them can be 1.
  QuadraticForm(ir::Graph& graph, std::size_t count, Component first_dual, NameOf name_of);

  ir::Expr entry(Component i, Component j) const;
  ir::Expr linear(Component i) const { return p_[i]; }
  bool holds(Component i) const { return !P_[i].empty() || !p_[i].is_zero(); }

  void add(Component i, Component j, ir::Expr value);
  void add(Component i, ir::Expr value) { p_[i] += value; }

  /// min over w_i: what stays is the Schur complement.
  Eliminated minimise(Component i, Steps& steps);

  /// Likewise, with 1/P_ii as it is given.
  Eliminated minimise(Component i, ir::Expr inverse, Steps& steps);

  /// Likewise of a multiplier, over which the form is stationary: P_ii is -S with S > 0, and `inverse` is 1/S, or 0 where its row is dropped. Products
  /// with it are formed as such, for a pivot next to nothing comes with a reciprocal beyond all others.
  Eliminated resolve(Component i, ir::Expr inverse, const std::string& name);

  void replace(Component i, Component j, ir::Expr value);

  /// The row of a dual, P_λc w_c + Σ P_λj w_j + p_λ = 0, put into the rest: both leave.
  Imposed impose(Component i, Component dual, Steps& steps);

  /// w_i = w_i' + by
  void displace(Component i, ir::Expr by);

  /// w_i = w_i' + term
  void couple(Component i, const LinearTerm& term);

  /// w_i = Σ terms, which w_i is not among.
  void substitute(Component i, const std::vector<LinearTerm>& terms);

  /// (w_i, w_j) = (c w_k + s w_l, c w_l - s w_k)
  void turn(Component i, Component j, Component k, Component l, ir::Expr sine, ir::Expr cosine);

  /// The components that stand in a row with this one.
  std::vector<Component> neighbours(Component i) const;

  /// Gives what stands in these rows names, so that it is computed once.
  void name(const std::vector<Component>& rows, Steps& steps);

 private:
  using Row = std::map<Component, ir::Expr>;

  /// Takes the row of a component out.
  Row extract(Component i);

  /// Takes a component out that follows the others by these factors; the row is what stood beside it.
  std::vector<Component> put_in(Component i, const Row& row, const Vector& factors, Eliminated& result);

  std::vector<Component> row_of(Component i) const;
  void name(Component i, Component j, Steps& steps);

  ir::Expr zero_;
  Component first_dual_;
  std::vector<Row> P_;
  Vector p_;
  NameOf name_of_;
};

}  // namespace gaussgen::strategy
