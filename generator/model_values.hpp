#pragma once
// Numbers of a model at one state, each with a bound on what rounding can have done to it.

#include <functional>

#include "evaluate/arithmetic_paired.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/dense.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

using Bindings = std::vector<std::pair<ir::SymbolId, ir::NodeId>>;

/// What became of a step to an initial state.
enum class Taken {
  undefined,  ///< nothing is bound
  arrived,    ///< the next one would change nothing that counts
  moved,
};

/// Values at the model's initial state and a time, good to `digits` digits: twice as many are carried, since as many may cancel, and
/// as many more as parameters are apart.
///
/// What is nothing but rounding is zero here, see Arithmetic<Paired>. (The absolute sum S of arithmetic_scale.hpp cannot tell: through the solution of a linear
/// system it grows into a bound that is larger than the value by hundreds of orders.)
class ModelValues {
 public:
  ModelValues(Mechanics& mechanics, const support::Rational& time, int digits);

  /// The value of a node; empty if it is undefined, see `trouble`.
  std::optional<cln::cl_F> operator()(ir::NodeId node);

  /// The same for a sum that ought to vanish, without divisions in it, so that S is sharp: zero below 10^-digits S.
  std::optional<cln::cl_F> residual(ir::NodeId node, int digits);

  /// Empty if an entry is undefined; the matrix has a row and a column.
  std::optional<evaluate::Matrix> operator()(const strategy::Matrix& matrix);

  /// How much of what a sum is made of is left of it, where it ought to vanish.
  std::optional<cln::cl_F> relative_residual(ir::NodeId node);

  /// Of such a matrix, whatever the units of rows and columns; what is smaller than `part` of it is nothing.
  std::size_t rank(const evaluate::Matrix& matrix, const cln::cl_F& part) const;
  std::size_t rank(const evaluate::Matrix& matrix) const { return rank(matrix, least_part()); }

  /// For values without errors.
  cln::cl_F least_part() const;

  std::optional<evaluate::Trouble> trouble(ir::NodeId node) { return values_.trouble(node); }
  bool is_true(ir::Expr condition);

  /// In the precision that is carried.
  template <class Number>
  cln::cl_F number(const Number& value) const {
    return values_.arithmetic().fine().number(value);
  }

  /// Gives symbols the values of nodes, all found before the first is given; false, and nothing given, if one is undefined.
  bool bind(const Bindings& nodes);

  /// Likewise those nodes that have a value.
  void bind_defined(const Bindings& nodes);

  /// Gives a symbol a number.
  void set(ir::SymbolId symbol, const support::Rational& value) { bind(symbol, values_.arithmetic().number(value)); }

  /// As `bind`, for a step of Newton's method.
  Taken take_step(const Bindings& nodes);

 private:
  std::vector<std::optional<evaluate::Paired>> found(const Bindings& nodes);
  void bind(ir::SymbolId symbol, const evaluate::Paired& value);

  ir::Graph& graph_;
  int carried_;  ///< digits
  evaluate::Evaluator<evaluate::Paired> values_;
  evaluate::Evaluator<evaluate::Scaled<cln::cl_F>> scales_;
};

/// What the initial state gives to one symbol of the configuration or of the speeds.
struct InitialValue {
  ir::SymbolId symbol;
  std::string name;
  std::string unit;
  ir::NodeId node;
};

/// In the order of the state: configuration, then speeds. `take_step` evaluates and binds the steps that lead there; the nodes of the last one are
/// returned, to be evaluated where those were bound, or the nodes of the first one that is undefined. A start that is known (general_start.hpp) is returned as it is.
std::vector<InitialValue> initial_values(Mechanics& mechanics, const std::function<Taken(const Bindings&)>& take_step);
std::vector<InitialValue> initial_values(Mechanics& mechanics, ModelValues& values);

/// With any other numbers.
template <class T>
std::vector<InitialValue> initial_values(Mechanics& mechanics, evaluate::Evaluator<T>& values) {
  return initial_values(mechanics, [&](const Bindings& nodes) {
    std::vector<T> found;
    for (const auto& [symbol, node] : nodes) {
      const std::optional<T> value = values(node);
      if (!value) return Taken::undefined;
      found.push_back(*value);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) values.bind(nodes[i].first, found[i]);
    return Taken::moved;
  });
}

/// The state as numbers, so that everything else is evaluated at it, and the values of held coordinates; false if part of the
/// state is undefined: that part stays unbound.
bool bind_initial_values(Mechanics& mechanics, const std::vector<InitialValue>& state, ModelValues& values);

/// Open initial values that are bound get so many digits, and some more, by further steps of Newton's method.
void refine_initial_values(Mechanics& mechanics, int digits, ModelValues& values);

}  // namespace gaussgen
