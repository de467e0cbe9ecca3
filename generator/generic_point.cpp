#include "generic_point.hpp"

namespace gaussgen {

using cln::cl_F;
using evaluate::Arithmetic;
using evaluate::Scaled;
using support::Rational;

namespace {

constexpr int k_digits = 60;
constexpr int k_trusted_digits = 30;
constexpr int k_attempts = 4;

/// Numbers in (-1, 1) without a pattern that a model could have, the same in every run: multiples of the golden ratio, cut
/// to their fractions (Weyl).
class Scatter {
 public:
  explicit Scatter(int attempt)
      : index_(1000 * attempt + 17), scale_(Rational(1) / cln::expt_pos(cln::cl_I(8), attempt + 1)) {}

  /// Smaller at later attempts, which stay nearer to the start: there at least a sound model has values.
  Rational operator()() {
    const Rational golden = Rational(cln::cl_I("618033988749894848")) / cln::expt_pos(cln::cl_I(10), 18);
    const Rational turn = golden * ++index_;
    return (2 * (turn - cln::floor1(turn)) - 1) * scale_;
  }

 private:
  int index_;
  Rational scale_;
};

Rational trusted() { return Rational(1) / cln::expt_pos(cln::cl_I(10), k_trusted_digits); }

/// Binds the symbols of a model one after the other.
template <class Values>
class Spread {
 public:
  Spread(Mechanics& mechanics, Values& values, int attempt)
      : mechanics_(mechanics), values_(values), scatter_(attempt) {}

  void run() {
    bind(mechanics_.symbols.time, Rational(0));
    parameters();
    for (const ir::SymbolId input : mechanics_.symbols.inputs) bind(input, Rational(0));
    coordinates();
    orientations();
    for (const kinematics::Speed& speed : mechanics_.symbols.speeds) bind(speed.symbol, Rational(1));
  }

 private:
  using Number = Scaled<cl_F>;

  std::optional<Number> value(const model::Ast& ast) { return values_(mechanics_.expressions(ast).id()); }
  cl_F number(const Rational& exact) const { return values_.arithmetic().number(exact).value; }
  void set(ir::SymbolId symbol, const cl_F& at) { values_.bind(symbol, values_.arithmetic().input(at)); }

  cl_F moved(const cl_F& at) { return at + number(scatter_()) * (cln::zerop(at) ? number(Rational(1)) : cln::abs(at)); }
  void bind(ir::SymbolId symbol, const Rational& near) { set(symbol, moved(number(near))); }

  // A formula goes on holding: what follows from it holds in every configuration, too.
  void parameters() {
    const auto& all = mechanics_.model.parameters;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (const auto at = value(all[i].value)) {
        set(mechanics_.symbols.parameters[i], all[i].is_formula ? at->value : moved(at->value));
      }
    }
  }

  void coordinates() {
    const auto& all = mechanics_.model.coordinates;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& place = mechanics_.symbols.coordinates[i];
      if (place.is_held) continue;
      const auto at = value(all[i].initial);
      if (at)
        set(mechanics_.symbols.configuration[kinematics::ConfigurationIndex{place.index}].symbol, moved(at->value));
    }
  }

  void orientations() {
    const auto& all = mechanics_.model.orientations;
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::vector<cl_F> e;
      cl_F square = number(Rational(0));
      for (const model::Ast& component : all[i].initial) {
        const auto at = value(component);
        if (!at) return;
        e.push_back(moved(at->value));
        square = square + e.back() * e.back();
      }
      const std::size_t first = mechanics_.symbols.first_quaternion_component[i].value;
      for (std::size_t j = 0; j < e.size(); ++j) {
        const auto& component = mechanics_.symbols.configuration[kinematics::ConfigurationIndex{first + j}];
        set(component.symbol, e[j] / cln::sqrt(square));
      }
    }
  }

  Mechanics& mechanics_;
  Values& values_;
  Scatter scatter_;
};

evaluate::Matrix without_column(const evaluate::Matrix& matrix, std::size_t dropped) {
  evaluate::Matrix result(matrix.rows(), matrix.columns() - 1, matrix(0, 0));
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    for (std::size_t j = 0; j < result.columns(); ++j) result(i, j) = matrix(i, j < dropped ? j : j + 1);
  }
  return result;
}

}  // namespace

GenericPoint::Values GenericPoint::values_near_start(int attempt) const {
  Values values(mechanics_.graph, Arithmetic<Number>(Arithmetic<cl_F>(k_digits)));
  Spread<Values>(mechanics_, values, attempt).run();
  return values;
}

std::optional<evaluate::Matrix> GenericPoint::operator()(const strategy::Matrix& matrix) {
  const Arithmetic<cl_F> arithmetic(k_digits);
  const cl_F rounding = arithmetic.number(trusted());
  const cl_F zero = arithmetic.number(Rational(0));
  const std::size_t columns = matrix.empty() ? 0 : matrix[0].size();
  for (int attempt = 0; attempt < k_attempts; ++attempt) {
    Values values = values_near_start(attempt);
    evaluate::Matrix result(matrix.size(), columns, zero);
    bool is_defined = true;
    for (std::size_t i = 0; i < matrix.size() && is_defined; ++i) {
      for (std::size_t j = 0; j < columns && is_defined; ++j) {
        const std::optional<Number> entry = values(matrix[i][j].id());
        is_defined = entry.has_value();
        if (entry && cln::abs(entry->value) > rounding * entry->scale) result(i, j) = entry->value;
      }
    }
    if (is_defined) return result;
  }
  return std::nullopt;
}

std::size_t generic_rank(const evaluate::Matrix& matrix) {
  if (matrix.rows() == 0 || matrix.columns() == 0) return 0;
  return evaluate::rank(evaluate::equilibrated(matrix), Arithmetic<cl_F>(k_digits).number(trusted()));
}

std::vector<std::size_t> dependent_columns(const evaluate::Matrix& matrix) {
  std::vector<std::size_t> dependent;
  const std::size_t rank = generic_rank(matrix);
  for (std::size_t j = 0; j < matrix.columns() && rank < matrix.columns(); ++j) {
    if (generic_rank(without_column(matrix, j)) == rank) dependent.push_back(j);
  }
  return dependent;
}

}  // namespace gaussgen
