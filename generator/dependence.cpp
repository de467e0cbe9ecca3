#include "dependence.hpp"

#include <algorithm>
#include <functional>
#include <memory>

#include "generic_point.hpp"
#include "speed_scales.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

namespace {

using cln::cl_F;
using evaluate::Matrix;
using evaluate::Vector;
using Rows = std::vector<std::size_t>;

/// Times the root of what is left of an equation: smaller derivatives may vanish where it holds.
constexpr int k_beside_root = 100;

/// An equation of which more is left is violated.
constexpr int k_violated_digits = 8;

/// Rates that a user copied from a double satisfy a constraint.
constexpr int k_residual_digits = 13;

/// A combination of residuals that cancel to so many digits is zero; of rows that are dependent by the tolerance of ranks only, eps^(1/4) of
/// double may be left, as in gauss/constrained.hpp.
constexpr int k_combined_digits = 9;
const support::Rational k_left_of_nearly_dependent = support::Rational(12) / 100000;

/// A coefficient that is smaller, for rows and columns of like size, is rounding.
constexpr int k_coefficient_digits = 18;

Matrix selected(const Matrix& matrix, const Rows& rows) {
  Matrix result(rows.size(), matrix.columns(), matrix(0, 0));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < matrix.columns(); ++j) result(i, j) = matrix(rows[i], j);
  }
  return result;
}

/// Those that the solution does not leave out, then those that it does.
Rows in_order(const Mechanics& mechanics) {
  const auto& redundant = mechanics.solution.redundant;
  Rows order(mechanics.dynamics.l());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
    return std::find(redundant.begin(), redundant.end(), mechanics.dynamics.constraints[i]) == redundant.end();
  });
  return order;
}

using RankOfRows = std::function<std::size_t(const Rows&)>;

/// Rows that those before them in `order` give; `independent` becomes the others, in that order. As long as rows are independent, so are all
/// before the last of them: each dependent one is found by halving.
Rows dependent_rows(Rows order, const RankOfRows& rank, Rows& independent) {
  const auto are_independent = [&](std::size_t count) {
    return rank(Rows(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count))) == count;
  };
  Rows dependent;
  std::size_t known = 0;
  while (!are_independent(order.size())) {
    std::size_t below = known, above = order.size();
    while (above - below > 1) {
      const std::size_t middle = below + (above - below) / 2;
      (are_independent(middle) ? below : above) = middle;
    }
    known = below;
    dependent.push_back(order[below]);
    order.erase(order.begin() + static_cast<std::ptrdiff_t>(below));
  }
  independent = std::move(order);
  return dependent;
}

/// Speeds where inertias are 1, rows of unit length.
Matrix in_metric(Matrix rows, const Vector& inertias) {
  const cl_F zero = cln::cl_float(0, rows(0, 0));
  const Matrix& given = rows;
  const Vector scales = speed_scales(
      inertias, rows.rows(), [&](std::size_t i, std::size_t j) { return given(i, j); }, zero);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    for (std::size_t j = 0; j < rows.columns(); ++j) rows(i, j) = rows(i, j) * scales[j];
  }
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    cl_F squares = zero;
    for (std::size_t j = 0; j < rows.columns(); ++j) squares = squares + cln::square(rows(i, j));
    for (std::size_t j = 0; j < rows.columns() && cln::plusp(squares); ++j)
      rows(i, j) = rows(i, j) / cln::sqrt(squares);
  }
  return rows;
}

/// Rows of unit length of which what is across all before, the longest first, is longer than `part`: Gram and Schmidt, with more digits than can be lost.
std::size_t rank_by_angles(Matrix rows, const cl_F& part) {
  std::size_t rank = 0;
  for (; rank < rows.rows(); ++rank) {
    std::size_t longest = rank;
    std::vector<cl_F> squares(rows.rows(), cln::cl_float(0, part));
    for (std::size_t i = rank; i < rows.rows(); ++i) {
      for (std::size_t j = 0; j < rows.columns(); ++j) squares[i] = squares[i] + cln::square(rows(i, j));
      if (squares[i] > squares[longest]) longest = i;
    }
    if (squares[longest] <= cln::square(part)) break;
    for (std::size_t j = 0; j < rows.columns(); ++j) std::swap(rows(rank, j), rows(longest, j));
    for (std::size_t i = rank + 1; i < rows.rows(); ++i) {
      cl_F along = cln::cl_float(0, part);
      for (std::size_t j = 0; j < rows.columns(); ++j) along = along + rows(i, j) * rows(rank, j);
      for (std::size_t j = 0; j < rows.columns(); ++j)
        rows(i, j) = rows(i, j) - along / squares[longest] * rows(rank, j);
    }
  }
  return rank;
}

std::optional<Vector> inertias_at(Mechanics& mechanics, ModelValues& values) {
  Vector result;
  for (const ir::Expr inertia : strategy::inertias(mechanics.dynamics)) {
    const std::optional<cl_F> value = values(inertia.id());
    if (!value) return std::nullopt;
    result.push_back(*value);
  }
  return result;
}

/// Of rows wherever the mechanism may be: on its equations of positions, where it has some.
RankOfRows rank_everywhere(Mechanics& mechanics, const ModelValues& values) {
  if (!mechanics.kinematics.has_positions()) {
    GenericPoint point(mechanics);
    const Matrix inertias = point({strategy::inertias(mechanics.dynamics)});
    Vector diagonal;
    for (std::size_t j = 0; j < inertias.columns(); ++j) diagonal.push_back(inertias(0, j));
    const auto at_point = std::make_shared<const Matrix>(in_metric(point(mechanics.dynamics.b), diagonal));
    const cl_F part = values.number(support::Rational(cln::rational(rank_tolerance(mechanics.model))));
    return [at_point, part](const Rows& rows) { return rank_by_angles(selected(*at_point, rows), part); };
  }
  return [&mechanics](const Rows& rows) {
    strategy::Matrix some;
    for (const std::size_t row : rows) some.push_back(mechanics.dynamics.b[row]);
    return rank_to(rank_tolerance(mechanics.model), some, mechanics);
  };
}

cl_F power_of_ten(int digits, const cl_F& like) {
  return cln::cl_float(cln::expt(support::Rational(10), digits), like);
}

/// Σ coefficients[i] b_rows[i] = 0, with no row in it that could be left out; the dependent one comes last.
struct Combination {
  Rows rows;
  Vector coefficients;

  /// Whether Σ c_μ x_μ is zero, up to a small part of what is in it.
  bool cancels(const Vector& x, const cl_F& most) const {
    cl_F sum = cln::cl_float(0, x[0]);
    cl_F size = sum;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const cl_F part = coefficients[i] * x[i];
      sum = sum + part;
      size = size + cln::abs(part);
    }
    return cln::abs(sum) <= most * size;
  }
};

/// One over the largest entry, so that rows in different units are of like size.
cl_F weight(const Matrix& matrix, std::size_t row) {
  cl_F largest = cln::cl_float(0, matrix(0, 0));
  for (std::size_t j = 0; j < matrix.columns(); ++j) largest = cln::max(largest, cln::abs(matrix(row, j)));
  return cln::zerop(largest) ? cln::cl_float(1, largest) : cln::recip(largest);
}

/// c with R Rᵀ c = R b for independent rows R: where b is a combination of them, that one.
std::optional<Vector> coefficients_of(const Matrix& r, const Vector& b) {
  return r.rows() == 0 ? Vector{}
                       : evaluate::solve(evaluate::multiply(r, evaluate::transposed(r)), evaluate::multiply(r, b));
}

Combination combination(const Matrix& matrix, const Rows& independent, std::size_t dependent) {
  Matrix r = selected(matrix, independent);
  Vector b;
  const cl_F last = weight(matrix, dependent);
  for (std::size_t j = 0; j < matrix.columns(); ++j) {
    for (std::size_t i = 0; i < r.rows(); ++i) r(i, j) = weight(matrix, independent[i]) * matrix(independent[i], j);
    b.push_back(last * matrix(dependent, j));
  }
  const std::optional<Vector> c = coefficients_of(r, b);
  Combination found;
  for (std::size_t i = 0; c && i < independent.size(); ++i) {
    if (cln::abs((*c)[i]) * power_of_ten(k_coefficient_digits, last) < cln::cl_float(1, last)) continue;
    found.rows.push_back(independent[i]);
    found.coefficients.push_back(-(*c)[i] * weight(matrix, independent[i]));
  }
  found.rows.push_back(dependent);
  found.coefficients.push_back(last);
  return found;
}

/// Of rows of unit length: how far the dependent one is from what the others span.
cl_F distance(const Matrix& unit, const Rows& independent, std::size_t dependent) {
  const Matrix r = selected(unit, independent);
  Vector b;
  for (std::size_t j = 0; j < unit.columns(); ++j) b.push_back(unit(dependent, j));
  const std::optional<Vector> c = coefficients_of(r, b);
  cl_F square = cln::cl_float(0, unit(0, 0));
  for (std::size_t j = 0; j < unit.columns(); ++j) {
    cl_F left = b[j];
    for (std::size_t i = 0; c && i < independent.size(); ++i) left = left - (*c)[i] * r(i, j);
    square = square + cln::square(left);
  }
  return cln::sqrt(square);
}

/// Without those that the dependent row is as near to the others without: what has a part as small as the tolerance is no reason.
Rows that_matter(const Matrix& unit, Rows independent, std::size_t dependent, const cl_F& tolerance) {
  const Matrix r = selected(unit, independent);
  Vector b;
  for (std::size_t j = 0; j < unit.columns(); ++j) b.push_back(unit(dependent, j));
  const std::optional<Vector> c = coefficients_of(r, b);
  if (!c) return independent;
  std::vector<std::size_t> by_size(independent.size());
  for (std::size_t i = 0; i < by_size.size(); ++i) by_size[i] = i;
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t i, std::size_t k) { return cln::abs((*c)[i]) < cln::abs((*c)[k]); });
  const auto without = [&](std::size_t count) {
    std::vector<bool> is_left(independent.size(), true);
    for (std::size_t i = 0; i < count; ++i) is_left[by_size[i]] = false;
    Rows left;
    for (std::size_t i = 0; i < independent.size(); ++i) {
      if (is_left[i]) left.push_back(independent[i]);
    }
    return left;
  };
  std::size_t fit = 0, too_many = independent.size() + 1;
  while (too_many - fit > 1) {
    const std::size_t middle = fit + (too_many - fit) / 2;
    (distance(unit, without(middle), dependent) <= tolerance ? fit : too_many) = middle;
  }
  return without(fit);
}

/// Of an undefined node it is not known that it is not zero.
cl_F residual(ModelValues& values, ir::Expr node) {
  return values.residual(node.id(), k_residual_digits).value_or(values.number(support::Rational(0)));
}

Agreement agreement_of(const Combination& combination, bool is_exact, const Mechanics& mechanics, ModelValues& values) {
  const auto& constraints = mechanics.kinematics.constraints;
  Vector velocities;
  Vector accelerations;
  bool is_linear = true;
  bool is_satisfied = true;
  for (const std::size_t row : combination.rows) {
    const kinematics::ConstraintRow& constraint = constraints[kinematics::ConstraintIndex{row}];
    velocities.push_back(residual(values, constraint.phi));
    accelerations.push_back(residual(values, mechanics.dynamics.b_drift[row]));
    is_linear = is_linear && constraint.is_linear;
    is_satisfied = is_satisfied && cln::zerop(velocities.back());
  }
  const cl_F part =
      is_exact ? power_of_ten(-k_combined_digits, velocities.front()) : values.number(k_left_of_nearly_dependent);
  if (is_linear && !combination.cancels(velocities, part)) return Agreement::contradictory_velocities;
  const bool agree = !is_satisfied || combination.cancels(accelerations, part);
  return agree ? Agreement::agree : Agreement::contradictory_accelerations;
}

/// Rows that are dependent up to this part are taken as dependent. Where a position misses its equations, a search may have come near one
/// at which they are dependent and not into it, as where two roots are one: unless derivatives are larger than the root of what is
/// left by far, nobody can tell (Kantorovich's condition). One that is violated is another matter.
cl_F part_of_rank(const Mechanics& mechanics, ModelValues& values) {
  cl_F part = values.least_part();
  const cl_F violated = values.number(cln::expt(support::Rational(10), -k_violated_digits));
  for (const kinematics::ConstraintRow& row : mechanics.kinematics.constraints) {
    const auto left = row.f ? values.relative_residual(row.f->id()) : std::nullopt;
    if (left && cln::plusp(*left) && *left < violated)
      part = cln::max(part, values.number(support::Rational(k_beside_root)) * cln::sqrt(*left));
  }
  return part;
}

}  // namespace

std::vector<Dependence> dependences(Mechanics& mechanics, ModelValues& values) {
  if (mechanics.dynamics.l() == 0 || mechanics.dynamics.n() == 0) return {};
  const auto here = values(mechanics.dynamics.b);
  if (!here) return {};
  const Rows order = in_order(mechanics);
  const cl_F part_of_exact = part_of_rank(mechanics, values);
  const auto exact_rank = [&](const Rows& rows) { return values.rank(selected(*here, rows), part_of_exact); };
  Rows independent;
  const Rows exactly = dependent_rows(order, exact_rank, independent);
  const auto inertias = inertias_at(mechanics, values);
  if (!inertias) return {};
  const Matrix seen = in_metric(*here, *inertias);
  const cl_F tolerance = values.number(cln::rational(rank_tolerance(mechanics.model)));
  const Rows dependent = dependent_rows(
      order,
      [&](const Rows& rows) { return std::min(exact_rank(rows), rank_by_angles(selected(seen, rows), tolerance)); },
      independent);
  std::vector<Dependence> result;
  for (const std::size_t row : dependent) {
    const bool is_exact = std::find(exactly.begin(), exactly.end(), row) != exactly.end();
    Combination found =
        combination(*here, is_exact ? independent : that_matter(seen, independent, row, tolerance), row);
    const Agreement agreement = agreement_of(found, is_exact, mechanics, values);
    found.rows.pop_back();
    result.push_back({row, std::move(found.rows), false, false, agreement, is_exact});
  }
  if (result.empty()) return result;
  const Rows everywhere = dependent_rows(order, rank_everywhere(mechanics, values), independent);
  for (Dependence& found : result) {
    const bool is_there = std::find(everywhere.begin(), everywhere.end(), found.index) != everywhere.end();
    found.everywhere = is_there || everywhere.size() == result.size();
    found.by_another = found.everywhere && !is_there;
  }
  return result;
}

std::string names_of(const Mechanics& mechanics, const std::vector<std::size_t>& constraints) {
  std::string text = constraints.size() == 1 ? "constraint " : "constraints ";
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    text += i == 0 ? "" : i + 1 == constraints.size() ? " and " : ", ";
    text += "'" + mechanics.dynamics.constraints[constraints[i]] + "'";
  }
  return text;
}

std::string dependence_in(const Mechanics& mechanics, const std::vector<std::size_t>& constraints,
                          const std::vector<std::size_t>& others) {
  const bool is_one = constraints.size() == 1;
  const std::string names = names_of(mechanics, constraints);
  if (others.empty()) return names + (is_one ? " limits no free speed" : " limit no free speed");
  return names + (is_one ? " follows from " : " follow from ") + names_of(mechanics, others);
}

std::string dependence_in(const Mechanics& mechanics, const Dependence& found) {
  return dependence_in(mechanics, {found.index}, found.others);
}

std::string contradiction_in(const Mechanics& mechanics, const Dependence& found) {
  if (found.agreement == Agreement::agree) return {};
  std::vector<std::size_t> all = found.others;
  all.push_back(found.index);
  const bool is_of_velocities = found.agreement == Agreement::contradictory_velocities;
  return (is_of_velocities ? "no velocities satisfy " : "no accelerations satisfy ") + names_of(mechanics, all) +
         (all.size() == 1 ? "" : " together");
}

}  // namespace gaussgen
