#include "ir/recipe.hpp"

#include <unordered_map>

#include "ir/traverse.hpp"
#include "support/assert.hpp"

namespace gauss_test {

using gaussgen::ir::Function;
using gaussgen::ir::Node;
using gaussgen::ir::SymbolClass;

namespace {

using Maybe = std::optional<Rational>;

RecipePtr make(Recipe recipe) { return std::make_shared<const Recipe>(std::move(recipe)); }

RecipePtr leaf(Random& random) {
  Recipe recipe;
  if (random.chance(25)) {
    recipe.value = random.rational();
  } else {
    recipe.kind = Recipe::Kind::variable;
    recipe.symbol = static_cast<std::size_t>(random.below(static_cast<int>(k_variables)));
  }
  return make(std::move(recipe));
}

RecipePtr circular(Random& random) {
  Recipe recipe;
  recipe.kind = random.chance(50) ? Recipe::Kind::sine : Recipe::Kind::cosine;
  // Mostly plain angles, so that squares meet and cancel.
  const bool plain = random.chance(75);
  recipe.multiples = {1, 0};
  if (random.chance(40)) std::swap(recipe.multiples[0], recipe.multiples[1]);
  if (!plain) recipe.multiples = {random.between(-2, 2), random.between(-2, 2)};
  return make(std::move(recipe));
}

RecipePtr squared(RecipePtr base) {
  Recipe recipe;
  recipe.kind = Recipe::Kind::power;
  recipe.value = 2;
  recipe.parts = {std::move(base)};
  return make(std::move(recipe));
}

Maybe whole_power(const Maybe& base, const Rational& exponent) {
  if (!base) return std::nullopt;
  int times = gaussgen::support::to_int(exponent);
  if (*base == 0 && times < 0) return std::nullopt;
  const Rational factor = times < 0 ? Rational(1 / *base) : *base;
  Rational result = 1;
  for (times = times < 0 ? -times : times; times > 0; --times) result = result * factor;
  return result;
}

struct Direction {
  Rational cosine = 1;
  Rational sine = 0;

  void turn(const Rational& half_tangent, int times) {
    const Rational t = times < 0 ? Rational(-half_tangent) : half_tangent;
    const Rational c = (1 - t * t) / (1 + t * t);
    const Rational s = 2 * t / (1 + t * t);
    for (int i = 0; i < std::abs(times); ++i) {
      const Rational next = cosine * c - sine * s;
      sine = sine * c + cosine * s;
      cosine = next;
    }
  }
};

}  // namespace

Symbols declare_symbols(Graph& graph, Random& random) {
  Symbols symbols;
  symbols.variables.resize(k_variables);
  symbols.angles.resize(k_angles);
  std::vector<int> classes{0, 0, 1, 1, 2, 2, 3};
  random.shuffle(classes);
  std::size_t parameters = 0;
  std::size_t coordinates = 0;
  std::size_t angles = 0;
  for (const int c : classes) {
    if (c == 0) {
      symbols.variables[parameters] = graph.declare(SymbolClass::parameter, parameters == 0 ? "a" : "b");
      ++parameters;
    } else if (c == 1) {
      symbols.variables[2 + coordinates] = graph.declare(SymbolClass::speed, coordinates == 0 ? "u" : "v");
      ++coordinates;
    } else if (c == 2) {
      symbols.angles[angles] = graph.declare(SymbolClass::configuration, angles == 0 ? "phi" : "psi");
      ++angles;
    } else {
      graph.declare(SymbolClass::input, "unused");
    }
  }
  return symbols;
}

RecipePtr random_recipe(Random& random, int depth) {
  if (depth == 0) return random.chance(50) ? leaf(random) : circular(random);
  Recipe recipe;
  const int choice = random.below(100);
  if (choice < 8) return squared(circular(random));
  if (choice < 45) {
    recipe.kind = Recipe::Kind::sum;
  } else if (choice < 78) {
    recipe.kind = Recipe::Kind::product;
  } else if (choice < 94) {
    recipe.kind = Recipe::Kind::power;
    recipe.value = random.between(-2, 3);
  } else {
    recipe.kind = Recipe::Kind::named;
  }
  const bool is_list = recipe.kind == Recipe::Kind::sum || recipe.kind == Recipe::Kind::product;
  const int parts = is_list ? random.between(2, 4) : 1;
  for (int i = 0; i < parts; ++i) recipe.parts.push_back(random_recipe(random, random.below(depth)));
  // A repeated part gives like terms and like bases something to do.
  if (is_list && random.chance(30)) recipe.parts.push_back(recipe.parts[0]);
  if (recipe.kind == Recipe::Kind::named) recipe.name = "n" + std::to_string(random.below(1000000));
  return make(std::move(recipe));
}

RecipePtr random_analytic_recipe(Random& random, int depth) {
  if (depth == 0) return leaf(random);
  Recipe recipe;
  const int choice = random.below(100);
  if (choice < 30) {
    recipe.kind = Recipe::Kind::sum;
  } else if (choice < 55) {
    recipe.kind = Recipe::Kind::product;
  } else if (choice < 70) {
    recipe.kind = Recipe::Kind::power;
    const Rational exponents[] = {-2, -1, 2, 3, Rational(1) / 2, Rational(-1) / 2, Rational(1) / 3};
    recipe.value = exponents[random.below(7)];
  } else {
    recipe.kind = Recipe::Kind::function;
    recipe.function = static_cast<Function>(random.below(static_cast<int>(Function::tanh) + 1));
  }
  const bool is_list = recipe.kind == Recipe::Kind::sum || recipe.kind == Recipe::Kind::product;
  const bool is_pair = recipe.kind == Recipe::Kind::function && recipe.function == Function::atan2;
  const int parts = is_list ? random.between(2, 3) : (is_pair ? 2 : 1);
  for (int i = 0; i < parts; ++i) recipe.parts.push_back(random_analytic_recipe(random, random.below(depth)));
  return make(std::move(recipe));
}

NodeId build(const Recipe& recipe, Graph& graph, const Symbols& symbols, Random& random) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < recipe.parts.size(); ++i) order.push_back(i);
  random.shuffle(order);
  std::vector<NodeId> parts(recipe.parts.size());
  for (const std::size_t i : order) parts[i] = build(*recipe.parts[i], graph, symbols, random);
  switch (recipe.kind) {
    case Recipe::Kind::constant: return graph.constant(recipe.value);
    case Recipe::Kind::variable: return graph.use(symbols.variables[recipe.symbol]);
    case Recipe::Kind::sum: random.shuffle(parts); return graph.sum(parts);
    case Recipe::Kind::product: random.shuffle(parts); return graph.product(parts);
    case Recipe::Kind::power: return graph.power(parts[0], recipe.value);
    case Recipe::Kind::named: return graph.named(parts[0], recipe.name);
    case Recipe::Kind::function: return graph.call(recipe.function, parts);
    default: break;
  }
  std::vector<gaussgen::ir::Term> argument;
  for (std::size_t i = 0; i < k_angles; ++i) argument.push_back({recipe.multiples[i], graph.use(symbols.angles[i])});
  random.shuffle(argument);
  return graph.call(recipe.kind == Recipe::Kind::sine ? Function::sin : Function::cos, {graph.linear(0, argument)});
}

Point random_point(Random& random) {
  Point point;
  for (std::size_t i = 0; i < k_variables; ++i) point.variables.push_back(random.rational() + Rational(1) / 7);
  for (std::size_t i = 0; i < k_angles; ++i) point.half_tangents.push_back(random.rational() / 5);
  return point;
}

Maybe exact_value(const Recipe& recipe, const Point& point) {
  std::vector<Rational> parts;
  for (const RecipePtr& part : recipe.parts) {
    const Maybe value = exact_value(*part, point);
    if (!value) return std::nullopt;
    parts.push_back(*value);
  }
  Rational total = recipe.kind == Recipe::Kind::product ? 1 : 0;
  switch (recipe.kind) {
    case Recipe::Kind::constant: return recipe.value;
    case Recipe::Kind::variable: return point.variables[recipe.symbol];
    case Recipe::Kind::named: return parts[0];
    case Recipe::Kind::power: return whole_power(parts[0], recipe.value);
    case Recipe::Kind::sum:
      for (const Rational& part : parts) total = total + part;
      return total;
    case Recipe::Kind::product:
      for (const Rational& part : parts) total = total * part;
      return total;
    default: break;
  }
  Direction direction;
  for (std::size_t i = 0; i < k_angles; ++i) direction.turn(point.half_tangents[i], recipe.multiples[i]);
  return recipe.kind == Recipe::Kind::sine ? direction.sine : direction.cosine;
}

namespace {

/// Values of nodes of a graph, from the definition of each kind.
class ExactReader {
 public:
  ExactReader(const Graph& graph, const Symbols& symbols, const Point& point)
      : graph_(graph), symbols_(symbols), point_(point) {}

  Maybe value(NodeId root) {
    for (const NodeId id : gaussgen::ir::post_order(graph_, {root})) values_[id.index] = of_node(graph_[id]);
    return values_[root.index];
  }

 private:
  Maybe of_node(const Node& node) {
    using gaussgen::ir::Kind;
    switch (node.kind) {
      case Kind::constant: return node.value;
      case Kind::symbol: return of_symbol(node.symbol);
      case Kind::power: return whole_power(values_[node.children[0].index], node.value);
      case Kind::named: return values_[node.children[0].index];
      case Kind::function: return of_call(node);
      default: break;
    }
    Rational total = node.kind == Kind::sum ? node.value : Rational(1);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Maybe part = values_[node.children[i].index];
      if (!part) return std::nullopt;
      total = node.kind == Kind::sum ? total + node.coefficients[i] * *part : total * *part;
    }
    return total;
  }

  Maybe of_symbol(SymbolId symbol) {
    for (std::size_t i = 0; i < k_variables; ++i) {
      if (symbols_.variables[i] == symbol) return point_.variables[i];
    }
    return std::nullopt;  // an angle: it has a sine and a cosine only
  }

  Maybe of_call(const Node& node) {
    const Node& argument = graph_[node.children[0]];
    Direction direction;
    if (argument.kind == gaussgen::ir::Kind::symbol) {
      direction.turn(half_tangent(argument.symbol), 1);
    } else {
      GAUSS_ASSERT(argument.value == 0, "a sine of {}", gaussgen::support::to_text(argument.value));
      for (std::size_t i = 0; i < argument.children.size(); ++i) {
        direction.turn(half_tangent(graph_[argument.children[i]].symbol),
                       gaussgen::support::to_int(argument.coefficients[i]));
      }
    }
    return node.function == Function::sin ? direction.sine : direction.cosine;
  }

  Rational half_tangent(SymbolId symbol) const { return point_.half_tangents[symbols_.angles[0] == symbol ? 0 : 1]; }

  const Graph& graph_;
  const Symbols& symbols_;
  const Point& point_;
  std::unordered_map<std::uint32_t, Maybe> values_;
};

}  // namespace

Maybe exact_value(const Graph& graph, NodeId id, const Symbols& symbols, const Point& point) {
  return ExactReader(graph, symbols, point).value(id);
}

}  // namespace gauss_test
