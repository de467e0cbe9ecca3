#include "strategy/ldl.hpp"

#include <algorithm>
#include <utility>

#include "ir/traverse.hpp"
#include "strategy/margins.hpp"
#include "strategy/reach.hpp"
#include "support/assert.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

/// The first one of the fewest entries.
std::size_t sparsest_row(const std::vector<std::map<std::size_t, Expr>>& rest, const std::vector<char>& done) {
  std::size_t best = rest.size();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (done[i] == 0 && (best == rest.size() || rest[i].size() < rest[best].size())) best = i;
  }
  return best;
}

// Nothing cancels against it, and what is multiplied with it later may be as small as its reciprocal is large.
bool is_selected(Expr reciprocal) {
  const ir::Node& node = reciprocal.graph()[reciprocal.id()];
  return node.kind == ir::Kind::function && node.function == ir::Function::select;
}

}  // namespace

Expr trusted_part(int pivots, Expr epsilon) {
  // By roots, since not every number type has other powers.
  const Expr root = pow(epsilon, ir::Rational(1) / 2).kept_whole("root_epsilon");
  const Expr quarter = root * pow(root, ir::Rational(1) / 2);
  const Expr rounding = support::Rational(k_lost_to_rounding * pivots) * epsilon;
  return select(less(rounding, quarter), quarter, rounding);
}

Expr kept_by_rows(Expr epsilon) { return pow(epsilon, ir::Rational(1) / 2); }

Expr least_response(Expr response, Expr epsilon) {
  const std::optional<Expr> reach = Reach(response.graph())(response);
  return reach ? kept_by_rows(epsilon) * *reach : Expr(response.graph(), response.graph().constant(0));
}

Ldl::Ldl(const Matrix& matrix, const std::vector<std::string>& labels, const std::string& prefix, Expr epsilon,
         Steps& steps, Dependent dependent)
    : graph_(epsilon.graph()), epsilon_(epsilon), dependent_(dependent), labels_(labels), prefix_(prefix) {
  const std::size_t n = matrix.size();
  const Expr zero(graph_, graph_.constant(0));
  d_.assign(n, zero);
  is_original_.assign(n, 0);
  l_.resize(n);
  Rest rest(n);
  for (std::size_t i = 0; i < n; ++i) {
    diagonal_.push_back(matrix[i][i]);
    for (std::size_t j = 0; j < n; ++j) {
      if (!matrix[i][j].is_zero()) rest[i].emplace(j, matrix[i][j]);
    }
  }
  sizes_ = diagonal_;
  w_.resize(n);
  std::vector<char> done(n, 0);
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t pivot = sparsest_row(rest, done);
    order_.push_back(pivot);
    done[pivot] = 1;
    eliminate(pivot, rest, steps);
  }
  sort_columns();
}

void Ldl::eliminate(std::size_t pivot, Rest& rest, Steps& steps) {
  const std::map<std::size_t, Expr> row = std::move(rest[pivot]);
  rest[pivot].clear();
  const auto diagonal = row.find(pivot);
  const Expr entry = diagonal == row.end() ? Expr(graph_, graph_.constant(0)) : diagonal->second;
  is_original_[pivot] = entry == diagonal_[pivot] ? 1 : 0;
  // A diagonal entry has its name from elsewhere, if it has one.
  d_[pivot] = is_original_[pivot] != 0 ? entry : steps.name(entry, prefix_ + "_pivot_" + labels_[pivot]);
  if (dependent_ == Dependent::drop) {
    find_size_by_factors(pivot, steps);
  } else {
    find_size(pivot, steps);
  }
  const Expr inverse = reciprocal(pivot);
  for (const auto& [i, value] : row) {
    if (i == pivot) continue;
    const std::string name = prefix_ + "_factor_" + labels_[i] + "_" + labels_[pivot];
    const Expr factor = value * inverse;
    const Expr named = is_selected(inverse) ? factor.kept_whole(name) : steps.name(factor, name);
    if (!named.is_zero()) l_[pivot].push_back({i, named});
    rest[i].erase(pivot);
  }
  for (const Entry& below : l_[pivot]) {
    for (const Entry& beside : l_[pivot]) {
      if (beside.row > below.row) break;
      const auto known = rest[below.row].find(beside.row);
      const Expr before = known == rest[below.row].end() ? Expr(graph_, graph_.constant(0)) : known->second;
      const Expr now = before - below.value * row.at(beside.row);
      for (const auto& [i, j] : {std::pair{below.row, beside.row}, std::pair{beside.row, below.row}}) {
        if (now.is_zero()) {
          rest[i].erase(j);
        } else {
          rest[i].insert_or_assign(j, now);
        }
      }
    }
  }
}

// With w the row of L⁻¹, p = wᵀ a w: rounding of entries a_ij, which sqrt(a_ii a_jj) bounds, is in it w_i w_j times. A pivot that is small by what it is the
// rest of makes large factors, and those after it are small beside what they made. Where only diagonal entries come before, Σ w_i² a_ii is part of the
// diagonal entry itself.
void Ldl::find_size(std::size_t pivot, Steps& steps) {
  const Expr zero(graph_, graph_.constant(0));
  std::map<std::size_t, Expr>& row = w_[pivot];
  bool is_simple = true;
  for (const std::size_t j : order_) {
    const Entry* const below = entry_below(j, pivot);
    if (below == nullptr) continue;
    is_simple = is_simple && is_original_[j] != 0;
    row.try_emplace(j, zero).first->second -= below->value;
    for (const auto& [i, value] : w_[j]) row.try_emplace(i, zero).first->second -= below->value * value;
  }
  for (auto& [i, value] : row) {
    value = steps.name_varying(value, prefix_ + "_back_" + labels_[pivot] + "_" + labels_[i]);
    if (!is_simple) sizes_[pivot] += pow(value, 2) * diagonal_[i];
  }
  if (!is_simple) sizes_[pivot] = steps.name_varying(sizes_[pivot], prefix_ + "_size_" + labels_[pivot]);
}

// Responses of long chains have few entries, and L⁻¹ has all. A bound that needs L alone, by way of each entry: p_k = a_kk - Σ l_kj² p_j.
void Ldl::find_size_by_factors(std::size_t pivot, Steps& steps) {
  bool is_simple = true;
  for (const std::size_t j : order_) {
    const Entry* const below = entry_below(j, pivot);
    if (below == nullptr || is_original_[j] != 0) continue;
    is_simple = false;
    sizes_[pivot] += pow(below->value, 2) * sizes_[j];
  }
  if (!is_simple) sizes_[pivot] = steps.name_varying(sizes_[pivot], prefix_ + "_size_" + labels_[pivot]);
}

const Ldl::Entry* Ldl::entry_below(std::size_t column, std::size_t row) const {
  const auto found =
      std::find_if(l_[column].begin(), l_[column].end(), [&](const Entry& entry) { return entry.row == row; });
  return found == l_[column].end() ? nullptr : &*found;
}

void Ldl::sort_columns() {
  std::vector<std::size_t> place(order_.size());
  for (std::size_t step = 0; step < order_.size(); ++step) place[order_[step]] = step;
  for (std::vector<Entry>& column : l_) {
    std::sort(column.begin(), column.end(),
              [&](const Entry& a, const Entry& b) { return place[a.row] < place[b.row]; });
  }
}

Vector Ldl::solve(const Vector& right_hand_side, const std::string& name, Steps& steps) const {
  GAUSS_ASSERT(right_hand_side.size() == d_.size(), "{} against {}", right_hand_side.size(), d_.size());
  Vector x = right_hand_side;
  for (std::size_t step = 0; step < order_.size(); ++step) {
    const std::size_t i = order_[step];
    x[i] = steps.name_varying(x[i], name + "_y_" + labels_[i]);
    for (const auto& [j, factor] : l_[i]) x[j] = x[j] - factor * x[i];
  }
  for (std::size_t step = order_.size(); step-- > 0;) {
    const std::size_t i = order_[step];
    const Expr inverse = reciprocal(i);
    Expr value = x[i] * inverse;
    if (is_selected(inverse)) value = value.kept_whole(name + "_z_" + labels_[i]);
    for (const auto& [j, factor] : l_[i]) value = value - factor * x[j];
    x[i] = steps.name_varying(value, name + "_" + labels_[i]);
  }
  return x;
}

// Rounding alone perturbs a pivot by about n eps of its diagonal entry (Higham, Accuracy and Stability, 10.1).
Expr Ldl::tolerance(std::size_t pivot) const {
  if (is_original_[pivot] != 0) return {graph_, graph_.constant(0)};
  return support::Rational(k_lost_to_rounding * count()) * epsilon_ * sizes_[pivot];
}

Expr Ldl::reciprocal(std::size_t pivot) const {
  const Expr zero(graph_, graph_.constant(0));
  if (d_[pivot].is_zero()) return zero;
  const Expr inverse = pow(d_[pivot], -1);
  // What parameters alone decide is the same for a whole run: there is nothing to switch to and fro.
  const bool is_fixed = is_original_[pivot] != 0 && ir::is_of_parameters(graph_, d_[pivot].id());
  if (dependent_ == Dependent::divide || is_fixed) return inverse;
  return select(at_most(d_[pivot], tolerance(pivot)), zero, inverse);
}

Expr Ldl::violated(Expr part, const std::function<Expr(Expr)>& least_original) const {
  Margins margins(graph_);
  for (std::size_t i = 0; i < d_.size(); ++i)
    margins.require(d_[i], is_original_[i] != 0 ? least_original(d_[i]) : part * sizes_[i]);
  return margins.violated("least_" + prefix_ + "_pivot");
}

Expr Ldl::singular() const {
  const Expr zero(graph_, graph_.constant(0));
  return violated(trusted_part(count(), epsilon_), [zero](Expr) { return zero; });
}

Expr Ldl::dependent(const ir::Rational& least) const {
  return violated(kept_by_rows(epsilon_) + Expr(graph_, graph_.constant(least)),
                  [this](Expr response) { return least_response(response, epsilon_); });
}

std::vector<std::string> Ldl::vanishing() const {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < d_.size(); ++i) {
    if (d_[i].is_zero()) rows.push_back(labels_[i]);
  }
  return rows;
}

}  // namespace gaussgen::strategy
