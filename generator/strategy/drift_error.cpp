#include "strategy/drift_error.hpp"

#include "ir/reverse.hpp"
#include "strategy/term_size.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConstraintIndex;
using support::Rational;

namespace {

/// Of rounding of one operation: what sums of products, and factors of projections, make of it.
const Rational k_rounding = 10'000;
/// Of violations, which are known to first order.
const Rational k_violation = 2;

Expr absolute(Expr e) { return call(ir::Function::abs, e); }

class DriftErrors {
 public:
  DriftErrors(const Dynamics& dynamics, const Vector& off, Expr epsilon)
      : dynamics_(dynamics), off_(off), rounding_(k_rounding * epsilon), size_(epsilon.graph()) {}

  Vector operator()() {
    Vector result;
    for (const ConstraintIndex mu : rows().indices()) result.push_back(rows()[mu].f ? zero() : of_row(mu.value));
    return result;
  }

 private:
  using Rows = support::Indexed<ConstraintIndex, kinematics::ConstraintRow>;

  const Rows& rows() const { return dynamics_.kinematics->constraints; }
  ir::Graph& graph() const { return rounding_.graph(); }
  Expr zero() const { return {graph(), graph().constant(0)}; }

  Expr of_row(std::size_t mu) {
    const Expr drift = dynamics_.b_drift[mu];
    if (drift.is_zero()) return zero();
    Expr error = (rounding_ + k_violation * pow(off_[mu], Rational(1) / 2)) * size_(drift);
    const Vector& speeds = speed_errors();
    const Vector slopes = slopes_of(drift);
    for (std::size_t i = 0; i < slopes.size(); ++i) error += absolute(slopes[i]) * speeds[i];
    return error;
  }

  Vector slopes_of(Expr drift) const {
    std::vector<ir::SymbolId> symbols;
    for (const auto& speed : dynamics_.kinematics->symbols.speeds) symbols.push_back(speed.symbol);
    const Expr one(graph(), graph().constant(1));
    return ir::Reverse(graph(), symbols)({{drift, one}}, "slope");
  }

  const Vector& speed_errors() {
    if (!speeds_.empty()) return speeds_;
    const Vector inertia = inertias(dynamics_);
    for (const Expr i : inertia) lightness_.push_back(reciprocal(i));
    speeds_.assign(dynamics_.n(), zero());
    for (const ConstraintIndex mu : rows().indices()) add_change(mu.value);
    return speeds_;
  }

  /// |δ_i| of the least δ that takes b δ where row mu may be off by `off`: what has no inertia is left out, as in `left_by_all`.
  void add_change(std::size_t mu) {
    const Vector& b = dynamics_.b[mu];
    const Expr phi = rows()[ConstraintIndex{mu}].phi;
    Expr response = zero();
    for (std::size_t i = 0; i < b.size(); ++i) response += pow(b[i], 2) * lightness_[i];
    if (response.is_zero()) return;
    const Expr off = rounding_ * size_(phi) + k_violation * absolute(phi);
    const Expr multiplier = off * reciprocal(response);
    for (std::size_t i = 0; i < b.size(); ++i) speeds_[i] += absolute(b[i]) * lightness_[i] * multiplier;
  }

  /// 0 of 0.
  Expr reciprocal(Expr e) const {
    if (e.is_zero()) return e;
    const Expr is_positive = less(zero(), e), one(graph(), graph().constant(1));
    return select(is_positive, one / select(is_positive, e, one), zero());
  }

  const Dynamics& dynamics_;
  const Vector& off_;
  Expr rounding_;
  TermSize size_;
  Vector lightness_;  ///< 1 / inertia
  Vector speeds_;     ///< how far they may be off
};

}  // namespace

Vector drift_errors(const Dynamics& dynamics, const Vector& off, Expr epsilon) {
  return DriftErrors(dynamics, off, epsilon)();
}

}  // namespace gaussgen::strategy
