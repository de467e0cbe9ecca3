#include "nearest_position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "artefact_builder.hpp"
#include "double_root.hpp"
#include "eigen_lists.hpp"
#include "least_step.hpp"
#include "position_equations.hpp"
#include "spans.hpp"
#include "strategy/state_search.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

namespace {

using Vector = std::vector<double>;

constexpr int k_most_damped_steps = 400;
constexpr int k_most_steps = 30;
constexpr double k_arrived = 1e-13;  ///< of an approach with the emitted code's steps: f of what it is made of
constexpr double k_same_place = 1e-12;
constexpr double k_solved = 1e-13;     ///< f of what it is made of: violations are told by as many digits
constexpr double k_fits = 1e-11;       ///< likewise of speeds
constexpr double k_rounding = 1e-15;   ///< likewise, where a descent ends
constexpr double k_unmet = 1e-6;       ///< likewise, of speeds that cannot be found
constexpr double k_takes_part = 1e-6;  ///< f of the largest f
constexpr double k_come_far = 1e-13;   ///< of all f at the start
constexpr double k_stationary =
    1e-4;  ///< Jᵀ f of the largest f and ∂f; where f changes by squares, a descent ends half of the digits before
constexpr double k_noise = 1e-14;  ///< f of what it is made of, in that sum
constexpr double k_most_damping = 1e12;
constexpr double k_turned_back = 1e-9;  ///< f of what it is made of, before steps to what is near
constexpr double k_near = 1e-3;         ///< of a span
constexpr double k_part = 1e-9;         ///< of the largest: less is rounding

/// J δ = -f, with the least |δ|.
Vector least_change(const Linearised& at, std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  return unmapped(least_step(Eigen::MatrixXd::Identity(size, size), matrix_of(at.j, n), mapped(at.f)));
}

/// J δ = -f, with the least δ in these spans. Rounding of f, divided by the least sine of a row that is taken, is less than that sine.
Vector least_change(const Linearised& at, const Vector& spans) {
  const Eigen::VectorXd weights = mapped(spans).cwiseAbs2().cwiseInverse();
  return unmapped(least_step(weights.asDiagonal(), matrix_of(at.j, spans.size()), mapped(at.f),
                             k_least_sine_of_step * std::sqrt(at.amplification(spans))));
}

/// How many of the equations of positions say something of their own along what moves.
Eigen::Index usual_rank_along(const std::vector<bool>& movable, Mechanics& mechanics) {
  strategy::Matrix rows;
  for (const auto mu : mechanics.kinematics.constraints.indices()) {
    if (!mechanics.kinematics.constraints[mu].f) continue;
    rows.push_back(mechanics.dynamics.b[mu.value]);
    for (std::size_t i = 0; i < movable.size(); ++i) {
      if (!movable[i]) rows.back()[i] = mechanics.expressions.number(0);
    }
  }
  return static_cast<Eigen::Index>(usual_rank(rows, mechanics));
}

/// The steps of emitted code, each with the least δᵀ G δ.
class EmittedSteps {
 public:
  EmittedSteps(Mechanics& mechanics, const std::vector<bool>& movable, double time)
      : mechanics_(mechanics),
        equations_(mechanics, movable, time),
        rank_(has_general_way(mechanics) ? usual_rank_along(movable, mechanics)
                                         : std::numeric_limits<Eigen::Index>::max()),
        least_sine_(std::max(k_least_sine_of_step, rank_tolerance(mechanics.model))) {}

  Approach run(Eigen::Index preferred) {
    auto here = equations_.start() ? equations_.linearised() : std::nullopt;
    for (int i = 0; here && i < strategy::k_steps_to_start; ++i) {
      const std::size_t n = equations_.movable().size();
      equations_.move(unmapped(emitted_step(matrix_of(equations_.metric(), n), matrix_of(here->j, n), mapped(here->f),
                                            least_sine_, rank_, preferred)));
      here = equations_.linearised();
    }
    return {equations_.position(), here && here->is_solved(k_arrived)};
  }

  Vector spans() { return spans_at(mechanics_, equations_); }

  /// Those that may be first; one where no equation follows from others.
  Eigen::Index choices() {
    const auto here = equations_.linearised();
    const auto count = here ? static_cast<Eigen::Index>(here->f.size()) : 0;
    return count > rank_ ? count : 1;
  }

 private:
  const Mechanics& mechanics_;
  PositionEquations equations_;
  Eigen::Index rank_;
  double least_sine_;
};

/// Up to a small part of the largest coordinate or span of their unit; of 1 where that is an angle.
bool are_same(const Vector& a, const Vector& b, const Vector& spans, const Mechanics& mechanics) {
  std::map<std::string, double> sizes{{"rad", 1}, {"", 1}};
  const auto& all = mechanics.symbols.configuration;
  for (const auto i : all.indices()) {
    const double span = i.value < mechanics.symbols.plain_count() ? spans[i.value] : 0;
    sizes[all[i].unit] = std::max({sizes[all[i].unit], std::abs(a[i.value]), span});
  }
  for (const auto i : all.indices()) {
    if (!(std::abs(a[i.value] - b[i.value]) <= k_same_place * sizes[all[i].unit])) return false;
  }
  return true;
}

/// Levenberg's and Marquardt's method for the least Σ f², from beside the guess.
class Descent {
 public:
  explicit Descent(PositionEquations& equations) : equations_(equations) {}

  /// As far as it gets; nothing where the start has no value.
  std::optional<Linearised> run() {
    auto here = equations_.linearised();
    if (!here || here->j.empty()) return here;
    remember_sizes(*here);
    double damping = 1e-3;
    for (int i = 0; i < k_most_damped_steps && !here->is_solved(k_rounding) && damping < k_most_damping; ++i) {
      const Vector from = equations_.position();
      equations_.move(step(*here, damping));
      auto there = equations_.linearised();
      const bool is_better = there && there->square() < here->square();
      damping *= is_better ? 0.2 : 5;
      if (is_better) {
        here = std::move(there);
        remember_sizes(*here);
      } else {
        equations_.set(from);
      }
    }
    return here;
  }

  bool is_stationary(const Linearised& at) const {
    const double most =
        k_stationary * mapped(at.f).lpNorm<Eigen::Infinity>() + k_noise * mapped(at.size).lpNorm<Eigen::Infinity>();
    const Eigen::VectorXd slope = matrix_of(at.j, sizes_.size()).transpose() * mapped(at.f);
    for (std::size_t k = 0; k < sizes_.size(); ++k) {
      if (std::abs(slope[static_cast<Eigen::Index>(k)]) > sizes_[k] * most) return false;
    }
    return true;
  }

 private:
  /// The largest derivatives so far along each speed: where one vanishes, its unit is known all the same.
  void remember_sizes(const Linearised& at) {
    sizes_.resize(at.j[0].size(), 0);
    for (const Vector& row : at.j) {
      for (std::size_t k = 0; k < row.size(); ++k) sizes_[k] = std::max(sizes_[k], std::abs(row[k]));
    }
  }

  Vector step(const Linearised& at, double damping) const {
    const Eigen::MatrixXd j = matrix_of(at.j, sizes_.size());
    Eigen::MatrixXd a = j.transpose() * j;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      const double size = sizes_[static_cast<std::size_t>(i)];
      a(i, i) += damping * (size > 0 ? size * size : 1.0);
    }
    const Eigen::VectorXd right = -(j.transpose() * mapped(at.f));
    return unmapped(a.ldlt().solve(right));
  }

  PositionEquations& equations_;
  Vector sizes_;
};

Eigen::MatrixXd columns_of(const Eigen::MatrixXd& matrix, const std::vector<bool>& chosen, bool value) {
  Eigen::MatrixXd result(matrix.rows(), std::count(chosen.begin(), chosen.end(), value));
  Eigen::Index next = 0;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (chosen[k] == value) result.col(next++) = matrix.col(static_cast<Eigen::Index>(k));
  }
  return result;
}

/// Rows of combinations of equations that no open unknown has a part in.
Eigen::MatrixXd without_open(const Eigen::MatrixXd& open) {
  if (open.cols() == 0) return Eigen::MatrixXd::Identity(open.rows(), open.rows());
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(open, Eigen::ComputeFullU);
  svd.setThreshold(k_part);
  return svd.matrixU().rightCols(open.rows() - svd.rank()).transpose();
}

/// Unknowns that are not open and in which the least change is not zero, each in the size in which it matters.
std::vector<bool> needed(const Linearised& at, const std::vector<bool>& open) {
  std::vector<bool> result(open.size(), false);
  Eigen::MatrixXd j = matrix_of(at.j, open.size());
  Eigen::VectorXd f = mapped(at.f);
  const Eigen::VectorXd rows = j.rowwise().lpNorm<Eigen::Infinity>().cwiseMax(std::numeric_limits<double>::min());
  j = rows.cwiseInverse().asDiagonal() * j;
  f = f.cwiseQuotient(rows);
  const Eigen::MatrixXd combined = without_open(columns_of(j, open, true));
  Eigen::MatrixXd given = combined * columns_of(j, open, false);
  const Eigen::VectorXd sizes = given.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).transpose();
  given = given * sizes.cwiseInverse().asDiagonal();
  if (given.size() == 0) return result;
  const Eigen::VectorXd change = given.completeOrthogonalDecomposition().solve(combined * f);
  const double largest = change.lpNorm<Eigen::Infinity>();
  Eigen::Index next = 0;
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (!open[k]) result[k] = std::abs(change[next++]) > k_part * largest;
  }
  return result;
}

bool start_beside_guess(const Mechanics& mechanics, PositionEquations& equations) {
  if (!equations.start()) return false;
  equations.leave_symmetry(spans_at(mechanics, equations));
  equations.weigh();
  return true;
}

std::optional<Contradiction> contradiction_at(const Linearised& at, const PositionEquations& equations) {
  const double largest = mapped(at.f).lpNorm<Eigen::Infinity>();
  Contradiction found;
  bool is_clear = false;
  for (std::size_t i = 0; i < at.f.size(); ++i) {
    if (std::abs(at.f[i]) <= k_takes_part * largest) continue;
    is_clear = is_clear || std::abs(at.f[i]) > k_solved * at.size[i];
    found.constraints.push_back(equations.constraint(i));
    found.residuals.push_back(at.f[i] / equations.weight(i));
  }
  return is_clear ? std::optional<Contradiction>(found) : std::nullopt;
}

}  // namespace

std::optional<Contradiction> contradictory_positions(Mechanics& mechanics) {
  if (mechanics.dynamics.n() == 0) return std::nullopt;
  PositionEquations equations(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), 0);
  const auto first = start_beside_guess(mechanics, equations) ? equations.linearised() : std::nullopt;
  if (!first) return std::nullopt;
  Descent descent(equations);
  const auto last = descent.run();
  if (!descent.is_stationary(*last)) return std::nullopt;
  // What only goes slowly, as x² does, has come far.
  const bool is_far = std::sqrt(last->square()) > k_come_far * std::sqrt(first->square());
  return is_far ? contradiction_at(*last, equations) : std::nullopt;
}

Approach emitted_approach(Mechanics& mechanics, const std::vector<bool>& movable, double time) {
  EmittedSteps steps(mechanics, movable, time);
  Approach found = steps.run(0);
  const Eigen::Index choices = found.is_solved ? steps.choices() : 1;
  const Vector spans = choices > 1 ? steps.spans() : Vector();
  for (Eigen::Index k = 1; k < choices && found.is_solved && found.is_settled; ++k) {
    const Approach other = steps.run(k);
    found.is_settled = other.is_solved && are_same(found.position, other.position, spans, mechanics);
  }
  return found;
}

namespace {

/// With what the spans make of an equation among what it is made of, if `is_measured`.
std::optional<Linearised> linearised_in(const Vector& spans, bool is_measured, PositionEquations& equations) {
  auto here = equations.linearised();
  if (here && is_measured) here->measure_by(spans);
  return here;
}

}  // namespace

bool nearest_solution(PositionEquations& equations, const Vector& spans, double part, bool is_measured) {
  auto here = linearised_in(spans, is_measured, equations);
  for (int i = 0; here && !here->is_solved(part) && i < k_most_steps; ++i) {
    equations.move(least_change(*here, spans));
    here = linearised_in(spans, is_measured, equations);
  }
  return here && here->is_solved(part);
}

void polish(PositionEquations& equations, const Vector& spans, bool is_measured) {
  auto here = linearised_in(spans, is_measured, equations);
  for (int i = 0; here && i < k_most_steps; ++i) {
    const Vector before = equations.position();
    equations.move(least_change(*here, spans));
    auto there = linearised_in(spans, is_measured, equations);
    if (!there || there->left() >= here->left()) return equations.set(before);
    here = std::move(there);
  }
}

namespace {

/// Angles by whole turns to their guesses: all together, since those of a gear go together, else each that can alone. True if any has moved. An angle of many turns
/// was less exact than one of none is.
bool unwind(PositionEquations& equations, std::size_t count) {
  const auto is_there = [&] {
    const auto here = equations.linearised();
    return here && here->is_solved(k_turned_back);
  };
  const Vector wound = equations.position();
  bool has_moved = false;
  for (std::size_t i = 0; i < count; ++i) has_moved = equations.unwind(i) || has_moved;
  if (!has_moved || is_there()) return has_moved;
  equations.set(wound);
  has_moved = false;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector before = equations.position();
    if (!equations.unwind(i)) continue;
    if (is_there()) {
      has_moved = true;
    } else {
      equations.set(before);
    }
  }
  return has_moved;
}

}  // namespace

bool is_held_from(Mechanics& mechanics, const std::vector<bool>& movable, const Vector& position, double time) {
  const Approach reached = emitted_approach(mechanics, movable, time);
  PositionEquations equations(mechanics, movable, time);
  if (!reached.is_solved || !reached.is_settled || !equations.start()) return false;
  const Vector guess = equations.position();
  equations.set(position);
  const Vector spans = spans_at(mechanics, equations);
  for (std::size_t i = 0; i < mechanics.symbols.plain_count(); ++i) {
    const double off = std::max(std::abs(reached.position[i] - position[i]), std::abs(guess[i] - position[i]));
    if (!(off <= k_near * spans[i])) return false;
  }
  return true;
}

std::optional<Vector> less_whole_turns(Mechanics& mechanics, const Vector& position, double time) {
  PositionEquations equations(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), time);
  const std::size_t count = mechanics.symbols.plain_count();
  if (!equations.start()) return std::nullopt;
  equations.set(position);
  if (!unwind(equations, count)) return std::nullopt;
  polish(equations, spans_at(mechanics, equations));
  return equations.position();
}

Approach long_approach(Mechanics& mechanics, const std::vector<bool>& movable, double time) {
  PositionEquations equations(mechanics, movable, time);
  if (!start_beside_guess(mechanics, equations)) return {equations.position(), false};
  const auto reached = Descent(equations).run();
  if (!reached || !reached->is_solved(k_solved)) return {equations.position(), false};
  if (unwind(equations, mechanics.symbols.plain_count())) polish(equations, spans_at(mechanics, equations));
  go_to_double_root(equations, spans_at(mechanics, equations), mechanics.symbols.plain_count());
  return {equations.position(), true};
}

namespace {

/// By Newton's method, from their guesses.
std::optional<Linearised> at_found_speeds(Mechanics& mechanics, const Vector& position, const std::vector<bool>& open,
                                          double time) {
  PositionEquations equations(mechanics, std::vector<bool>(open.size(), false), time);
  if (!equations.start()) return std::nullopt;
  equations.set(position);
  Vector u = equations.speeds();
  auto here = equations.of_speeds(u, open);
  for (int i = 0; here && i < strategy::k_steps_to_start; ++i) {
    const Vector change = least_change(*here, u.size()), sizes = here->size;
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += change[k];
    here = equations.of_speeds(u, open);
    // A speed that has to be 0 is so up to rounding of what it was.
    for (std::size_t mu = 0; here && mu < sizes.size(); ++mu) here->size[mu] = std::max(here->size[mu], sizes[mu]);
  }
  return here;
}

}  // namespace

bool speeds_fit(Mechanics& mechanics, const std::vector<double>& position, const std::vector<bool>& open, double time) {
  const auto found = at_found_speeds(mechanics, position, open, time);
  return found && found->is_solved(k_fits);
}

std::vector<std::pair<std::size_t, double>> unmet_by_speeds(Mechanics& mechanics, const std::vector<double>& position,
                                                            const std::vector<bool>& open, double time) {
  const auto found = at_found_speeds(mechanics, position, open, time);
  std::vector<std::pair<std::size_t, double>> unmet;
  for (std::size_t mu = 0; found && mu < found->f.size(); ++mu) {
    if (std::abs(found->f[mu]) > k_unmet * found->size[mu]) unmet.emplace_back(mu, found->f[mu]);
  }
  return unmet;
}

std::vector<bool> needed_displacements(Mechanics& mechanics, const std::vector<bool>& open, double time) {
  PositionEquations equations(mechanics, std::vector<bool>(open.size(), true), time);
  const auto here = equations.start() ? equations.linearised() : std::nullopt;
  return here && !here->f.empty() ? needed(*here, open) : std::vector<bool>(open.size(), false);
}

std::vector<bool> needed_changes(Mechanics& mechanics, const std::vector<double>& position,
                                 const std::vector<bool>& open, double time) {
  PositionEquations equations(mechanics, std::vector<bool>(open.size(), true), time);
  if (!equations.start()) return std::vector<bool>(open.size(), false);
  equations.set(position);
  const auto here = equations.of_speeds(equations.speeds(), std::vector<bool>(open.size(), true));
  return here && !here->f.empty() ? needed(*here, open) : std::vector<bool>(open.size(), false);
}

}  // namespace gaussgen
