#include "equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense.hpp"
#include "description.hpp"
#include "driven.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluation.hpp"
#include "model_values.hpp"
#include "rest_equations.hpp"
#include "rest_place.hpp"
#include "rest_slope.hpp"
#include "rest_step.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

using cln::cl_F;
using evaluate::Arithmetic;
using evaluate::Paired;
using evaluate::Scaled;
using ir::Expr;
using kinematics::ConfigurationIndex;
using kinematics::FreeIndex;
using support::Rational;

namespace {

constexpr int k_most_steps = 200;
constexpr int k_patience = 30;  ///< steps in which less than a tenth is won
constexpr int k_more_digits = 15;
constexpr int k_most_descents = 4;
constexpr int k_steps_of_descent = 300;
constexpr double k_rough = 1e-10;    ///< of the largest term, where double is enough
constexpr double k_solved = 1e-12;   ///< likewise, with more digits
constexpr double k_wanted = 1e-20;   ///< likewise, if it can be had: where nothing is stiff, places need it
constexpr double k_nothing = 1e-25;  ///< likewise: rounding of all digits
constexpr double k_shortest_descent = 1e-6;
constexpr double k_rounding = 1e-13;         ///< of what a derivative is made of
constexpr long k_most_short_steps = 20'000;  ///< along constraints on velocities: seconds
constexpr double k_foreseen = 0.5;           ///< of the forces before or after a step
constexpr double k_near = 1e-4;              ///< likewise: rounding of double may be in the way, and nothing else
constexpr double k_balanced = 1e-6;          ///< after the last digits, of the largest term at the start
constexpr double k_faded = 1e-3;             ///< play along a speed: no place at all
constexpr double k_flat = 1e-12;             ///< likewise: fewer digits than are shown
constexpr int k_least_digits = 17;           ///< of a start that is to satisfy its constraints
constexpr double k_rank = 1e-10;             ///< of the largest singular value
constexpr double k_largest_step = 0.5;       ///< of angles, and of lengths in units of themselves
constexpr double k_longer = 1.3;             ///< each step that is as long as it may
constexpr double k_largest_damping = 0.2;    ///< root of it, of a column of size 1
constexpr double k_most_damping = 1e8;       ///< times the usual

constexpr int k_later = 731;  ///< ms: no part of anybody's period

template <class T>
class Search {
 public:
  using Real = typename RestPlace<T>::Real;

  Search(Mechanics& mechanics, const RestEquations& rest, const Rational& time, Arithmetic<T> arithmetic)
      : mechanics_(mechanics), rest_(rest), place_(mechanics, rest, time, std::move(arithmetic)) {}

  RestPlace<T>& place() { return place_; }
  const RestPlace<T>& place() const { return place_; }

  struct Linearised {
    Eigen::MatrixXd matrix;
    std::vector<Real> residual;
    Eigen::VectorXd scale;  ///< of each row
    bool is_defined = true;

    double size(std::size_t row) const {
      return std::abs(to_double(residual[row])) / scale[static_cast<Eigen::Index>(row)];
    }
    double square() const {
      double sum = 0;
      for (std::size_t i = 0; i < residual.size(); ++i) sum += size(i) * size(i);
      return sum;
    }
    double norm() const {
      double largest = 0;
      for (std::size_t i = 0; i < residual.size(); ++i) largest = std::max(largest, size(i));
      return largest;
    }
  };

  /// Back to where the model starts.
  bool start() {
    stride_ = 1;
    return place_.start();
  }

  Linearised linearised() { return linearised(rest_.multipliers.empty() ? 0 : k_rounding); }

  /// Derivatives below this part of what they are made of are 0: of multipliers that cancel, as those of nearly parallel rows, rounding is no stiffness.
  Linearised linearised(double least_part) {
    Linearised at{{}, {}, Eigen::VectorXd::Zero(rows()), true};
    at.matrix = Eigen::MatrixXd::Zero(rows(), columns());
    for (Eigen::Index i = 0; i < rows(); ++i) {
      const std::size_t row = static_cast<std::size_t>(i);
      for (Eigen::Index j = 0; j < columns(); ++j) {
        const Expr derivative = rest_.derivatives[row][static_cast<std::size_t>(j)];
        const auto entry = place_.value_of(derivative.id());
        at.is_defined = at.is_defined && entry.has_value() && std::isfinite(to_double(*entry));
        if (entry && (least_part == 0 || std::abs(to_double(*entry)) > least_part * place_.size_of(derivative)))
          at.matrix(i, j) = to_double(*entry);
      }
      // What the sum is made of, and what a displacement by 1 changes.
      at.scale[i] = at.matrix.row(i).template lpNorm<Eigen::Infinity>();
      at.scale[i] = std::max(at.scale[i], place_.size_of(rest_.equations[row]));
      if (at.scale[i] == 0) at.scale[i] = 1;
      at.is_defined = at.is_defined && std::isfinite(at.scale[i]);
    }
    at.is_defined = find_residual(at) && at.is_defined;
    return at;
  }

  /// From here on, constraints on velocities are in no way, as where they drive the model out of its place.
  void go_anywhere() { goes_anywhere_ = true; }

  /// What remains, of the largest terms.
  double approach(double enough) {
    Linearised here = with_multipliers();
    double damping = 1, best = HUGE_VAL;
    for (int i = 0, since = 0; i < k_most_steps && here.is_defined && here.norm() > enough && !is_tired();
         ++i, ++steps_) {
      since = here.norm() < 0.9 * best ? 0 : since + 1;
      best = std::min(best, here.norm());
      if (since > k_patience || !improve(here, damping)) break;
      here = linearised();
    }
    return here.is_defined ? here.norm() : HUGE_VAL;
  }

  /// Downhill along the modes that the model has at rest, until forces of springs and weights are in balance and hold it there.
  void sink() {
    for (int i = 0; i < k_steps_of_descent && !is_tired(); ++i, ++steps_) {
      const Linearised here = linearised();
      if (!here.is_defined || here.norm() <= k_rough) return;
      const RestSlope slope(forces(here));
      if ((here.norm() <= k_near && slope.is_bottom()) || !descend(here, slope)) return;
    }
  }

  int steps() const { return steps_; }

  /// With the matrix in double, each step is good for some eight digits.
  void polish(int digits) {
    for (int done = 0; done < digits; done += 8) {
      const Linearised here = linearised();
      const Real unit = largest_residual(here);
      if (unit == place_.number(0.0)) return;
      const auto from = std::pair(place_.position(), place_.multipliers());
      place_.move(step(here).least(right_of(here, unit), k_rank), unit, is_held());
      Linearised there = here;
      if (find_residual(there)) continue;
      // Of what is left there, no digit is known: it was as good before.
      return place_.set(from.first, from.second);
    }
  }

  /// A pole looks like an equilibrium to whoever measures forces by how fast they change.
  bool is_balanced(const Eigen::VectorXd& scale_at_start) {
    const Linearised here = linearised();
    for (std::size_t i = 0; i < here.residual.size(); ++i) {
      const double size = scale_at_start[static_cast<Eigen::Index>(i)];
      if (!(std::abs(to_double(here.residual[i])) <= k_balanced * size)) return false;
    }
    return here.is_defined;
  }

  struct Play {
    double size = 0;    ///< m or rad, of 1 and the place itself
    std::string along;  ///< a speed
  };

  /// How far the last forces would still move it: far, where nothing is stiff and forces only fade. Where nothing is stiff and no force
  /// is left, as along a heading, it is where it is.
  Play play() {
    const Linearised here = linearised(0);
    const Real unit = largest_residual(here);
    if (unit == place_.number(0.0)) return {};
    const Eigen::VectorXd change = step(here).least(right_of(here, unit), std::numeric_limits<double>::min());
    Play result;
    for (std::size_t a = 0; a < mechanics_.dynamics.n(); ++a) {
      const double size = std::abs(to_double(unit) * change[static_cast<Eigen::Index>(a)]) / reach(a);
      if (size > result.size) result = {size, mechanics_.dynamics.labels[a]};
    }
    return result.size > k_faded && here.norm() <= k_nothing ? Play() : result;
  }

  /// The constraint that asks for motion most; empty if none does.
  std::string what_moves_it() {
    const Linearised here = linearised();
    double largest = k_balanced;
    std::string name;
    for (const auto& [row, constraint] : rest_.drives) {
      if (!(here.size(row) > largest)) continue;
      largest = here.size(row);
      name = mechanics_.dynamics.constraints[constraint];
    }
    return name;
  }

  /// Along the speed where most of the forces remains, of their size.
  std::string where_most_remains() {
    const Linearised here = linearised();
    const std::size_t most = most_left(here);
    const std::string unit = generalized_unit(mechanics_.symbols.speeds[FreeIndex{most}].unit);
    return fmt::format("{:.3g}{}{} along '{}' are not in balance", to_double(here.residual[most]),
                       unit.empty() ? "" : " ", unit, mechanics_.dynamics.labels[most]);
  }

  std::string where_it_fades() {
    return fmt::format("along '{}' forces fade, and do not vanish",
                       mechanics_.dynamics.labels[most_left(linearised())]);
  }

  std::string undefined_part() {
    for (const Expr equation : rest_.equations) {
      if (const auto trouble = place_.trouble(equation)) return *trouble;
    }
    return "a derivative has no value";
  }

 private:
  RestForces forces(const Linearised& here) {
    const auto n = static_cast<Eigen::Index>(mechanics_.dynamics.n());
    const Eigen::MatrixXd closing = place_.rows_of(rest_.closing);
    const Eigen::MatrixXd held = is_held() ? place_.rows_of(rest_.held) : Eigen::MatrixXd(0, n);
    RestForces forces{plain(here.residual).head(n), -here.matrix.topLeftCorner(n, n), place_.rows_of(rest_.metric),
                      Eigen::MatrixXd(closing.rows() + held.rows(), n)};
    forces.rows << closing, held;
    return forces;
  }

  /// Where this is nearer to balance, with the multipliers that balance most of the forces here: they are linear in the equations. Where rows are nearly
  /// parallel multipliers are large, and steps that are damped would rather go anywhere than come to them.
  Linearised with_multipliers() {
    const Linearised here = linearised();
    const Eigen::Index n = static_cast<Eigen::Index>(mechanics_.dynamics.n()), l = columns() - n;
    if (!here.is_defined || l == 0 || n == 0) return here;
    // In units of accelerations, and rows of length 1: where rows follow from others, the least multipliers share as those of a motion do.
    Eigen::VectorXd weights(n);
    for (Eigen::Index a = 0; a < n; ++a) {
      const double mass = place_.plain(rest_.metric[static_cast<std::size_t>(a)][static_cast<std::size_t>(a)]);
      weights[a] = mass > 0 ? 1 / std::sqrt(mass) : 1 / here.scale[a];
    }
    Eigen::MatrixXd b = weights.asDiagonal() * here.matrix.topRightCorner(n, l);
    const Eigen::VectorXd lengths = b.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).transpose();
    b = b * lengths.cwiseInverse().asDiagonal();
    const Eigen::VectorXd missing = -weights.cwiseProduct(plain(here.residual).head(n));
    Eigen::VectorXd change = Eigen::VectorXd::Zero(columns());
    change.tail(l) = b.completeOrthogonalDecomposition().solve(missing).cwiseQuotient(lengths);
    const auto from = std::pair(place_.position(), place_.multipliers());
    place_.move(change, place_.number(1.0), is_held());
    Linearised there = linearised();
    if (there.is_defined && there.square() < here.square()) return there;
    place_.set(from.first, from.second);
    return here;
  }

  /// A search that goes farther and farther along constraints finds nothing there.
  bool is_tired() const { return place_.short_steps() > k_most_short_steps; }

  /// Nowhere, and false, where nothing can be foreseen.
  bool descend(const Linearised& here, const RestSlope& slope) {
    const Eigen::Index n = static_cast<Eigen::Index>(mechanics_.dynamics.n()), l = columns() - n;
    Eigen::VectorXd longest(n);
    for (Eigen::Index a = 0; a < n; ++a) longest[a] = k_largest_step * reach(static_cast<std::size_t>(a));
    Eigen::VectorXd way(columns());
    way.head(n) = slope.downhill(longest);
    const Eigen::VectorXd force = plain(here.residual).head(n);
    if (l > 0) way.tail(l) = -here.matrix.topRightCorner(n, l).completeOrthogonalDecomposition().solve(force);
    const auto from = std::pair(place_.position(), place_.multipliers());
    for (double part = 1; part > k_shortest_descent; part /= 2) {
      place_.move(part * way, place_.number(1.0), is_held());
      Linearised there = here;
      // The more work has been done, and the less is undone at the end, the lower it is.
      if (find_residual(there) && is_foreseen(here, there, part * way) &&
          plain(there.residual).head(n).dot(way.head(n)) >= -k_foreseen * force.dot(way.head(n)))
        return true;
      place_.set(from.first, from.second);
    }
    return false;
  }

  static Eigen::VectorXd plain(const std::vector<Real>& values) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) result[static_cast<Eigen::Index>(i)] = to_double(values[i]);
    return result;
  }

  /// A pole is not crossed: beyond it forces are not those that their changes before it let expect.
  bool is_foreseen(const Linearised& here, const Linearised& there, const Eigen::VectorXd& way) const {
    const Eigen::VectorXd change = here.matrix * way;
    double missed = 0, largest = 0;
    for (std::size_t i = 0; i < here.residual.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const double before = to_double(here.residual[i]), after = to_double(there.residual[i]);
      missed = std::max(missed, std::abs(after - before - change[row]) / here.scale[row]);
      largest = std::max({largest, std::abs(before) / here.scale[row], std::abs(after) / here.scale[row]});
    }
    return missed <= k_foreseen * largest;
  }

  bool is_held() const { return !rest_.held.empty() && !goes_anywhere_; }

  Eigen::Index rows() const { return static_cast<Eigen::Index>(rest_.equations.size()); }
  Eigen::Index columns() const { return static_cast<Eigen::Index>(mechanics_.dynamics.n() + rest_.multipliers.size()); }

  std::size_t most_left(const Linearised& at) const {
    std::size_t most = 0;
    for (std::size_t a = 0; a < mechanics_.dynamics.n(); ++a) {
      if (at.size(a) > at.size(most)) most = a;
    }
    return most;
  }

  bool find_residual(Linearised& at) {
    bool is_defined = true;
    at.residual.clear();
    for (const Expr equation : rest_.equations) {
      const auto value = place_.value_of(equation.id());
      is_defined = is_defined && value.has_value() && std::isfinite(to_double(*value));
      at.residual.push_back(value.value_or(place_.number(0.0)));
    }
    return is_defined;
  }

  Real largest_residual(const Linearised& at) const {
    using std::abs;
    Real largest = place_.number(0.0);
    for (const Real& value : at.residual) {
      if (abs(value) > largest) largest = abs(value);
    }
    return largest;
  }

  Eigen::VectorXd right_of(const Linearised& at, const Real& unit) const {
    Eigen::VectorXd right(rows());
    for (Eigen::Index i = 0; i < right.size(); ++i)
      right[i] = -to_double(at.residual[static_cast<std::size_t>(i)] / unit) / at.scale[i];
    return right;
  }

  /// At the position that `at` is of.
  RestStep step(const Linearised& at) {
    const auto n = static_cast<Eigen::Index>(mechanics_.dynamics.n());
    const Eigen::MatrixXd matrix = at.scale.cwiseInverse().asDiagonal() * at.matrix;
    RestUnknowns unknowns{matrix.colwise().norm(), Eigen::VectorXd::Zero(n), Eigen::MatrixXd(0, n)};
    for (Eigen::Index a = 0; a < n; ++a)
      unknowns.masses[a] = place_.plain(rest_.metric[static_cast<std::size_t>(a)][static_cast<std::size_t>(a)]);
    if (is_held()) unknowns.held = place_.rows_of(rest_.held);
    return RestStep(matrix, unknowns);
  }

  /// Moves to where less remains; false if it finds no such place.
  bool improve(const Linearised& here, double& damping) {
    const auto from = std::pair(place_.position(), place_.multipliers());
    const RestStep step_here = step(here);
    const Eigen::VectorXd right = right_of(here, place_.number(1.0));
    const double remains = std::min(here.norm(), k_largest_damping);
    Linearised there = here;
    for (; damping <= k_most_damping; damping *= 8) {
      const Eigen::VectorXd full = step_here.damped(right, damping * remains * remains);
      place_.set(from.first, from.second);
      const double part = allowed(full);
      place_.move(part * full, place_.number(1.0), is_held());
      if (find_residual(there) && there.square() < here.square()) {
        damping = std::max(damping / 8, 1.0);
        stride_ = part < 1 ? stride_ * k_longer : 1;
        return true;
      }
      stride_ = 1;
    }
    place_.set(from.first, from.second);
    return false;
  }

  /// A step may leave the neighbourhood in which it means anything.
  double allowed(const Eigen::VectorXd& change) const {
    double largest = 0;
    for (std::size_t a = 0; a < mechanics_.dynamics.n(); ++a)
      largest = std::max(largest, std::abs(change[static_cast<Eigen::Index>(a)]) / reach(a));
    return largest > k_largest_step ? k_largest_step / largest : 1;
  }

  /// What counts as a long way along a speed. Whoever goes on and on in the same direction goes faster, unless it turns.
  double reach(std::size_t a) const {
    const kinematics::Speed& speed = mechanics_.symbols.speeds[FreeIndex{a}];
    if (speed.unit == "rad/s") return 1;
    return stride_ * (speed.is_of_length() ? 1 + std::abs(to_double(place_.position()[a])) : 1);
  }

  Mechanics& mechanics_;
  const RestEquations& rest_;
  RestPlace<T> place_;
  double stride_ = 1;  ///< of the longest steps
  int steps_ = 0;
  bool goes_anywhere_ = false;
};

/// First in double, where looking around is cheap, then with all digits from where that ends.
class Equilibration {
 public:
  Equilibration(Mechanics& mechanics, const Rational& time, int digits)
      : mechanics_(mechanics),
        rest_(mechanics),
        time_(time),
        digits_(std::max(digits, k_least_digits)),
        fine_(mechanics, rest_, time, Arithmetic<Paired>(digits_ + k_more_digits, k_more_digits)),
        rough_(mechanics, rest_, time, Arithmetic<double>()) {}

  struct Rest {
    std::vector<Rational> position, speeds, multipliers;
    bool lasts = true;
    Search<Paired>::Play play;
  };

  /// Nothing, with the reason in `why`.
  std::optional<Rest> run(std::string& why) {
    if (!fine_.start()) {
      why = "the initial position has no value";
      return std::nullopt;
    }
    const auto at_start = fine_.linearised();
    if (!at_start.is_defined) {
      why = "at rest at the initial position there is no force: " + fine_.undefined_part();
      return std::nullopt;
    }
    if (!come_near(at_start.scale, why)) return std::nullopt;
    fine_.polish(digits_ + k_more_digits);
    if (!fine_.is_balanced(at_start.scale)) {
      why = "no equilibrium was found near the initial position: towards the nearest one forces grow without bound";
      return std::nullopt;
    }
    Rest rest = found();
    rest.play = fine_.play();
    if (!(rest.play.size <= k_faded)) {
      why = fmt::format("no equilibrium was found near the initial position: along '{}' forces fade, and do not vanish",
                        rest.play.along);
      return std::nullopt;
    }
    rest.lasts = is_at_rest_later();
    return rest;
  }

 private:
  bool come_near(const Eigen::VectorXd& scale_at_start, std::string& why) {
    double left = rough_.start() ? look_around() : HUGE_VAL;
    if (!(left <= k_near) && !rest_.held.empty()) {
      rough_.go_anywhere();
      fine_.go_anywhere();
      left = rough_.start() ? look_around() : HUGE_VAL;
    }
    if (left <= k_near) {
      fine_.place().set(precise(rough_.place().position()), precise(rough_.place().multipliers()));
      if (fine_.approach(k_wanted) <= k_solved) return true;
    }
    why = why_not(left, scale_at_start);
    return false;
  }

  double look_around() {
    double left = rough_.approach(k_rough);
    // From far away: let it sink, and try again.
    for (int i = 0; i < k_most_descents && !(left <= k_near); ++i) {
      if (i == 0) rough_.start();
      rough_.sink();
      left = rough_.approach(k_rough);
    }
    return left;
  }

  std::string why_not(double left, const Eigen::VectorXd& scale_at_start) {
    const std::string none = "no equilibrium was found near the initial position: ";
    if (!std::isfinite(left)) return none + "the search ends where there is no force: " + rough_.undefined_part();
    const std::string mover = rough_.what_moves_it();
    if (!mover.empty()) {
      return fmt::format("no position was found near the initial one at which constraint '{}' lets the model rest",
                         mover);
    }
    if (rough_.is_balanced(scale_at_start)) return none + rough_.where_it_fades();
    return fmt::format("{}where the search ends, after {} steps, {}", none, rough_.steps(),
                       rough_.where_most_remains());
  }

  std::vector<cl_F> precise(const std::vector<double>& values) const {
    std::vector<cl_F> result;
    for (const double value : values) result.push_back(fine_.place().number(value));
    return result;
  }

  Rest found() {
    Rest rest;
    for (const cl_F& q : fine_.place().position()) rest.position.push_back(rounded(q, 1));
    for (const Expr speed : mechanics_.kinematics.speeds_at_rest)
      rest.speeds.push_back(rounded(fine_.place().value_of(speed.id()).value_or(fine_.place().number(0.0)), 1));
    Rational largest = 0;
    for (const cl_F& lambda : fine_.place().multipliers()) largest = cln::max(largest, cln::abs(cln::rational(lambda)));
    for (const cl_F& lambda : fine_.place().multipliers()) rest.multipliers.push_back(rounded(lambda, largest));
    return rest;
  }

  // What is left of the search beyond the digits that are asked for is no part of the answer.
  Rational rounded(const cl_F& value, const Rational& unit) const {
    if (cln::zerop(unit)) return 0;
    const Rational grid = cln::expt(Rational(10), digits_ + k_more_digits / 2) / unit;
    return cln::round1(cln::rational(value) * grid) / grid;
  }

  /// Multipliers may be others then.
  bool is_at_rest_later() {
    const std::vector<cl_F> before = fine_.place().position();
    fine_.place().set_time(time_ + Rational(k_later) / 1000);
    if (!(fine_.approach(k_solved) <= k_solved)) return false;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double moved = std::abs(to_double(fine_.place().position()[i] - before[i]));
      if (!(moved <= k_balanced * (1 + std::abs(to_double(before[i]))))) return false;
    }
    return true;
  }

  Mechanics& mechanics_;
  RestEquations rest_;
  Rational time_;
  int digits_;
  Search<Paired> fine_;
  Search<double> rough_;
};

void set_start(model::Model& model, const Equilibration::Rest& rest) {
  const std::vector<support::Rational>& position = rest.position;
  std::size_t next = 0;
  for (model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    coordinate.initial_rate = model::number(rest.speeds[next], coordinate.name.span);
    coordinate.initial = model::number(position[next++], coordinate.name.span);
    coordinate.guess.reset();
    coordinate.rate_guess.reset();
  }
  for (model::Orientation& orientation : model.orientations) {
    for (model::Ast& component : orientation.initial)
      component = model::number(position[next++], orientation.name.span);
    orientation.is_open = false;
    for (auto& component : orientation.initial_angular_velocity) component = model::number(0, orientation.name.span);
  }
}

}  // namespace

Equilibrium go_to_equilibrium(Mechanics& mechanics, model::Model& model, const Rational& time, int digits) {
  Equilibrium result;
  const auto rest = Equilibration(mechanics, time, digits).run(result.failure);
  if (!rest) {
    result.remedy = driven_coordinates(mechanics, time);
    return result;
  }
  set_start(model, *rest);
  mechanics.known_start.reset();
  if (!rest->lasts)
    result.doubts.push_back("this equilibrium is one of this instant: forces or laws in time soon move it");
  if (rest->play.size > k_flat) {
    result.doubts.push_back(
        fmt::format("nothing is stiff along '{}' at this equilibrium: where it is, is known to about {:.0e} only",
                    rest->play.along, rest->play.size));
  }
  result.multipliers = rest->multipliers;
  return result;
}

}  // namespace gaussgen
