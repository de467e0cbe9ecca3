#include "emit/taylor.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "emit/literal.hpp"
#include "emit/text.hpp"
#include "passes/share.hpp"
#include "support/assert.hpp"

namespace gaussgen::emit {

using cpp::atom;
using cpp::Expression;
using ir::Rational;
using passes::Series;
using passes::SeriesValue;

namespace {

constexpr std::size_t k_comment_width = 104;
/// Doubles in a register of AVX.
constexpr std::size_t k_lanes = 4;
constexpr int k_most_order = 40;

const char* const k_about =
    "Order k + 1 of the state from order k of its rates. With u_k = u^(k)/k!, and S(a, b) the sum of a_j b_(k-j)\n"
    "over 0 < j < k, which all products have before order k begins:\n"
    "  a b:          a_0 b_k + a_k b_0 + S(a, b)\n"
    "  q = a/b:      (a_k - q_0 b_k - S(q, b)) / b_0\n"
    "  r = sqrt(a):  (a_k - S(r, r)) / (2 r_0)\n"
    "  d y' = f u':  (f_0 u_k + (S(u', f) - S(y', d)) / k) / d_0, where u' has coefficients j u_j: all other "
    "functions\n"
    "(Jorba and Zou, Experimental Mathematics 14 (2005) 99; Griewank and Walther, Evaluating Derivatives, 13.2)";

std::size_t padded(std::size_t columns) { return (columns + k_lanes - 1) / k_lanes * k_lanes; }

std::string place(const char* array, const std::string& row, std::size_t column) {
  return std::string(array) + "[" + row + "][" + std::to_string(column) + "]";
}

}  // namespace

passes::Series series_of(Plan& plan, const std::vector<NodeId>& rates) {
  const Unit& unit = plan.unit;
  const auto varies = [&](SymbolId symbol) {
    const auto is_it = [&](const Entry& entry) { return entry.symbol == symbol; };
    return symbol == unit.time || std::any_of(unit.configuration.begin(), unit.configuration.end(), is_it) ||
           std::any_of(unit.speeds.begin(), unit.speeds.end(), is_it);
  };
  return passes::series_of(plan.graph, rates, varies, unit.time);
}

namespace {

/// What is multiplied by others or itself, each once. Products with a factor in common are beside each other, and have it on the right: what sums several of them
/// at a time reads it once.
struct Factors {
  struct Factor {
    NodeId id;
    bool is_rate;
  };
  std::vector<Factor> all;
  std::vector<std::size_t> left, right, squared;  ///< of each column
  std::vector<std::size_t> column_of_product;

  explicit Factors(const Series& series) {
    using Pair = std::pair<std::size_t, std::size_t>;
    std::vector<Pair> pairs;
    for (const passes::SeriesColumn& column : series.products) {
      const std::size_t first = place_of({column.left, column.is_rate});
      pairs.emplace_back(first, place_of({column.right, false}));
    }
    for (const NodeId root : series.squares) squared.push_back(place_of({root, false}));
    std::vector<std::size_t> uses(all.size());
    for (const auto& [first, second] : pairs) ++uses[first], ++uses[second];
    for (auto& [first, second] : pairs)
      if (uses[first] > uses[second]) std::swap(first, second);
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t product) {
      const std::size_t common = pairs[product].second;
      return std::pair(all.size() - uses[common], common);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    column_of_product.resize(order.size());
    for (const std::size_t product : order) {
      column_of_product[product] = left.size();
      left.push_back(pairs[product].first);
      right.push_back(pairs[product].second);
    }
  }

 private:
  std::size_t place_of(const Factor& factor) {
    const auto place = places_.emplace(std::pair(factor.id.index, factor.is_rate), all.size());
    if (place.second) all.push_back(factor);
    return place.first->second;
  }

  std::map<std::pair<std::uint32_t, bool>, std::size_t> places_;
};

class SeriesWriter {
 public:
  SeriesWriter(const Series& series, const Plan& plan, Body& body, NameScope& scope)
      : series_(series), factors_(series), plan_(plan), body_(body), scope_(scope) {
    for (std::size_t i = 0; i < series.values.size(); ++i) values_.emplace(series.values[i].id.index, i);
    for (std::size_t i = 0; i < factors_.all.size(); ++i)
      stores_[factors_.all[i].id.index].push_back({i, factors_.all[i].is_rate});
  }

  void write(const std::vector<NodeId>& rates) {
    count_uses(rates);
    begin(rates);
    for (const SeriesValue& value : series_.values) define(value);
    add_blank();
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const NodeId rate = passes::unwrapped(plan_.graph, rates[i]);
      const Expression next = varies(rate) ? cpp::product({coefficient(rate), atom("by_next")}) : atom("S(0)");
      add(cpp::Assignment{atom(place("series.values", "k + 1", i)), next});
    }
    if (uses_[time_index()] > 0) add(cpp::Assignment{atom("t_k"), atom("S(0)")});
    body_.add(cpp::Loop{"k", "1", "series.order", std::move(statements_)});
  }

 private:
  struct Store {
    std::size_t factor;
    bool is_rate;
  };

  void add(cpp::Statement statement) { statements_.push_back({std::move(statement)}); }
  void add_blank() { add(cpp::BlankLine{}); }
  bool varies(NodeId id) const { return values_.count(id.index) != 0; }
  std::uint32_t time_index() const {
    for (const SeriesValue& value : series_.values) {
      if (value.kind == SeriesValue::Kind::time) return value.id.index;
    }
    return static_cast<std::uint32_t>(-1);
  }

  void count_uses(const std::vector<NodeId>& rates) {
    for (const NodeId rate : rates) ++uses_[passes::unwrapped(plan_.graph, rate).index];
    for (const auto& [id, stores] : stores_) uses_[id] += static_cast<int>(stores.size());
    for (const SeriesValue& value : series_.values) {
      for (const NodeId operand : value.operands) ++uses_[operand.index];
      for (const SeriesValue::Term& term : value.terms) ++uses_[term.of.index];
    }
  }

  /// Orders 0 and 1, and what begins the loop over the others.
  void begin(const std::vector<NodeId>& rates) {
    body_.blank_line();
    body_.add(cpp::Assignment{atom("series.order"),
                              cpp::call("detail::order_within", {atom("order"), atom("TaylorSeries<S>::most")})});
    cpp::Assignment copy{atom("series.values[0][i]"), atom("state.values[i]")};
    body_.add(cpp::Loop{"i", "0", std::to_string(rates.size()), {cpp::AnyStatement{std::move(copy)}}});
    for (std::size_t i = 0; i < rates.size(); ++i)
      body_.add(cpp::Assignment{atom(place("series.values", "1", i)), body_.value(rates[i])});
    body_.blank_line();
    for (const SeriesValue& value : series_.values) {
      if (value.kind == SeriesValue::Kind::choice)
        conditions_.emplace(value.id.index, body_.define_condition(value.condition, "is_chosen"));
    }
    body_.add(cpp::Comment{k_about});
    body_.add(cpp::Definition{"S", "degree", atom("S(0)")});
    if (uses_[time_index()] > 0) body_.add(cpp::Definition{"S", "t_k", atom("S(1)")});
    add(cpp::Assignment{atom("degree"), cpp::sum({atom("degree"), atom("S(1)")})});
    if (has_rates()) add(cpp::Definition{"const S", "by_degree", cpp::quotient(atom("S(1)"), atom("degree"))});
    add(cpp::Definition{"const S", "by_next", cpp::quotient(atom("S(1)"), cpp::sum({atom("degree"), atom("S(1)")}))});
    sum_up("sums", "crosswise", series_.products.size());
    sum_up("squares", "squares", series_.squares.size());
    add_blank();
  }

  bool has_rates() const {
    return std::any_of(series_.values.begin(), series_.values.end(), [](const SeriesValue& value) {
      const auto has_column = [](const SeriesValue::Term& term) { return term.has_column; };
      return !value.divisor.empty() || std::any_of(value.terms.begin(), value.terms.end(), has_column);
    });
  }

  void sum_up(const std::string& name, const std::string& function, std::size_t count) {
    if (count == 0) return;
    add(cpp::Declaration{"S", {name + "[" + std::to_string(padded(count)) + "]"}});
    add(cpp::Evaluation{cpp::call("detail::" + function, {atom("series"), atom("k"), atom(name)})});
  }

  // ---- Values

  void define(const SeriesValue& value) {
    using Of = SeriesValue::Kind;
    const bool is_short = value.kind == Of::sum || value.kind == Of::scaled;
    if (uses_[value.id.index] == 0) return;
    if (value.kind == Of::time) {
      named_.emplace(value.id.index, "t_k");
    } else if (!is_short || uses_[value.id.index] > 1) {
      const std::string name = scope_.allocate(name_of(value.id) + "_k");
      add(cpp::Definition{"const S", name, formula(value)});
      named_.emplace(value.id.index, name);
    }
    const auto stores = stores_.find(value.id.index);
    if (stores == stores_.end()) return;
    store(value.id, stores->second);
  }

  void store(NodeId id, const std::vector<Store>& stores) {
    for (const Store& one : stores) {
      Expression value = one.is_rate ? cpp::product({atom("degree"), coefficient(id)}) : coefficient(id);
      add(cpp::Evaluation{cpp::call("detail::set_factor<" + std::to_string(one.factor) + ">",
                                    {atom("series"), atom("k"), std::move(value)})});
    }
  }

  std::string name_of(NodeId id) {
    const Expression at_start = body_.value(id);
    const std::string& text = at_start.text;
    const bool is_name = at_start.kind == Expression::Kind::atom && text.find_first_of(".(:[") == std::string::npos;
    if (is_name) return text;
    const std::string natural = body_.natural_name_for(id);
    return natural.empty() ? scope_.allocate_anonymous("u") : natural;
  }

  /// Of order k; of what varies.
  Expression coefficient(NodeId id) const {
    if (const auto name = named_.find(id.index); name != named_.end()) return atom(name->second);
    return formula(series_.values[values_.at(id.index)]);
  }

  Expression at_start(NodeId id) const { return body_.value(id); }

  Expression formula(const SeriesValue& value) const {
    using Of = SeriesValue::Kind;
    const ir::Children& of = value.operands;
    switch (value.kind) {
      case Of::time: return atom("t_k");
      case Of::state: return atom(place("series.values", "k", component(value.id)));
      case Of::sum: return sum(value);
      case Of::scaled: return cpp::product({at_start(of[0]), coefficient(of[1])});
      case Of::product:
        return cpp::sum({sums(value.column), cpp::product({at_start(of[1]), coefficient(of[0])}),
                         cpp::product({at_start(of[0]), coefficient(of[1])})});
      case Of::square: {
        const Expression root = at_start(of[0]);
        return cpp::sum({squares(value.column), cpp::product({cpp::sum({root, root}), coefficient(of[0])})});
      }
      case Of::quotient: return quotient(value);
      case Of::square_root:
        return cpp::product(
            {cpp::sum({coefficient(of[0]), cpp::negated(squares(value.column))}), at_start(value.inverse)});
      case Of::rates: return rates(value);
      case Of::choice:
        return cpp::call("Math<S>::select",
                         {conditions_.at(value.id.index), coefficient_or_zero(of[0]), coefficient_or_zero(of[1])});
    }
    return {};
  }

  Expression coefficient_or_zero(NodeId id) const { return varies(id) ? coefficient(id) : atom("S(0)"); }

  Expression sums(std::size_t product) const {
    return atom("sums[" + std::to_string(factors_.column_of_product[product]) + "]");
  }
  static Expression squares(std::size_t column) { return atom("squares[" + std::to_string(column) + "]"); }

  std::size_t component(NodeId id) const {
    const SymbolId symbol = plan_.graph[id].symbol;
    const auto is_it = [&](const Entry& entry) { return entry.symbol == symbol; };
    const std::vector<Entry>&q = plan_.unit.configuration, &u = plan_.unit.speeds;
    const auto coordinate = std::find_if(q.begin(), q.end(), is_it);
    if (coordinate != q.end()) return static_cast<std::size_t>(coordinate - q.begin());
    return q.size() + static_cast<std::size_t>(std::find_if(u.begin(), u.end(), is_it) - u.begin());
  }

  static Expression times(const Rational& factor, Expression value) {
    const Rational size = cln::abs(factor);
    if (size != 1) value = cpp::product({literal(size), std::move(value)});
    return factor < 0 ? cpp::negated(std::move(value)) : value;
  }

  /// What is subtracted does not stand first where something else may.
  static Expression added(std::vector<Expression> terms) {
    const auto positive = std::find_if(terms.begin(), terms.end(),
                                       [](const Expression& term) { return term.kind != Expression::Kind::negation; });
    if (positive != terms.end()) std::rotate(terms.begin(), positive, positive + 1);
    return cpp::sum(std::move(terms));
  }

  Expression sum(const SeriesValue& value) const {
    std::vector<Expression> terms;
    for (std::size_t i = 0; i < value.operands.size(); ++i)
      terms.push_back(times(value.coefficients[i], coefficient(value.operands[i])));
    return added(std::move(terms));
  }

  Expression quotient(const SeriesValue& value) const {
    const NodeId above = value.operands[0], below = value.operands[1];
    std::vector<Expression> terms;
    if (varies(above)) terms.push_back(coefficient(above));
    terms.push_back(cpp::negated(sums(value.column)));
    terms.push_back(cpp::negated(cpp::product({at_start(value.id), coefficient(below)})));
    return cpp::product({cpp::sum(std::move(terms)), at_start(value.inverse)});
  }

  Expression rates(const SeriesValue& value) const {
    std::vector<Expression> terms, inner;
    for (const SeriesValue::Term& term : value.terms) {
      if (term.has_column) inner.push_back(times(term.coefficient, sums(term.column)));
      if (!varies(term.of)) continue;
      const bool is_one = plan_.graph.is_one(term.factor);
      Expression product = is_one ? coefficient(term.of) : cpp::product({at_start(term.factor), coefficient(term.of)});
      terms.push_back(times(term.coefficient, std::move(product)));
    }
    if (!value.divisor.empty()) inner.push_back(cpp::negated(sums(value.column)));
    if (!inner.empty()) terms.insert(terms.begin(), cpp::product({added(std::move(inner)), atom("by_degree")}));
    Expression result = added(std::move(terms));
    if (value.divisor.empty()) return result;
    return cpp::product({std::move(result), at_start(value.inverse)});
  }

  const Series& series_;
  Factors factors_;
  const Plan& plan_;
  Body& body_;
  NameScope& scope_;
  std::map<std::uint32_t, std::size_t> values_;
  std::map<std::uint32_t, std::vector<Store>> stores_;
  std::map<std::uint32_t, int> uses_;
  std::map<std::uint32_t, std::string> named_;
  std::map<std::uint32_t, Expression> conditions_;
  std::vector<cpp::AnyStatement> statements_;
};

}  // namespace

void write_series(const Series& series, const Plan& plan, const std::vector<NodeId>& rates, Body& body,
                  NameScope& scope) {
  GAUSS_ASSERT(series.edges.empty(), "{} values have edges", series.edges.size());
  SeriesWriter(series, plan, body, scope).write(rates);
}

void reserve_names_of_series(NameScope& scope) {
  for (const char* name :
       {"TaylorSeries", "series", "order", "degree", "by_degree", "by_next", "sums", "squares", "k", "i", "t_k"})
    scope.reserve(name);
}

cpp::Struct series_struct(const Series& series) {
  cpp::Struct type;
  type.comment = wrapped(
      "Power series of the state from one time on: x(t + h) = sum of values[k] h^k over k = 0 to order. A large "
      "object: keep it from "
      "step to step.",
      k_comment_width);
  type.name = "TaylorSeries";
  type.members.push_back({"static constexpr int", "most", {}, atom(std::to_string(k_most_order)), "highest order"});
  type.members.push_back({"int", "order", {}, atom("0"), {}});
  const std::string rows = "most + 1";
  type.members.push_back({"S", "values", {rows, "n_q + n_v"}, std::nullopt, "of the state in its order: x^(k) / k!"});
  const Factors factors(series);
  const auto table = [&](const char* name, const std::vector<std::size_t>& of) {
    if (of.empty()) return;
    std::vector<Expression> numbers;
    for (const std::size_t factor : of) numbers.push_back(atom(std::to_string(factor)));
    type.members.push_back(
        {"static constexpr short", name, {std::to_string(of.size())}, cpp::list(std::move(numbers)), {}});
  };
  table("left", factors.left);
  table("right", factors.right);
  table("squared", factors.squared);
  const auto count = [](const auto& of) { return std::to_string(of.size()); };
  if (!factors.all.empty())
    type.members.push_back({"detail::SeriesFactors<S, most + 1, " + count(factors.all) + ", " + count(factors.left) +
                                ", " + count(factors.squared) + ">",
                            "factors",
                            {},
                            std::nullopt,
                            "scratch space: left with right, squared with themselves"});
  return type;
}

}  // namespace gaussgen::emit
