#include "general_start.hpp"

#include <algorithm>
#include <cmath>

#include "artefact_builder.hpp"
#include "evaluate/decimal.hpp"
#include "least_step.hpp"
#include "model_values.hpp"
#include "strategy/projection.hpp"
#include "strategy/state_search.hpp"
#include "usual_rank.hpp"
#include "violation.hpp"

namespace gaussgen {

namespace {

using strategy::OpenStep;
using strategy::SearchStage;
using strategy::StateSearch;

/// Steps are in double and residuals in all digits, so each step but the first few gains ten digits.
constexpr int k_most_steps = 40;

/// From where half of the digits stay: what ought to vanish has to be rounding, or it would count as a direction.
constexpr int k_steps_to_rounding = 4;

bool any(const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); }

bool is_zero(const strategy::Vector& row) {
  return std::all_of(row.begin(), row.end(), [](ir::Expr entry) { return entry.is_zero(); });
}

/// Of the rows that a step takes.
bool are_dependent(const OpenStep& step, Mechanics& mechanics) {
  const auto rows = step.b.size() - static_cast<std::size_t>(std::count_if(step.b.begin(), step.b.end(), is_zero));
  return usual_rank(step.b, mechanics) < rows;
}

class GeneralStart {
 public:
  GeneralStart(Mechanics& mechanics, const support::Rational& time, int digits)
      : mechanics_(mechanics), values_(mechanics, time, digits) {}

  /// Nothing where steps do not arrive, or constraints are violated where they do.
  std::optional<std::vector<support::Rational>> run(const StateSearch& search) {
    for (const SearchStage& stage : search.stages) {
      if (stage.kind == SearchStage::Kind::check) continue;
      if (stage.open ? !arrives(*stage.open) : !values_.bind(bindings_of(stage.state))) return std::nullopt;
    }
    if (!violations(mechanics_, values_).empty()) return std::nullopt;
    std::vector<support::Rational> state;
    for (const ir::SymbolId symbol : symbols()) state.push_back(cln::rational(*values_(mechanics_.graph.use(symbol))));
    return state;
  }

 private:
  std::vector<ir::SymbolId> symbols() const {
    std::vector<ir::SymbolId> result;
    for (const auto& q : mechanics_.symbols.configuration) result.push_back(q.symbol);
    for (const auto& u : mechanics_.symbols.speeds) result.push_back(u.symbol);
    return result;
  }

  Bindings bindings_of(const strategy::ProjectedState& state) const {
    Bindings nodes;
    for (const ir::SymbolId symbol : symbols()) {
      const std::size_t i = nodes.size(), n_q = state.configuration.size();
      nodes.emplace_back(symbol, (i < n_q ? state.configuration[i] : state.speeds[i - n_q]).id());
    }
    return nodes;
  }

  bool arrives(const OpenStep& open) {
    const Bindings next = bindings_of(open.state);
    int left = k_most_steps;
    while (left > 0) {
      if (!find_change(open)) return false;
      const Taken taken = values_.take_step(next);
      if (taken == Taken::undefined) return false;
      left = taken == Taken::arrived ? std::min(left - 1, k_steps_to_rounding) : left - 1;
    }
    return true;  // or not: violations tell
  }

  std::optional<double> number(ir::Expr expression) {
    const auto value = values_(expression.id());
    if (!value) return std::nullopt;
    const double result = evaluate::to_double(*value);
    return std::isfinite(result) ? std::optional<double>(result) : std::nullopt;
  }

  std::optional<Eigen::MatrixXd> numbers(const strategy::Matrix& matrix) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(matrix.size()), static_cast<Eigen::Index>(matrix[0].size()));
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      for (Eigen::Index j = 0; j < result.cols(); ++j) {
        const auto value = number(matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
        if (!value) return std::nullopt;
        result(i, j) = *value;
      }
    }
    return result;
  }

  /// The symbols for accelerations stand for it.
  bool find_change(const OpenStep& open) {
    const auto g = numbers(open.g), b = numbers(open.b);
    Eigen::VectorXd f(static_cast<Eigen::Index>(open.residuals.size()));
    for (Eigen::Index mu = 0; g && b && mu < f.size(); ++mu) {
      const auto value = number(open.residuals[static_cast<std::size_t>(mu)]);
      if (!value) return false;
      f[mu] = *value;
    }
    if (!g || !b) return false;
    const double least = std::max(k_least_sine_of_step, rank_tolerance(mechanics_.model));
    const auto usual = static_cast<Eigen::Index>(usual_rank(open.b, mechanics_));
    const Eigen::VectorXd change = emitted_step(*g, *b, f, least, usual);
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      const double value = change[static_cast<Eigen::Index>(i.value)];
      if (!std::isfinite(value)) return false;
      values_.set(mechanics_.symbols.speeds[i].acceleration, evaluate::exact(value));
    }
    return true;
  }

  Mechanics& mechanics_;
  ModelValues values_;
};

bool has_open_values(Mechanics& mechanics) {
  return any(strategy::open_positions(mechanics.model, mechanics.expressions)) ||
         any(strategy::open_speeds(mechanics.model, mechanics.expressions));
}

void find(Mechanics& mechanics, const support::Rational& time, int digits, bool asks_for_dependent) {
  kinematics::Expressions& expressions = mechanics.expressions;
  const StateSearch search =
      strategy::initial_state(mechanics.model, mechanics.dynamics, expressions,
                              expressions.symbol(mechanics.symbols.time), true, mechanics.epsilon());
  const bool depend = std::any_of(search.stages.begin(), search.stages.end(), [&](const SearchStage& stage) {
    return stage.open && are_dependent(*stage.open, mechanics);
  });
  if (depend || !asks_for_dependent) mechanics.known_start = GeneralStart(mechanics, time, digits).run(search);
}

}  // namespace

void find_general_start(Mechanics& mechanics, const support::Rational& time, int digits) {
  mechanics.known_start.reset();
  if (has_general_way(mechanics) && usual_rank(mechanics) < mechanics.dynamics.l() && has_open_values(mechanics))
    find(mechanics, time, digits, true);
}

void find_start_otherwise(Mechanics& mechanics, const support::Rational& time, int digits) {
  if (!mechanics.known_start && has_general_way(mechanics) && has_open_values(mechanics))
    find(mechanics, time, digits, false);
}

bool is_start_found(Mechanics& mechanics, const support::Rational& time, int digits) {
  ModelValues values(mechanics, time, digits);
  return bind_initial_values(mechanics, initial_values(mechanics, values), values) &&
         violations(mechanics, values).empty();
}

}  // namespace gaussgen
