#include "nearest_position.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/evaluator.hpp"
#include "evaluation.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

namespace {

using Number = evaluate::Scaled<double>;
using Values = evaluate::Evaluator<Number>;
using Vector = std::vector<double>;

constexpr int k_most_steps = 400;
constexpr int k_emitted_steps = 8;     ///< as in strategy/projection.cpp
constexpr double k_arrived = 1e-13;    ///< likewise to k_solved
constexpr double k_solved = 1e-11;     ///< f of what it is made of
constexpr double k_violated = 1e-6;    ///< likewise, of the largest among the equations, and of that at the start
constexpr double k_stationary = 1e-6;  ///< Jᵀ f of the largest f and ∂f
constexpr double k_first_step = 1e-3;
constexpr double k_most_damping = 1e12;
constexpr double k_turn = 6.283185307179586;

/// Equations f = 0 at one position.
struct Linearised {
  Vector f;               ///< times the weights
  Vector size;            ///< of what f is made of, likewise
  std::vector<Vector> j;  ///< rows ∂f/∂(displacement along the speeds), likewise

  double square() const {
    double sum = 0;
    for (const double value : f) sum += value * value;
    return sum;
  }
};

/// Levenberg's and Marquardt's method for the least Σ f².
class Search {
 public:
  /// Along the speeds that are `movable`.
  Search(Mechanics& mechanics, std::vector<bool> movable, double time)
      : mechanics_(mechanics),
        movable_(std::move(movable)),
        time_(time),
        values_(mechanics.graph, evaluate::Arithmetic<Number>(evaluate::Arithmetic<double>())) {
    for (const auto mu : mechanics.kinematics.constraints.indices()) {
      if (mechanics.kinematics.constraints[mu].f) rows_.push_back(mu);
    }
    weights_.assign(rows_.size(), 1);
  }

  std::optional<Contradiction> contradiction() {
    auto here = start_beside_guess();
    const double at_start = here ? std::sqrt(here->square()) : 0;
    here = descend(std::move(here));
    if (!here || !is_stationary(*here)) return std::nullopt;
    // What only goes slowly, as x² does, has come far.
    return std::sqrt(here->square()) > k_violated * at_start ? contradiction_at(*here) : std::nullopt;
  }

  Approach emitted() {
    auto here = start();
    for (int i = 0; here && i < k_emitted_steps; ++i) {
      move(least_in_metric(*here));
      here = linearised();
    }
    return {q_, here && is_solved(*here, k_arrived)};
  }

  Approach longest() {
    const auto here = descend(start_beside_guess());
    if (!here || !is_solved(*here)) return {q_, false};
    unwind();
    return {q_, true};
  }

  bool speeds_fit(const Vector& position, const std::vector<bool>& open) {
    if (!start()) return false;
    set(position);
    Vector u = speeds();
    auto here = of_speeds(u, open);
    for (int i = 0; here && i < k_emitted_steps; ++i) {
      const Vector change = least_change(*here);
      for (std::size_t k = 0; k < u.size(); ++k) u[k] += change[k];
      here = of_speeds(u, open);
    }
    return here && is_solved(*here);
  }

 private:
  std::optional<Linearised> descend(std::optional<Linearised> here) {
    if (here) remember_sizes(*here);
    double damping = 1e-3;
    for (int i = 0; here && i < k_most_steps && !is_solved(*here) && damping < k_most_damping; ++i) {
      const Vector from = q_;
      move(step(*here, damping));
      auto there = linearised();
      const bool is_better = there && there->square() < here->square();
      damping *= is_better ? 0.2 : 5;
      if (is_better) {
        here = std::move(there);
        remember_sizes(*here);
      } else {
        set(from);
      }
    }
    return here;
  }

  std::optional<Linearised> start() {
    bind_parameters(mechanics_, values_);
    bind(mechanics_.symbols.time, time_);
    Vector q;
    const strategy::Vector all = strategy::guessed_state(mechanics_.model, mechanics_.expressions);
    for (std::size_t i = 0; i < mechanics_.symbols.configuration.size(); ++i) {
      const auto value = values_(all[i].id());
      if (!value) return std::nullopt;
      q.push_back(value->value);
    }
    set(std::move(q));
    guess_ = q_;
    return linearised();
  }

  std::optional<Linearised> start_beside_guess() {
    if (!start()) return std::nullopt;
    leave_symmetry();
    const auto first = linearised();
    if (!first) return std::nullopt;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      double largest = 0;
      for (const double entry : first->j[i]) largest = std::max(largest, std::abs(entry));
      if (largest > 0) weights_[i] = 1 / largest;
    }
    return linearised();
  }

  /// The largest derivatives so far along each speed: where one vanishes, its unit is known all the same.
  void remember_sizes(const Linearised& at) {
    sizes_.resize(at.j[0].size(), 0);
    for (const Vector& row : at.j) {
      for (std::size_t k = 0; k < row.size(); ++k) sizes_[k] = std::max(sizes_[k], std::abs(row[k]));
    }
  }

  /// Where a derivative vanishes by symmetry, as that of x² - 1 at 0, a search does not find its way.
  void leave_symmetry() {
    Vector displacement;
    for (std::size_t i = 0; i < mechanics_.symbols.speeds.size(); ++i) {
      const bool is_plain = i < mechanics_.symbols.plain_count();
      const double size = is_plain && q_[i] != 0 ? std::abs(q_[i]) : 1;
      displacement.push_back(movable_[i] ? k_first_step * size * (1 + 0.37 * static_cast<double>(i)) : 0);
    }
    move(displacement);
  }

  void bind(ir::SymbolId symbol, double value) { values_.bind(symbol, {value, std::abs(value)}); }

  /// Quaternions become of unit length.
  void set(Vector q) {
    for (const auto first : mechanics_.symbols.first_quaternion_component) {
      double square = 0;
      for (std::size_t i = 0; i < 4; ++i) square += q[first.value + i] * q[first.value + i];
      for (std::size_t i = 0; i < 4; ++i) q[first.value + i] /= std::sqrt(square);
    }
    for (std::size_t i = 0; i < q.size(); ++i) {
      bind(mechanics_.symbols.configuration[kinematics::ConfigurationIndex{i}].symbol, q[i]);
    }
    q_ = std::move(q);
  }

  void move(const Vector& along_speeds) {
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      const auto at_rest = values_(mechanics_.kinematics.speeds_at_rest[i].id());
      bind(mechanics_.symbols.speeds[i].symbol, (at_rest ? at_rest->value : 0) + along_speeds[i.value]);
    }
    Vector q = q_;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const auto rate = values_(mechanics_.kinematics.configuration_rates[kinematics::ConfigurationIndex{i}].id());
      if (rate) q[i] += rate->value;
    }
    set(std::move(q));
  }

  std::optional<Linearised> linearised() {
    Linearised result;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const kinematics::ConstraintRow& row = mechanics_.kinematics.constraints[rows_[i]];
      const auto f = values_(row.f->id());
      if (!f || !std::isfinite(f->value)) return std::nullopt;
      result.f.push_back(weights_[i] * f->value);
      result.size.push_back(weights_[i] * f->scale);
      result.j.emplace_back();
      for (const auto alpha : mechanics_.symbols.speeds.indices()) {
        const auto entry = values_(row.beta[mechanics_.symbols.full(alpha)].id());
        if (!entry || !std::isfinite(entry->value)) return std::nullopt;
        result.j.back().push_back(movable_[alpha.value] ? weights_[i] * entry->value : 0);
      }
    }
    return result;
  }

  /// Of the guess.
  Vector speeds() {
    const strategy::Vector all = strategy::guessed_state(mechanics_.model, mechanics_.expressions);
    Vector u;
    for (std::size_t i = mechanics_.symbols.configuration.size(); i < all.size(); ++i) {
      const auto value = values_(all[i].id());
      u.push_back(value ? value->value : 0);
    }
    return u;
  }

  /// φ and ∂φ/∂u over the speeds that are `open`.
  std::optional<Linearised> of_speeds(const Vector& u, const std::vector<bool>& open) {
    for (const auto i : mechanics_.symbols.speeds.indices()) bind(mechanics_.symbols.speeds[i].symbol, u[i.value]);
    Linearised result;
    for (const kinematics::ConstraintRow& row : mechanics_.kinematics.constraints) {
      const auto phi = values_(row.phi.id());
      if (!phi || !std::isfinite(phi->value)) return std::nullopt;
      result.f.push_back(phi->value);
      result.size.push_back(phi->scale);
      result.j.emplace_back();
      for (const auto alpha : mechanics_.symbols.speeds.indices()) {
        const auto entry = values_(row.beta[mechanics_.symbols.full(alpha)].id());
        if (!entry || !std::isfinite(entry->value)) return std::nullopt;
        result.j.back().push_back(open[alpha.value] ? entry->value : 0);
      }
    }
    return result;
  }

  /// Angles by whole turns to their guesses, where that changes no equation.
  void unwind() {
    const Vector wound = q_;
    Vector q = q_;
    for (std::size_t i = 0; i < mechanics_.symbols.plain_count(); ++i) {
      const auto& variable = mechanics_.symbols.configuration[kinematics::ConfigurationIndex{i}];
      if (variable.unit == "rad" || variable.unit.empty()) q[i] = guess_[i] + std::remainder(q[i] - guess_[i], k_turn);
    }
    set(std::move(q));
    const auto here = linearised();
    if (!here || !is_solved(*here)) set(wound);
  }

  static Eigen::MatrixXd matrix(const std::vector<Vector>& rows, std::size_t columns) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.row(static_cast<Eigen::Index>(i)) =
          Eigen::VectorXd::Map(rows[i].data(), static_cast<Eigen::Index>(columns));
    return result;
  }

  Vector least_change(const Linearised& at) const {
    const std::size_t n = movable_.size();
    Vector change(n, 0);
    if (n == 0 || at.f.empty()) return change;
    const Eigen::MatrixXd j = matrix(at.j, n);
    const Eigen::VectorXd f = Eigen::VectorXd::Map(at.f.data(), static_cast<Eigen::Index>(at.f.size()));
    Eigen::VectorXd::Map(change.data(), static_cast<Eigen::Index>(n)) = -j.completeOrthogonalDecomposition().solve(f);
    return change;
  }

  /// G δ + Jᵀ λ = 0, J δ = -f.
  Vector least_in_metric(const Linearised& at) {
    const std::size_t n = movable_.size();
    if (n == 0 || at.f.empty()) return Vector(n, 0);
    const auto size = static_cast<Eigen::Index>(n);
    const auto rows = static_cast<Eigen::Index>(at.f.size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size + rows, size + rows);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) {
        const bool is_moving = movable_[a] && movable_[b];
        const auto entry = is_moving ? values_(mechanics_.dynamics.g[a][b].id()) : std::nullopt;
        all(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = entry ? entry->value : 0;
      }
    }
    const Eigen::MatrixXd j = matrix(at.j, n);
    all.bottomLeftCorner(rows, size) = j;
    all.topRightCorner(size, rows) = j.transpose();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size + rows);
    right.tail(rows) = -Eigen::VectorXd::Map(at.f.data(), rows);
    const Eigen::VectorXd solved = all.completeOrthogonalDecomposition().solve(right);
    return Vector(solved.data(), solved.data() + size);
  }

  Vector step(const Linearised& at, double damping) const {
    const auto n = static_cast<Eigen::Index>(at.j[0].size());
    const auto rows = static_cast<Eigen::Index>(at.f.size());
    Eigen::MatrixXd j(rows, n);
    for (Eigen::Index i = 0; i < rows; ++i)
      j.row(i) = Eigen::VectorXd::Map(at.j[static_cast<std::size_t>(i)].data(), n);
    Eigen::MatrixXd a = j.transpose() * j;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double size = sizes_[static_cast<std::size_t>(i)];
      a(i, i) += damping * (size > 0 ? size * size : 1.0);
    }
    const Eigen::VectorXd right = -(j.transpose() * Eigen::VectorXd::Map(at.f.data(), rows));
    Vector result(at.j[0].size());
    Eigen::VectorXd::Map(result.data(), n) = a.ldlt().solve(right);
    return result;
  }

  static bool is_solved(const Linearised& at, double part = k_solved) {
    for (std::size_t i = 0; i < at.f.size(); ++i) {
      if (std::abs(at.f[i]) > part * at.size[i]) return false;
    }
    return true;
  }

  bool is_stationary(const Linearised& at) const {
    double largest = 0;
    for (const double f : at.f) largest = std::max(largest, std::abs(f));
    for (std::size_t k = 0; k < sizes_.size(); ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < at.f.size(); ++i) sum += at.j[i][k] * at.f[i];
      if (std::abs(sum) > k_stationary * sizes_[k] * largest) return false;
    }
    return true;
  }

  std::optional<Contradiction> contradiction_at(const Linearised& at) const {
    double largest = 0;
    for (const double f : at.f) largest = std::max(largest, std::abs(f));
    Contradiction found;
    bool is_clear = false;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (std::abs(at.f[i]) <= k_violated * largest) continue;
      is_clear = is_clear || std::abs(at.f[i]) > k_violated * at.size[i];
      found.constraints.push_back(rows_[i].value);
      found.residuals.push_back(at.f[i] / weights_[i]);
    }
    return is_clear ? std::optional<Contradiction>(found) : std::nullopt;
  }

  Mechanics& mechanics_;
  std::vector<bool> movable_;
  double time_;
  Values values_;
  std::vector<kinematics::ConstraintIndex> rows_;
  Vector weights_;  ///< per row, so that all are in units of displacements
  Vector q_;
  Vector guess_;
  Vector sizes_;  ///< of derivatives along each speed
};

}  // namespace

std::optional<Contradiction> contradictory_positions(Mechanics& mechanics) {
  if (mechanics.dynamics.n() == 0) return std::nullopt;
  return Search(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), 0).contradiction();
}

Approach emitted_approach(Mechanics& mechanics, const std::vector<bool>& movable, double time) {
  return Search(mechanics, movable, time).emitted();
}

Approach long_approach(Mechanics& mechanics, const std::vector<bool>& movable, double time) {
  return Search(mechanics, movable, time).longest();
}

bool speeds_fit(Mechanics& mechanics, const std::vector<double>& position, const std::vector<bool>& open, double time) {
  return Search(mechanics, std::vector<bool>(open.size(), false), time).speeds_fit(position, open);
}

}  // namespace gaussgen
