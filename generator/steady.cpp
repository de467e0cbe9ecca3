#include "steady.hpp"

#include <algorithm>
#include <cmath>

namespace gaussgen {

using analysis::Matrix;
using analysis::Real;
using analysis::Vector;
using cln::cl_F;

namespace {

constexpr Real k_nothing = 1e-9L;
constexpr Real k_same = 1e-6L;
constexpr int k_later = 731;  ///< ms: no part of anybody's period
constexpr int k_most_steps = 200;
constexpr Real k_least_damping = 1e-3L, k_most_damping = 1e3L;
constexpr int k_closing_steps = 8;
constexpr Real k_closed = 1e-11L;
constexpr Real k_polished = 1e-30L;
constexpr Real k_effect = 1e-11L;  ///< of the largest in a row: beside it, less is rounding of double
constexpr int k_polish_steps = 8;
constexpr Real k_step = 1e-10L;  ///< what a step leaves of itself: each is good for some ten digits
constexpr Real k_largest_step = 0.5L;
constexpr Real k_rank = 1e-9L;
constexpr Real k_solved = 1e-9L;

bool is_in(const std::vector<std::size_t>& list, std::size_t i) {
  return std::find(list.begin(), list.end(), i) != list.end();
}

/// How large the effects on a rate are.
Real size_of_row(const ReducedMotion& motion, Eigen::Index i) {
  return std::max<Real>(motion.A.row(i).lpNorm<Eigen::Infinity>(), 1);
}

/// Satisfies the constraints by dependent displacements and speeds alone.
bool close(StatePoint<double>& point, const IndependentChoice& choice) {
  for (int step = 0; step < k_closing_steps; ++step) {
    const auto numbers = point.numbers();
    const auto change = numbers ? closing(*numbers, choice) : std::nullopt;
    if (!change) return false;
    const Real size = change->lpNorm<Eigen::Infinity>();
    if (size > 0) point.move(*change / size, point.number(size));
    if (size < k_closed) return true;
  }
  return false;
}

std::optional<ReducedMotion> reduced(StatePoint<double>& point, const IndependentChoice& choice) {
  const auto numbers = point.numbers();
  return numbers ? reduce(*numbers, choice) : std::nullopt;
}

/// What has to vanish in steady motion, in units of what a displacement by 1 changes.
class Equations {
 public:
  Equations(const IndependentChoice& choice, std::vector<std::size_t> cyclic, const std::set<std::size_t>& fixed)
      : cyclic_(std::move(cyclic)) {
    for (std::size_t k = 0; k < choice.all.size(); ++k) {
      if (!is_in(cyclic_, k)) rows_.push_back(k);
      if (!is_in(cyclic_, k) && fixed.count(choice.all[k]) == 0) unknowns_.push_back(k);
    }
  }

  Vector residual(const ReducedMotion& motion) const {
    Vector result(static_cast<Eigen::Index>(rows_.size()));
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(rows_[static_cast<std::size_t>(i)]);
      result[i] = motion.rates[row] / size_of_row(motion, row);
    }
    return result;
  }

  /// The least change of everything, to first order, that makes them vanish; with a damping, one that goes less far (Levenberg and
  /// Marquardt).
  Vector step(const ReducedMotion& motion, const Vector& residual, Real damping) const {
    const auto rows = static_cast<Eigen::Index>(rows_.size()), count = static_cast<Eigen::Index>(unknowns_.size());
    Vector change = Vector::Zero(motion.A.cols());
    if (count == 0) return motion.parametrised * change;
    Matrix matrix = Matrix::Zero(rows + count, count);
    matrix.topRows(rows) = analysis::part(motion.A, rows_, unknowns_);
    for (Eigen::Index i = 0; i < rows; ++i)
      matrix.row(i) /= size_of_row(motion, static_cast<Eigen::Index>(rows_[static_cast<std::size_t>(i)]));
    matrix.bottomRows(count).diagonal().setConstant(damping);
    Vector right = Vector::Zero(rows + count);
    right.head(rows) = -residual;
    Eigen::JacobiSVD<Matrix> solver(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
    solver.setThreshold(k_rank);
    const Vector least = solver.solve(right);
    for (std::size_t k = 0; k < unknowns_.size(); ++k)
      change[static_cast<Eigen::Index>(unknowns_[k])] = least[static_cast<Eigen::Index>(k)];
    return motion.parametrised * change;
  }

  const std::vector<std::size_t>& rows() const { return rows_; }

 private:
  std::vector<std::size_t> cyclic_, rows_, unknowns_;
};

/// Coordinates that are cyclic here, or nearby, where nothing is so by symmetry.
std::vector<std::size_t> cyclic_around(StatePoint<double>& point, const IndependentChoice& choice) {
  std::vector<std::size_t> cyclic;
  const auto here = reduced(point, choice);
  if (!here) return cyclic;
  cyclic = cyclic_coordinates(*here, choice);
  const auto from = point.state();
  Vector away = Vector::Zero(here->A.cols());
  for (Eigen::Index k = 0; k < away.size(); ++k) away[k] = 0.05L * std::cos(static_cast<Real>(1 + 3 * k));
  point.move(here->parametrised * away, point.number(Real(1)));
  const bool is_closed = close(point, choice);
  const auto there = is_closed ? reduced(point, choice) : std::nullopt;
  if (there) {
    for (const std::size_t k : cyclic_coordinates(*there, choice)) {
      if (!is_in(cyclic, k)) cyclic.push_back(k);
    }
  }
  point.set(from);
  return cyclic;
}

/// False where no shorter step is a better one.
bool improve(StatePoint<double>& point, const IndependentChoice& choice, const Equations& equations,
             ReducedMotion& here) {
  const auto from = point.state();
  const Vector residual = equations.residual(here);
  for (Real damping = 0; damping < k_most_damping; damping = damping == 0 ? k_least_damping : 4 * damping) {
    const Vector step = equations.step(here, residual, damping);
    const Real size = step.lpNorm<Eigen::Infinity>();
    if (!(size > 0) || !std::isfinite(size)) break;
    point.set(from);
    point.move(step, point.number(std::min<Real>(1, k_largest_step / size)));
    if (!close(point, choice)) continue;
    auto there = reduced(point, choice);
    if (!there || !(equations.residual(*there).norm() < residual.norm())) continue;
    here = *std::move(there);
    return true;
  }
  point.set(from);
  return false;
}

/// What is no larger than its own error is 0: what remains to be done would take it anywhere around that.
void leave_out(StatePoint<cl_F>& point, Real error) {
  constexpr Real k_times = 2;  // where roots coincide, a step goes half of the way
  auto state = point.state();
  for (cl_F& value : state) {
    if (std::abs(to_real(value)) <= k_times * error) value = point.number(Real(0));
  }
  point.set(std::move(state));
}

}  // namespace

std::vector<std::size_t> cyclic_coordinates(const ReducedMotion& motion, const IndependentChoice& choice) {
  std::vector<bool> coordinates;
  for (std::size_t k = 0; k < choice.all.size(); ++k) coordinates.push_back(k < choice.position_count());
  Matrix A = motion.A;
  // Beside what other displacements change, in any unit, this is rounding.
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      if (std::abs(A(i, j)) < k_effect * size_of_row(motion, i)) A(i, j) = 0;
    }
  }
  return analysis::without_effect(A, coordinates);
}

bool moves(const ReducedMotion& motion, std::size_t k) {
  const auto i = static_cast<Eigen::Index>(k);
  return std::abs(motion.rates[i]) > k_nothing * size_of_row(motion, i);
}

std::vector<std::size_t> changing(const ReducedMotion& motion, const std::vector<std::size_t>& cyclic,
                                  const IndependentChoice& choice) {
  std::vector<std::size_t> coordinates, speeds;
  Vector along = Vector::Zero(motion.A.cols());
  for (std::size_t k = 0; k < choice.all.size(); ++k) {
    const bool is_coordinate = k < choice.position_count();
    if (is_coordinate) along[static_cast<Eigen::Index>(k)] = motion.rates[static_cast<Eigen::Index>(k)];
    if (!is_in(cyclic, k) && moves(motion, k)) (is_coordinate ? coordinates : speeds).push_back(k);
  }
  // Coordinates may go on together, as those of two bodies that keep their distance, if that changes nothing.
  const Vector effect = motion.A * along;
  const Real size = along.size() == 0 ? 0 : along.lpNorm<Eigen::Infinity>();
  bool has_effect = !speeds.empty();
  for (std::size_t k = 0; k < choice.all.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    has_effect = has_effect || (!is_in(cyclic, k) && std::abs(effect[i]) > k_nothing * size_of_row(motion, i) * size);
  }
  if (!has_effect) return {};
  coordinates.insert(coordinates.end(), speeds.begin(), speeds.end());
  return coordinates;
}

bool goes_on(StatePoint<double>& point, const IndependentChoice& choice, const std::vector<std::size_t>& cyclic,
             const support::Rational& time) {
  const auto from = point.state();
  const auto here = reduced(point, choice);
  if (!here) return true;
  // Dependent ones follow from their constraints, wherever the others are.
  Vector change = Vector::Zero(here->parametrised.rows());
  for (std::size_t k = 0; k < choice.position_count(); ++k)
    change[static_cast<Eigen::Index>(choice.all[k])] = here->rates[static_cast<Eigen::Index>(k)];
  point.move(change, point.number(Real(k_later) / 1000));
  point.set_time(time + support::Rational(k_later) / 1000);
  const bool is_closed = close(point, choice);
  const auto there = is_closed ? reduced(point, choice) : std::nullopt;
  point.set_time(time);
  point.set(from);
  if (!there) return false;
  for (Eigen::Index i = 0; i < here->A.rows(); ++i) {
    if (is_in(cyclic, static_cast<std::size_t>(i))) continue;
    const Real size = size_of_row(*here, i);
    if (!(std::abs(there->rates[i] - here->rates[i]) <= k_same * size)) return false;
    if (!((there->A.row(i) - here->A.row(i)).lpNorm<Eigen::Infinity>() <= k_same * size)) return false;
  }
  return true;
}

std::string find_steady(StatePoint<double>& rough, StatePoint<cl_F>& fine, const IndependentChoice& choice,
                        const std::set<std::size_t>& fixed) {
  auto here = reduced(rough, choice);
  if (!here) return "at the initial state a value is undefined: " + rough.trouble();
  const Equations equations(choice, cyclic_around(rough, choice), fixed);
  const auto left = [&] { return equations.residual(*here).lpNorm<Eigen::Infinity>(); };
  for (int i = 0; i < k_most_steps && !equations.rows().empty() && left() > k_solved * k_solved; ++i) {
    if (!improve(rough, choice, equations, *here)) break;
  }
  if (!equations.rows().empty() && !(left() <= k_solved))
    return "no steady motion was found near the initial state: where the search ends, speeds still change";
  fine.set([&] {
    std::vector<cl_F> state;
    for (const double value : rough.state()) state.push_back(fine.number(static_cast<Real>(value)));
    return state;
  }());
  // As large as the last step; where the search is done, as the steps that it leaves out, or as what the last one leaves.
  Real error = 0;
  for (int i = 0; i < k_polish_steps; ++i) {
    const auto numbers = fine.numbers();
    const auto closed = numbers ? closing(*numbers, choice) : std::nullopt;
    const auto motion = numbers ? reduce(*numbers, choice) : std::nullopt;
    if (!closed || !motion) return "at the steady motion a value is undefined: " + fine.trouble();
    const Vector step = equations.step(*motion, equations.residual(*motion), 0) + *closed;
    const Real size = step.size() == 0 ? 0 : step.lpNorm<Eigen::Infinity>();
    const bool is_last = !(size > k_polished);
    error = is_last ? std::max(k_polished, k_step * error) : size;
    if (is_last) break;
    fine.move(step / size, fine.number(size));
  }
  leave_out(fine, error);
  return "";
}

}  // namespace gaussgen
