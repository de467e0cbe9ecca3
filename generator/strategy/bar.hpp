#pragma once
// The minimum of Z over the turn of a bar, with what is divided by its pivot left as numerators (docs/decisions/0009).

#include <array>
#include <string>

#include "strategy/steps.hpp"

namespace gaussgen::strategy {

/// In the two axes across the axis of a turn, in right-handed order.
using PlaneVector = std::array<ir::Expr, 2>;

/// A symmetric block of Z over two components of an acceleration, with its determinant.
struct PlaneBlock {
  ir::Expr pp, pq, qq;
  ir::Expr determinant;

  static PlaneBlock of(ir::Expr pp, ir::Expr pq, ir::Expr qq) { return {pp, pq, qq, pp * qq - pow(pq, 2)}; }
  PlaneVector operator*(const PlaneVector& v) const { return {pp * v[0] + pq * v[1], pq * v[0] + qq * v[1]}; }
};

/// What turns about its origin, and carries something at its end alone.
struct Bar {
  PlaneVector offset;  ///< of the end
  PlaneBlock end;      ///< of Z over the acceleration of the end
  ir::Expr inertia;    ///< of the bar itself, about its origin
  PlaneVector first;   ///< its mass times its mass centre
};

/// The block over the acceleration of the origin, once Z is minimised over the turn: numerators over one denominator.
///
/// With P at the end, which moves by u per angle, J and k of the bar, I = u·P u + J and b = P u + k, the Schur complement is P - b bᵀ/I. In two
/// dimensions (u·P u) P - P u (P u)ᵀ = det P r rᵀ, r across u. So I times the complement is
///
///     det P r rᵀ + J P - P u kᵀ - k (P u)ᵀ - k kᵀ,
///
/// linear in P and det P: none of it waits for 1/I, nor does a turn into other axes. Its determinant is I ((J - 2 k·u) det P - k·adj(P) k).
class PostponedBlock {
 public:
  /// Values are named after the axes that `name` stands for.
  PostponedBlock(const Bar& bar, const std::string& name, Steps& steps);

  /// Entries as numerators, and the determinant as one: each is to be divided by the denominator once.
  const PlaneBlock& numerators() const { return numerators_; }

  /// Of I, in `unit`.
  ir::Expr denominator() const { return denominator_; }
  ir::Expr unit() const { return unit_; }

  /// 1/I
  ir::Expr inverse() const { return unit_ * pow(denominator_, -1); }

  /// J/I: as much of an acceleration of the origin across the bar as the end follows.
  ir::Expr left_to_end() const { return inertia_ * inverse(); }

  /// The denominator is below zero: masses went to the ends, and left less than nothing.
  bool is_negative() const;

  /// Whether the bar by itself resists no turn, in any configuration: it has no mass, or its masses went to its ends.
  bool is_led_by_end() const;

  /// Turned into other axes.
  void replace(ir::Expr pp, ir::Expr pq, ir::Expr qq) { numerators_ = {pp, pq, qq, numerators_.determinant}; }

  /// A mass that moves with the origin.
  void add_mass(ir::Expr mass);

  PlaneBlock divided() const;

 private:
  PlaneBlock numerators_;
  ir::Expr denominator_, unit_, inertia_;
  bool has_no_first_;
};

}  // namespace gaussgen::strategy
