#include "strategy/bar.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

Expr dot(const PlaneVector& a, const PlaneVector& b) { return a[0] * b[0] + a[1] * b[1]; }

PlaneVector quarter_turn(const PlaneVector& v) { return {-v[1], v[0]}; }

bool is_zero(const PlaneVector& v) { return v[0].is_zero() && v[1].is_zero(); }

// In units of its own inertia, the bar only adds to P.
Expr unit_of(const Bar& bar, const PlaneVector& k) {
  const ir::Graph& graph = bar.inertia.graph();
  const bool is_number = graph[bar.inertia.id()].kind == ir::Kind::constant && !bar.inertia.is_zero();
  return is_number && is_zero(k) ? pow(bar.inertia, -1) : pow(bar.inertia, 0);
}

PlaneBlock numerators_of(const Bar& bar, const PlaneVector& u, const PlaneVector& k, Expr unit) {
  const PlaneBlock& P = bar.end;
  const PlaneVector& r = bar.offset;
  const PlaneVector Pu = P * u;
  const Expr J = unit * bar.inertia;
  const auto entry = [&](std::size_t i, std::size_t j, Expr P_ij) {
    const Expr by_first = Pu[i] * k[j] + Pu[j] * k[i] + k[i] * k[j];
    return J * P_ij + unit * r[i] * r[j] * P.determinant - unit * by_first;
  };
  const Expr across = k[0] * k[0] * P.qq - (k[0] * k[1] * P.pq + k[0] * k[1] * P.pq) + k[1] * k[1] * P.pp;
  const Expr determinant = (J - unit * (dot(k, u) + dot(k, u))) * P.determinant - unit * across;
  return {entry(0, 0, P.pp), entry(0, 1, P.pq), entry(1, 1, P.qq), determinant};
}

}  // namespace

PostponedBlock::PostponedBlock(const Bar& bar, const std::string& name, Steps& steps)
    : numerators_(bar.end),
      denominator_(bar.inertia),
      unit_(bar.inertia),
      inertia_(bar.inertia),
      has_no_first_(is_zero(bar.first)) {
  const PlaneVector u = quarter_turn(bar.offset);
  const PlaneVector k = quarter_turn(bar.first);
  unit_ = unit_of(bar, k);
  numerators_ = numerators_of(bar, u, k, unit_);
  const PlaneBlock& P = bar.end;
  const Expr mixed = u[0] * u[1] * P.pq;
  const Expr denominator =
      unit_ * u[0] * u[0] * P.pp + unit_ * (mixed + mixed) + unit_ * u[1] * u[1] * P.qq + unit_ * bar.inertia;
  denominator_ = steps.name(denominator, name);
}

bool PostponedBlock::is_negative() const {
  const ir::Node& unit = unit_.graph()[unit_.id()];
  return unit.kind == ir::Kind::constant && unit.value < 0;
}

bool PostponedBlock::is_led_by_end() const { return is_negative() || (has_no_first_ && inertia_.is_zero()); }

// det (P + m) = det P + m (tr P + m)
void PostponedBlock::add_mass(Expr mass) {
  const Expr added = mass * denominator_;
  numerators_.determinant += mass * (numerators_.pp + numerators_.qq + added);
  numerators_.pp += added;
  numerators_.qq += added;
}

PlaneBlock PostponedBlock::divided() const {
  const Expr inverse = pow(denominator_, -1);
  const auto& [pp, pq, qq, determinant] = numerators_;
  return {pp * inverse, pq * inverse, qq * inverse, determinant * inverse};
}

}  // namespace gaussgen::strategy
