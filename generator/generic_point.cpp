#include "generic_point.hpp"

#include <utility>

namespace gaussgen {

using cln::cl_F;
using evaluate::Arithmetic;
using evaluate::Paired;
using evaluate::Scaled;
using support::Rational;

namespace {

constexpr int k_digits = 60;
constexpr int k_trusted_digits = 30;
constexpr int k_attempts = 4;

/// Numbers in (-scale, scale) without a pattern that a model could have, the same in every run: multiples of the golden ratio, cut
/// to their fractions (Weyl).
class Scatter {
 public:
  Scatter(std::uint32_t start, Rational scale) : index_(start), scale_(std::move(scale)) {}

  Rational operator()() {
    const Rational golden = Rational(cln::cl_I("618033988749894848")) / cln::expt_pos(cln::cl_I(10), 18);
    const Rational turn = golden * cln::cl_I(static_cast<unsigned long>(++index_));
    return (2 * (turn - cln::floor1(turn)) - 1) * scale_;
  }

 private:
  std::uint32_t index_;
  Rational scale_;
};

/// Later attempts stay nearer to the start: there at least a sound model has values.
Scatter scatter_of(int attempt) {
  return {17U + 1000U * static_cast<std::uint32_t>(attempt),
          Rational(1) / cln::expt_pos(cln::cl_I(8), cln::cl_I(attempt + 1))};
}

/// What stands for a node that has no value anywhere. Not from Scatter: its numbers, side by side in a matrix, would depend on
/// each other; those of a Cauchy matrix never do.
Rational substitute_for(ir::NodeId id) { return Rational(1) / cln::cl_I(static_cast<unsigned long>(id.index) + 7); }

Rational trusted() { return Rational(1) / cln::expt_pos(cln::cl_I(10), k_trusted_digits); }

cl_F plain(const Paired& x) { return x.fine; }
cl_F plain(const Scaled<cl_F>& x) { return x.value; }
Paired exact(const Arithmetic<Paired>& arithmetic, const cl_F& x) { return arithmetic.number(x); }
Scaled<cl_F> exact(const Arithmetic<Scaled<cl_F>>& arithmetic, const cl_F& x) { return arithmetic.input(x); }

/// Binds the symbols of a model one after the other.
template <class Values>
class Spread {
 public:
  Spread(ModelGraph& motion, Values& values, int attempt)
      : motion_(motion), values_(values), scatter_(scatter_of(attempt)) {}

  void run() {
    bind(motion_.symbols.time, Rational(0));
    parameters();
    for (const ir::SymbolId input : motion_.symbols.inputs) bind(input, Rational(0));
    coordinates();
    orientations();
    for (const ir::SymbolId reaction : motion_.symbols.reactions) bind(reaction, Rational(1));
    for (const kinematics::Speed& speed : motion_.symbols.speeds) bind(speed.symbol, Rational(1));
  }

 private:
  std::optional<cl_F> value(const model::Ast& ast) {
    const auto found = values_(motion_.expressions(ast).id());
    return found ? std::optional<cl_F>(plain(*found)) : std::nullopt;
  }
  cl_F number(const Rational& rational) const { return plain(values_.arithmetic().number(rational)); }
  void set(ir::SymbolId symbol, const cl_F& at) { values_.bind(symbol, exact(values_.arithmetic(), at)); }

  cl_F moved(const cl_F& at) { return at + number(scatter_()) * (cln::zerop(at) ? number(Rational(1)) : cln::abs(at)); }
  void bind(ir::SymbolId symbol, const Rational& near) { set(symbol, moved(number(near))); }

  // A formula goes on holding: what follows from it holds in every configuration, too.
  void parameters() {
    const auto& all = motion_.model.parameters;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (const auto at = value(all[i].value)) {
        set(motion_.symbols.parameters[i], all[i].is_formula ? *at : moved(*at));
      }
    }
  }

  void coordinates() {
    const auto& all = motion_.model.coordinates;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& place = motion_.symbols.coordinates[i];
      if (place.is_held) continue;
      const auto at = value(all[i].start());
      if (at) set(motion_.symbols.configuration[kinematics::ConfigurationIndex{place.index}].symbol, moved(*at));
    }
  }

  void orientations() {
    const auto& all = motion_.model.orientations;
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::vector<cl_F> e;
      cl_F square = number(Rational(0));
      for (const model::Ast& component : all[i].initial) {
        const auto at = value(component);
        if (!at) return;
        e.push_back(moved(*at));
        square = square + e.back() * e.back();
      }
      const std::size_t first = motion_.symbols.first_quaternion_component[i].value;
      for (std::size_t j = 0; j < e.size(); ++j) {
        const auto& component = motion_.symbols.configuration[kinematics::ConfigurationIndex{first + j}];
        set(component.symbol, e[j] / cln::sqrt(square));
      }
    }
  }

  ModelGraph& motion_;
  Values& values_;
  Scatter scatter_;
};

}  // namespace

GenericPoint::Values& GenericPoint::values_near_start(int attempt) {
  if (attempt == static_cast<int>(points_.size())) {
    points_.emplace_back(motion_.graph, Arithmetic<Number>(Arithmetic<cl_F>(k_digits)));
    Spread<Values>(motion_, points_.back(), attempt).run();
  }
  return points_[static_cast<std::size_t>(attempt)];
}

evaluate::Matrix GenericPoint::operator()(const strategy::Matrix& matrix) {
  for (int attempt = 0;; ++attempt) {
    Values& values = values_near_start(attempt);
    const bool is_last = attempt + 1 == k_attempts;
    if (const auto result = matrix_of(matrix, values, is_last)) return *result;
  }
}

std::optional<evaluate::Matrix> GenericPoint::matrix_of(const strategy::Matrix& matrix, Values& values,
                                                        bool replaces_undefined) {
  const Arithmetic<cl_F> arithmetic(k_digits);
  const cl_F rounding = arithmetic.number(trusted());
  const std::size_t columns = matrix.empty() ? 0 : matrix[0].size();
  evaluate::Matrix result(matrix.size(), columns, arithmetic.number(Rational(0)));
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const ir::NodeId id = matrix[i][j].id();
      const std::optional<Number> entry = values(id);
      if (!entry && !replaces_undefined) return std::nullopt;
      if (!entry) {
        result(i, j) = arithmetic.number(substitute_for(id));
      } else if (cln::abs(entry->value) > rounding * entry->scale) {
        result(i, j) = entry->value;
      }
    }
  }
  return result;
}

bool VanishesEverywhere::operator()(ir::Expr expression) {
  for (int attempt = 0; attempt < k_attempts; ++attempt) {
    if (attempt == static_cast<int>(points_.size())) points_.push_back(values(attempt));
    const auto value = points_[static_cast<std::size_t>(attempt)](expression.id());
    if (value) return cln::zerop(value->fine);
  }
  return false;
}

VanishesEverywhere::Values VanishesEverywhere::values(int attempt) {
  Values values(motion_.graph, Arithmetic<Paired>(k_digits, k_digits));
  Spread<Values>(motion_, values, attempt).run();
  return values;
}

std::size_t generic_rank(const evaluate::Matrix& matrix) {
  if (matrix.rows() == 0 || matrix.columns() == 0) return 0;
  return evaluate::rank(evaluate::equilibrated(matrix), Arithmetic<cl_F>(k_digits).number(trusted()));
}

// By L D Lᵀ, which is stable in any order where nothing is negative; a row that vanishes takes part no more.
std::vector<std::size_t> dependent_rows(evaluate::Matrix metric) {
  const cl_F rounding = Arithmetic<cl_F>(k_digits).number(trusted());
  std::vector<cl_F> bounds;
  for (std::size_t i = 0; i < metric.rows(); ++i) bounds.push_back(rounding * cln::abs(metric(i, i)));
  std::vector<std::size_t> dependent;
  for (std::size_t pivot = 0; pivot < metric.rows(); ++pivot) {
    if (cln::abs(metric(pivot, pivot)) <= bounds[pivot]) {
      dependent.push_back(pivot);
      continue;
    }
    for (std::size_t i = pivot + 1; i < metric.rows(); ++i) {
      if (cln::zerop(metric(i, pivot))) continue;
      const cl_F factor = metric(i, pivot) / metric(pivot, pivot);
      for (std::size_t j = pivot + 1; j < metric.rows(); ++j) metric(i, j) = metric(i, j) - factor * metric(pivot, j);
    }
  }
  return dependent;
}

std::vector<std::size_t> dependent_columns(const evaluate::Matrix& matrix) {
  if (matrix.rows() == 0) return {};
  return evaluate::open_unknowns(evaluate::equilibrated(matrix), Arithmetic<cl_F>(k_digits).number(trusted()));
}

}  // namespace gaussgen
