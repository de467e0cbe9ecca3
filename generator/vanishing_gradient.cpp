#include "vanishing_gradient.hpp"

#include <algorithm>
#include <cmath>

#include "position_equations.hpp"
#include "repeated_numbers.hpp"
#include "spans.hpp"

namespace gaussgen {

namespace {

const support::Rational k_small_gradient = support::Rational(1) / 100;

using Vector = std::vector<double>;

constexpr int k_starts = 3;
constexpr int k_steps = 12;
constexpr int k_steps_that_count = 5;
constexpr double k_away = 0.1;  ///< of a span

/// (1 - 1/m)^m for a root of order m: 1/4 of a square, towards 1/e.
constexpr double k_least_factor = 0.15;
constexpr double k_largest_factor = 0.5;

struct Row {
  double f = 0;
  Vector gradient;
};

/// One constraint as numbers, of positions or else of speeds.
class OneConstraint {
 public:
  OneConstraint(Mechanics& mechanics, std::size_t constraint)
      : mechanics_(mechanics),
        equations_(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), 0),
        constraint_(constraint) {
    std::size_t row = 0;
    for (const auto mu : mechanics.kinematics.constraints.indices()) {
      const bool is_of_positions = mechanics.kinematics.constraints[mu].f.has_value();
      if (mu.value == constraint && is_of_positions) row_ = row;
      if (is_of_positions) ++row;
    }
  }

  bool start(RepeatedNumbers& number) {
    if (!equations_.start()) return false;
    if (spans_.empty()) spans_ = spans_at(mechanics_, equations_);
    Vector away;
    for (const double span : spans_) away.push_back(k_away * span * number());
    equations_.move(away);
    speeds_ = equations_.speeds();
    for (double& speed : speeds_) speed += k_away * (speed != 0 ? std::abs(speed) : 1) * number();
    return true;
  }

  std::optional<Row> here() {
    const auto all = row_ ? equations_.linearised() : equations_.of_speeds(speeds_, equations_.movable());
    const std::size_t i = row_.value_or(constraint_);
    return all ? std::optional(Row{all->f[i], all->j[i]}) : std::nullopt;
  }

  void move(const Vector& change) {
    if (row_) return equations_.move(change);
    for (std::size_t i = 0; i < speeds_.size(); ++i) speeds_[i] += change[i];
  }

 private:
  const Mechanics& mechanics_;
  PositionEquations equations_;
  Vector spans_;
  std::size_t constraint_;
  std::optional<std::size_t> row_;  ///< among equations of positions
  Vector speeds_;
};

/// δ = -f ∇f / |∇f|²; false where there is no gradient.
bool step(OneConstraint& constraint, const Row& here) {
  double square = 0;
  for (const double entry : here.gradient) square += entry * entry;
  if (!(square > 0)) return false;
  Vector change;
  for (const double entry : here.gradient) change.push_back(-here.f / square * entry);
  constraint.move(change);
  return true;
}

/// Nothing where the search says nothing.
std::optional<bool> comes_near_by_factors(OneConstraint& constraint) {
  auto here = constraint.here();
  for (int k = 0; k < k_steps; ++k) {
    if (!here || here->f == 0) return k == 0 || !here ? std::nullopt : std::optional(false);
    const double before = std::abs(here->f);
    if (!step(constraint, *here)) return std::nullopt;
    here = constraint.here();
    if (!here) return std::nullopt;
    const double factor = std::abs(here->f) / before;
    if (k >= k_steps - k_steps_that_count && !(factor > k_least_factor && factor < k_largest_factor)) return false;
  }
  return true;
}

}  // namespace

bool vanishes_with_gradient(Mechanics& mechanics, std::size_t constraint) {
  RepeatedNumbers numbers;
  OneConstraint one(mechanics, constraint);
  int found = 0;
  for (int k = 0; k < k_starts; ++k) {
    if (!one.start(numbers)) return false;
    const auto vanishes = comes_near_by_factors(one);
    if (vanishes && !*vanishes) return false;
    found += vanishes ? 1 : 0;
  }
  return found >= 2;
}

std::optional<std::string> base_of_power(const model::Constraint& constraint, const support::Source& source) {
  const model::Ast* law = nullptr;
  if (const auto* position = std::get_if<model::PositionLaw>(&constraint.law)) law = &position->f;
  if (const auto* velocity = std::get_if<model::VelocityLaw>(&constraint.law)) law = &velocity->phi;
  // Text of copies and submodels is not that of the file.
  if (law == nullptr || !law->text.empty() || law->is_derived || law->kind != model::AstKind::power)
    return std::nullopt;
  std::string text(source.text(law->children.front().span));
  const bool is_in_brackets = text.size() > 2 && text.front() == '(' && text.back() == ')';
  return is_in_brackets ? text.substr(1, text.size() - 2) : text;
}

bool has_small_gradient(Mechanics& mechanics, ModelValues& values, std::size_t constraint) {
  const strategy::Vector& row = mechanics.dynamics.b[constraint];
  return std::all_of(row.begin(), row.end(), [&](const ir::Expr entry) {
    const auto left = values.relative_residual(entry.id());
    return left && *left <= values.number(k_small_gradient);
  });
}

std::string holds_nothing(const model::Constraint& constraint) {
  return "constraint '" + constraint.name.text + "' holds nothing: its gradient vanishes wherever it holds";
}

}  // namespace gaussgen
