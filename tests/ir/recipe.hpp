#pragma once
// Random expressions that exist apart from the graph: they can be built into it in any order, and have an exact value
// of their own to compare with.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ir/graph.hpp"

namespace gauss_test {

using gaussgen::ir::Graph;
using gaussgen::ir::NodeId;
using gaussgen::ir::SymbolId;
using gaussgen::support::Rational;

/// A small generator of our own: the standard distributions differ between libraries.
class Random {
 public:
  explicit Random(unsigned seed) : state_(seed * 2862933555777941757U + 3037000493U) {}

  /// 0 <= result < bound
  int below(int bound) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<int>((state_ >> 33U) % static_cast<unsigned>(bound));
  }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool chance(int percent) { return below(100) < percent; }
  Rational rational() {
    const Rational top = between(-9, 9);  // one after the other: compilers order the operands of "/" differently
    return top / between(1, 4);
  }

  template <class T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t i = list.size(); i > 1; --i)
      std::swap(list[i - 1], list[static_cast<std::size_t>(below(static_cast<int>(i)))]);
  }

 private:
  unsigned long long state_;
};

struct Recipe;
using RecipePtr = std::shared_ptr<const Recipe>;

struct Recipe {
  enum class Kind { constant, variable, sum, product, power, sine, cosine, named, function };
  Kind kind = Kind::constant;
  Rational value = 0;          ///< constant, exponent
  std::size_t symbol = 0;      ///< variable; the angle of a sine
  std::vector<int> multiples;  ///< sine, cosine: of each angle
  std::vector<RecipePtr> parts;
  std::string name;
  gaussgen::ir::Function function = gaussgen::ir::Function::sin;
};

/// The symbols that recipes speak of. Angles occur in sines and cosines only, which have rational values.
struct Symbols {
  std::vector<SymbolId> variables;
  std::vector<SymbolId> angles;
};

inline constexpr std::size_t k_variables = 4;
inline constexpr std::size_t k_angles = 2;

/// Two parameters, two coordinates and two angles; classes are declared in a random interleaving, the order within
/// each class is always the same.
Symbols declare_symbols(Graph& graph, Random& random);

/// Sums, products, whole powers, sines and cosines, names.
RecipePtr random_recipe(Random& random, int depth);

/// The same and every function, roots, sums of angles and variables: no exact value.
RecipePtr random_analytic_recipe(Random& random, int depth);

/// Builds children, and passes arguments, in a random order.
NodeId build(const Recipe& recipe, Graph& graph, const Symbols& symbols, Random& random);

/// Values for an exact evaluation: t gives an angle with sin = 2t/(1+t²), cos = (1-t²)/(1+t²).
struct Point {
  std::vector<Rational> variables;
  std::vector<Rational> half_tangents;
};
Point random_point(Random& random);

/// The value by the recipe itself; empty where it divides by zero.
std::optional<Rational> exact_value(const Recipe& recipe, const Point& point);

/// The value of a node of the graph, from the definition of its kinds.
std::optional<Rational> exact_value(const Graph& graph, NodeId id, const Symbols& symbols, const Point& point);

}  // namespace gauss_test
