#include "nonholonomic/partition.hpp"

#include <algorithm>
#include <cmath>

#include "nonholonomic/initial_state.hpp"

namespace gaussgen::nonholonomic {

namespace {

using Choice = std::vector<FreeIndex>;

/// All sets of l free indices, in lexical order.
std::vector<Choice> choices(std::size_t n, std::size_t l) {
  std::vector<bool> taken(n, false);
  std::fill_n(taken.begin(), l, true);
  std::vector<Choice> result;
  do {
    Choice choice;
    for (std::size_t i = 0; i < n; ++i) {
      if (taken[i]) choice.push_back(FreeIndex{i});
    }
    result.push_back(std::move(choice));
  } while (std::prev_permutation(taken.begin(), taken.end()));
  return result;
}

/// A number or a product of powers of parameters: zero only where the model makes no sense.
bool cannot_vanish(const ex& f, const GiNaC::exset& parameters) {
  if (GiNaC::is_a<GiNaC::numeric>(f)) return !f.is_zero();
  if (GiNaC::is_a<GiNaC::symbol>(f)) return parameters.count(f) > 0;
  if (GiNaC::is_a<GiNaC::power>(f)) return cannot_vanish(f.op(0), parameters);
  if (!GiNaC::is_a<GiNaC::mul>(f)) return false;
  return std::all_of(f.begin(), f.end(), [&](const ex& factor) { return cannot_vanish(factor, parameters); });
}

/// Whether b_μρ is triangular up to the order of rows and columns, with a diagonal that cannot vanish: rows with one
/// entry left are taken away until none is left.
bool is_safe(const Choice& choice, const ConstraintRows& rows, const Chart& chart, const GiNaC::exset& parameters) {
  std::vector<ConstraintIndex> open_rows = rows.indices();
  Choice open_columns = choice;
  while (!open_rows.empty()) {
    const auto entry = [&](ConstraintIndex row, FreeIndex column) { return rows.beta[row][chart.full(column)]; };
    const auto reduces = [&](ConstraintIndex row) {
      const auto filled = [&](FreeIndex column) { return !entry(row, column).is_zero(); };
      if (std::count_if(open_columns.begin(), open_columns.end(), filled) != 1) return false;
      const auto column = std::find_if(open_columns.begin(), open_columns.end(), filled);
      if (!cannot_vanish(entry(row, *column), parameters)) return false;
      open_columns.erase(column);
      return true;
    };
    const auto row = std::find_if(open_rows.begin(), open_rows.end(), reduces);
    if (row == open_rows.end()) return false;
    open_rows.erase(row);
  }
  return true;
}

double determinant(std::vector<std::vector<double>> m) {
  double product = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    }
    std::swap(m[k], m[pivot]);
    product *= m[k][k];
    if (product == 0) return 0;
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      for (std::size_t j = m.size(); j-- > k;) m[i][j] -= m[i][k] / m[k][k] * m[k][j];
    }
  }
  return product;
}

/// The one of `candidates` with the largest |det b_μρ| at the initial state, speeds scaled by the mass metric; empty
/// when all of them are singular there.
Choice best_at_start(const std::vector<Choice>& candidates, const model::Model& model, const gauss::System& system,
                     const ConstraintRows& rows) {
  const Chart& chart = *system.chart;
  const GiNaC::exmap state = initial_state(model, chart);
  support::Indexed<FreeIndex, std::vector<double>> columns;
  for (const FreeIndex a : chart.free()) {
    const double inertia = evaluate(system.metric.G_qq[a][a], state);
    std::vector<double> column;
    for (const ConstraintIndex mu : rows.indices()) {
      column.push_back(evaluate(rows.beta[mu][chart.full(a)], state) / std::sqrt(inertia > 0 ? inertia : 1));
    }
    columns.push_back(std::move(column));
  }
  Choice best;
  double largest = 0;
  for (const Choice& choice : candidates) {
    std::vector<std::vector<double>> matrix;
    for (const FreeIndex a : choice) matrix.push_back(columns[a]);
    // A tie goes to the first choice, whatever the last bits say.
    const double size = std::abs(determinant(matrix));
    if (size > largest * (1 + 1e-9)) {
      largest = size;
      best = choice;
    }
  }
  return best;
}

Choice users_choice(const model::Model& model, const Chart& chart) {
  Choice choice;
  for (const FreeIndex a : chart.free()) {
    for (const model::Name& name : model.dependent) {
      if (name.text == chart[a].label || name.text == chart[a].rate.get_name()) choice.push_back(a);
    }
  }
  return choice;
}

Partition complete(const Choice& choice, bool is_safe, const Chart& chart) {
  Partition partition;
  partition.is_safe = is_safe;
  for (const FreeIndex a : chart.free()) {
    const bool is_dependent = std::find(choice.begin(), choice.end(), a) != choice.end();
    is_dependent ? partition.dependent.push_back(a) : partition.independent.push_back(a);
  }
  return partition;
}

}  // namespace

std::optional<Partition> choose_partition(const model::Model& model, const gauss::System& system,
                                          const ConstraintRows& rows) {
  const Chart& chart = *system.chart;
  if (rows.size() > chart.free_count()) return std::nullopt;
  GiNaC::exset parameters;
  for (const model::Parameter& parameter : model.parameters) parameters.insert(chart.symbols().at(parameter.name.text));
  const Choice own = users_choice(model, chart);
  const bool is_chosen = !own.empty() && own.size() == rows.size();
  const std::vector<Choice> candidates =
      is_chosen ? std::vector<Choice>{own} : choices(chart.free_count(), rows.size());
  for (const Choice& choice : candidates) {
    if (is_safe(choice, rows, chart, parameters)) return complete(choice, true, chart);
  }
  const Choice choice = best_at_start(candidates, model, system, rows);
  if (choice.size() != rows.size()) return std::nullopt;
  return complete(choice, false, chart);
}

}  // namespace gaussgen::nonholonomic
