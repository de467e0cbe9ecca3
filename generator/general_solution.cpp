#include "general_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "speed_scales.hpp"
#include "strategy/bounds.hpp"

namespace gaussgen {

namespace {

using cln::cl_F;
using evaluate::Matrix;
using evaluate::Vector;

/// g a = f + bᵀ λ, b a + drift = 0 in numbers.
struct System {
  Matrix g, b, reach;
  Vector f, drift;

  std::size_t n() const { return f.size(); }
  std::size_t l() const { return drift.size(); }
};

std::optional<Vector> values_of(const strategy::Vector& expressions, ModelValues& values) {
  Vector result;
  for (const ir::Expr expression : expressions) {
    const std::optional<cl_F> value = values(expression.id());
    if (!value) return std::nullopt;
    result.push_back(*value);
  }
  return result;
}

std::optional<System> system_at(Mechanics& mechanics, ModelValues& values) {
  const strategy::Dynamics& dynamics = mechanics.dynamics;
  const auto g = values(dynamics.g), b = values(dynamics.b), reach = values(strategy::bounds_of(dynamics.b));
  const auto f = values_of(dynamics.f, values), drift = values_of(dynamics.b_drift, values);
  if (!g || !b || !reach || !f || !drift) return std::nullopt;
  return System{*g, *b, *reach, *f, *drift};
}

/// 1 over the lengths of rows where inertias are 1, as in gauss/constrained.hpp: what is least has to be measured in the same way.
class RowScales {
 public:
  explicit RowScales(const System& system)
      : system_(system),
        zero_(cln::cl_float(0, system.g(0, 0))),
        speeds_(speed_scales(
            diagonal(system.g), system.l(), [&](std::size_t mu, std::size_t i) { return system.b(mu, i); }, zero_)) {}

  Vector operator()() const {
    const Vector sizes = lengths(system_.b), reaches = lengths(system_.reach);
    const cl_F least = cln::cl_float(std::sqrt(std::sqrt(std::numeric_limits<double>::epsilon())), zero_);
    Vector scales;
    for (std::size_t mu = 0; mu < sizes.size(); ++mu) {
      if (cln::zerop(sizes[mu])) {
        scales.push_back(zero_);
        continue;
      }
      const cl_F limit = sizes[mu] / cln::min(part_of_reach(mu), least);
      scales.push_back(cln::recip(cln::max(sizes[mu], cln::min(reaches[mu], limit))));
    }
    return scales;
  }

 private:
  cl_F part_of_reach(std::size_t mu) const {
    cl_F part = zero_;
    for (std::size_t i = 0; i < system_.n(); ++i) {
      if (!cln::zerop(system_.reach(mu, i))) part = cln::max(part, cln::abs(system_.b(mu, i) / system_.reach(mu, i)));
    }
    return part;
  }

  Vector lengths(const Matrix& rows) const {
    Vector result;
    for (std::size_t mu = 0; mu < rows.rows(); ++mu) {
      cl_F squares = zero_;
      for (std::size_t i = 0; i < rows.columns(); ++i) squares = squares + cln::square(rows(mu, i) * speeds_[i]);
      result.push_back(cln::sqrt(squares));
    }
    return result;
  }

  static Vector diagonal(const Matrix& g) {
    Vector result;
    for (std::size_t i = 0; i < g.rows(); ++i) result.push_back(g(i, i));
    return result;
  }

  const System& system_;
  cl_F zero_;
  Vector speeds_;
};

std::vector<std::size_t> independent_rows(const System& system, const std::vector<Dependence>& dependent) {
  std::vector<std::size_t> rows;
  for (std::size_t mu = 0; mu < system.l(); ++mu) {
    const bool follows =
        std::any_of(dependent.begin(), dependent.end(), [&](const Dependence& found) { return found.index == mu; });
    if (!follows) rows.push_back(mu);
  }
  return rows;
}

/// Accelerations, then multipliers of `rows`, as if they were all.
std::optional<Vector> solution_by(const System& system, const std::vector<std::size_t>& rows) {
  const std::size_t n = system.n();
  Matrix kkt(n + rows.size(), n + rows.size(), system.g(0, 0));
  Vector right = system.f;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) kkt(i, j) = system.g(i, j);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      kkt(i, n + k) = -system.b(rows[k], i);
      kkt(n + k, i) = system.b(rows[k], i);
    }
  }
  for (const std::size_t row : rows) right.push_back(-system.drift[row]);
  return evaluate::solve(kkt, right);
}

/// A sum of which less than three quarters of the digits carried would show beside terms of `size` is nothing.
cl_F without_rounding(const cl_F& sum, const cl_F& size) {
  const auto digits = static_cast<sintC>(cln::float_digits(sum));
  return cln::abs(sum) <= cln::scale_float(size, -3 * (digits / 4)) ? cln::cl_float(0, sum) : sum;
}

/// Rows B with each row scaled, B = C B_rows: of all λ with Bᵀ λ = f, the least is C (Cᵀ C)⁻¹ (B_rows B_rowsᵀ)⁻¹ B_rows f.
std::optional<Vector> least_multipliers(const System& system, const std::vector<std::size_t>& rows, const Vector& f) {
  Vector result(system.l(), cln::cl_float(0, system.g(0, 0)));
  if (rows.empty()) return result;
  const Vector scales = RowScales(system)();
  Matrix all(system.l(), system.n(), system.g(0, 0)), some(rows.size(), system.n(), system.g(0, 0));
  for (std::size_t i = 0; i < system.n(); ++i) {
    for (std::size_t mu = 0; mu < system.l(); ++mu) all(mu, i) = scales[mu] * system.b(mu, i);
    for (std::size_t k = 0; k < rows.size(); ++k) some(k, i) = all(rows[k], i);
  }
  const Matrix gram = multiply(some, transposed(some)), mixed = multiply(all, transposed(some));
  Matrix combinations(system.l(), rows.size(), system.g(0, 0));
  for (std::size_t mu = 0; mu < system.l(); ++mu) {
    Vector row;
    for (std::size_t k = 0; k < rows.size(); ++k) row.push_back(mixed(mu, k));
    const auto found = evaluate::solve(gram, row);
    if (!found) return std::nullopt;
    for (std::size_t k = 0; k < rows.size(); ++k) combinations(mu, k) = (*found)[k];
  }
  const auto of_rows = evaluate::solve(gram, multiply(some, f));
  if (!of_rows) return std::nullopt;
  const auto shares = evaluate::solve(multiply(transposed(combinations), combinations), *of_rows);
  if (!shares) return std::nullopt;
  const Vector least = multiply(combinations, *shares);
  cl_F largest = cln::cl_float(0, system.g(0, 0));
  for (const cl_F& value : least) largest = cln::max(largest, cln::abs(value));
  for (std::size_t mu = 0; mu < system.l(); ++mu) result[mu] = scales[mu] * without_rounding(least[mu], largest);
  return result;
}

/// Bᵀ λ of these rows.
Vector forces_of(const System& system, const std::vector<std::size_t>& rows, const Vector& multipliers) {
  Vector f(system.n(), cln::cl_float(0, system.g(0, 0)));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < system.n(); ++i) f[i] = f[i] + system.b(rows[k], i) * multipliers[k];
  }
  return f;
}

/// Against what the equation of motion of each is made of.
void clean_accelerations(const System& system, const Vector& multipliers, Vector& a) {
  Vector sizes;
  for (std::size_t i = 0; i < system.n(); ++i) {
    cl_F size = cln::abs(system.f[i]);
    for (std::size_t j = 0; j < system.n(); ++j) size = size + cln::abs(system.g(i, j) * a[j]);
    for (std::size_t mu = 0; mu < system.l(); ++mu) size = size + cln::abs(system.b(mu, i) * multipliers[mu]);
    sizes.push_back(size);
  }
  for (std::size_t i = 0; i < system.n(); ++i) {
    if (cln::plusp(system.g(i, i))) a[i] = without_rounding(a[i], sizes[i] / system.g(i, i));
  }
}

std::vector<support::Rational> exact(const Vector& numbers) {
  std::vector<support::Rational> result;
  for (const cl_F& number : numbers) result.push_back(cln::rational(number));
  return result;
}

}  // namespace

std::optional<GeneralSolution> general_solution(Mechanics& mechanics, ModelValues& values,
                                                const std::vector<Dependence>& dependent) {
  const std::optional<System> system = system_at(mechanics, values);
  if (!system) return std::nullopt;
  const std::vector<std::size_t> rows = independent_rows(*system, dependent);
  const std::optional<Vector> basic = solution_by(*system, rows);
  if (!basic) return std::nullopt;
  const auto end = basic->begin() + static_cast<std::ptrdiff_t>(system->n());
  Vector accelerations(basic->begin(), end);
  const Vector of_rows(end, basic->end());
  const std::optional<Vector> multipliers = least_multipliers(*system, rows, forces_of(*system, rows, of_rows));
  if (!multipliers) return std::nullopt;
  clean_accelerations(*system, *multipliers, accelerations);
  return GeneralSolution{exact(accelerations), exact(*multipliers)};
}

std::optional<std::vector<support::Rational>> least_multipliers(Mechanics& mechanics, ModelValues& values,
                                                                const std::vector<Dependence>& dependent,
                                                                const std::vector<support::Rational>& multipliers) {
  const std::optional<System> system = system_at(mechanics, values);
  if (!system) return std::nullopt;
  const std::vector<std::size_t> all = independent_rows(*system, {});
  Vector given;
  for (const support::Rational& multiplier : multipliers) given.push_back(values.number(multiplier));
  const auto least = least_multipliers(*system, independent_rows(*system, dependent), forces_of(*system, all, given));
  return least ? std::optional(exact(*least)) : std::nullopt;
}

bool is_undetermined(Mechanics& mechanics, ModelValues& values, const std::vector<Dependence>& dependent) {
  const std::optional<System> system = system_at(mechanics, values);
  return system && !solution_by(*system, independent_rows(*system, dependent));
}

}  // namespace gaussgen
