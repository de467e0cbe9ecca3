#include "model/inference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "model/constant.hpp"
#include "model/functions.hpp"

namespace gaussgen::model {

namespace code = support::code;
using Kind = Measure::Kind;

namespace {

constexpr std::size_t k_longest_quotation = 40;
using Term = Inference::Term;

bool is_short(const std::string& text) {
  return !text.empty() && text.size() <= k_longest_quotation && text.find('\n') == std::string::npos;
}

/// Of -a and - a: a.
const Ast& without_sign(const Ast& ast) { return ast.kind == AstKind::negate ? without_sign(ast.children[0]) : ast; }

bool is_zero(const Ast& ast) {
  const auto value = exact_value(ast);
  return value && *value == 0;
}

/// Whether it says anything about the unit of a sum that it stands in: a zero does not.
bool counts(const Term& term) {
  return term.measure.kind == Kind::known || (term.measure.kind == Kind::literal && !is_zero(*term.ast));
}

Dimension dimension_of(const Term& term) {
  return term.measure.kind == Kind::known ? term.measure.dimension : Dimension{};
}

/// The terms of a sum in one dimension.
struct Group {
  Dimension dimension;
  const Term* first;
  bool is_known = false;  ///< not numbers alone
  int terms = 0;
};

std::vector<Group> grouped(const std::vector<Term>& terms) {
  std::vector<Group> groups;
  for (const Term& term : terms) {
    if (!counts(term)) continue;
    const Dimension dimension = dimension_of(term);
    const auto is_same = [&](const Group& group) { return agree(group.dimension, dimension); };
    auto group = std::find_if(groups.begin(), groups.end(), is_same);
    if (group == groups.end()) group = groups.insert(group, {dimension, &term});
    const bool is_known = term.measure.kind == Kind::known;
    if (is_known && !group->is_known) group->first = &term;
    group->is_known = group->is_known || is_known;
    ++group->terms;
  }
  return groups;
}

/// What the others are held against: the wanted dimension, else that which most terms have; a number gives way.
const Group* reference_of(const std::vector<Group>& groups, const Dimension* wanted) {
  const Group* best = nullptr;
  for (const Group& group : groups) {
    if (!group.is_known) continue;
    if (wanted != nullptr && agree(group.dimension, *wanted)) return &group;
    if (best == nullptr || group.terms > best->terms) best = &group;
  }
  return best;
}

Kind kind_of_all(const std::vector<Term>& terms) {
  const bool literal =
      std::all_of(terms.begin(), terms.end(), [](const Term& t) { return t.measure.kind == Kind::literal; });
  return literal ? Kind::literal : Kind::unknown;
}

constexpr std::array<const char*, 3> k_of_angles = {"sin", "cos", "tan"};
constexpr std::array<const char*, 3> k_to_angles = {"asin", "acos", "atan"};

template <class List>
bool is_in(const List& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

Measure angle() {
  Dimension dimension;
  dimension.angle = 1;
  return known(dimension);
}

/// With the user's word for the unit where a factor of numbers alone is all that is added.
Measure times(const Measure& a, const Measure& b) {
  if (a.kind == Kind::literal) return b;
  if (b.kind == Kind::literal) return a;
  if (a.kind == Kind::unknown || b.kind == Kind::unknown) return {};
  return known(a.dimension * b.dimension);
}

Measure raised(const Measure& base, const support::Rational& exponent) {
  return base.kind == Kind::known ? known(power(base.dimension, exponent)) : base;
}

}  // namespace

std::string Inference::quoted(const Ast& ast, const std::string& otherwise) const {
  const std::string text(source_.text(ast.span));
  return is_short(text) ? "'" + text + "'" : otherwise;
}

void Inference::report(const support::ErrorCode& code, const Ast& at, std::string message, std::string hint) {
  if (reported_.insert(at.span.begin).second) diagnostics_.error(code, at.span, std::move(message), std::move(hint));
}

Measure Inference::operator()(const Ast& ast, const Dimension* wanted) {
  switch (ast.kind) {
    case AstKind::number: return {Kind::literal};
    case AstKind::symbol: return measure_of(model_, ast.name);
    case AstKind::negate: return (*this)(ast.children[0], wanted);
    case AstKind::sum: return sum(ast, wanted);
    case AstKind::product: return product(ast);
    case AstKind::reciprocal: return raised((*this)(ast.children[0]), -1);
    case AstKind::power: return raised((*this)(ast.children[0]), ast.children[1].number);
    case AstKind::call: return call(ast, wanted);
    case AstKind::comparison: return comparison(ast);
  }
  return {};
}

Measure Inference::sum(const Ast& ast, const Dimension* wanted) {
  std::vector<Term> terms;
  for (const Ast& child : ast.children) terms.push_back({&without_sign(child), (*this)(child, wanted)});
  // The sum of a shorthand is none of the user's.
  return shared(terms, wanted, ast.is_derived ? nullptr : "sum");
}

/// Nothing follows from a condition.
Measure Inference::comparison(const Ast& ast) {
  std::vector<Term> sides;
  for (const Ast& child : ast.children) sides.push_back({&child, (*this)(child)});
  shared(sides, nullptr, "comparison");
  return {};
}

/// min and max
Measure Inference::extreme(const Ast& ast, const Dimension* wanted) {
  std::vector<Term> arguments;
  for (const Ast& child : ast.children) arguments.push_back({&child, (*this)(child, wanted)});
  return shared(arguments, wanted, ast.name == "min" ? "min(...)" : "max(...)");
}

Measure Inference::cases(const Ast& ast, const Dimension* wanted) {
  std::vector<Term> values;
  for (const Ast& child : ast.children) {
    if (child.kind == AstKind::comparison)
      comparison(child);
    else
      values.push_back({&child, (*this)(child, wanted)});
  }
  return shared(values, wanted, "piecewise(...)");
}

Measure Inference::shared(const std::vector<Term>& terms, const Dimension* wanted, const char* whole) {
  const std::vector<Group> groups = grouped(terms);
  const Group* reference = reference_of(groups, wanted);
  if (reference == nullptr) return {kind_of_all(terms)};
  // One message for all terms that are wrong in the same way.
  for (const Group& group : groups) {
    if (&group != reference && whole != nullptr) report_unlike(*group.first, *reference->first, whole);
  }
  return groups.size() > 1 ? Measure{} : reference->first->measure;
}

void Inference::report_unlike(const Term& term, const Term& reference, const char* whole) {
  const bool is_literal = term.measure.kind == Kind::literal;
  diagnostics_.error(
      code::k_unlike_terms, term.ast->span,
      fmt::format("{} is {}, and {} in the same {} is {}", quoted(*term.ast, "this term"), phrase(term.measure),
                  quoted(*reference.ast, "another term"), whole, phrase(reference.measure)),
      is_literal ? fmt::format("declare a parameter with a unit for it, as in '{}: {{value: {}, unit: {}}}'",
                               free_name(), literal_text(*term.ast), unit_of(reference.measure))
                 : units_of_names(model_, {term.ast, reference.ast}));
}

std::string Inference::free_name() const {
  std::string name = "a";
  while (is_taken(name)) name = name == "z" ? "a1" : name.size() == 1 ? std::string(1, ++name.front()) : name + "1";
  return name;
}

/// In the file of a submodel, names have that of the submodel in front.
bool Inference::is_taken(const std::string& name) const {
  const auto is_same = [&](const std::string& other) {
    const std::size_t size = name.size();
    return other == name || (other.size() > size + 1 && other.substr(other.size() - size - 1) == "_" + name);
  };
  return is_reserved(name) ||
         std::any_of(model_.symbols.begin(), model_.symbols.end(), [&](const auto& of) { return is_same(of.first); }) ||
         std::any_of(model_.tables.begin(), model_.tables.end(),
                     [&](const Table& of) { return is_same(of.name.text); });
}

std::string Inference::literal_text(const Ast& ast) const {
  const std::string text(source_.text(ast.span));
  return is_short(text) ? text : "0.5";
}

Measure Inference::product(const Ast& ast) {
  Measure result{Kind::literal};
  for (const Ast& child : ast.children) result = times(result, (*this)(child));
  return result;
}

Measure Inference::call(const Ast& ast, const Dimension* wanted) {
  if (ast.table != nullptr) return table(ast);
  if (ast.name == "atan2") return atan2(ast);
  if (ast.name == "abs") return (*this)(ast.children[0], wanted);
  if (ast.name == "min" || ast.name == "max") return extreme(ast, wanted);
  if (ast.name == k_piecewise) return cases(ast, wanted);
  if (ast.name == "sqrt") return raised((*this)(ast.children[0]), support::Rational(1) / 2);
  if (ast.name == k_dot) {
    const Measure inner = (*this)(ast.children[0]);
    return inner.kind == Kind::known ? known(inner.dimension / measure_of(model_, "t").dimension) : Measure{};
  }
  return function(ast);
}

/// Of one argument, a plain number or an angle; only `sign` takes anything.
Measure Inference::function(const Ast& ast) {
  const Measure argument = (*this)(ast.children[0]);
  if (argument.kind == Kind::literal) return argument;
  if (ast.name == "sign") return known({});
  if (argument.kind == Kind::known && !is_number(argument.dimension)) {
    diagnostics_.error(
        code::k_argument_dimension, ast.children[0].span,
        fmt::format("'{}' takes {}, and this is {}", ast.name,
                    is_in(k_of_angles, ast.name) ? "an angle in rad" : "a plain number", phrase(argument)),
        hint_for_argument(ast, argument));
  }
  return is_in(k_to_angles, ast.name) ? angle() : known({});
}

/// In sin(2*t) the 2 has a unit, too.
std::string Inference::hint_for_argument(const Ast& call, const Measure& argument) const {
  const Measure wanted = is_in(k_of_angles, call.name) ? angle() : known({});
  const std::string factor = unit_of(known(wanted.dimension / argument.dimension));
  const std::string names = units_of_names(model_, {&call.children[0]});
  return names + (names.empty() ? "" : "; ") + fmt::format("multiply it by a parameter in {}", factor);
}

Measure Inference::table(const Ast& ast) {
  const auto found = std::find_if(model_.tables.begin(), model_.tables.end(),
                                  [&](const Table& table) { return table.function == ast.table; });
  const Measure wanted = found == model_.tables.end() ? Measure{} : measure_of_argument(*found);
  const bool is_free = wanted.kind != Kind::known;
  const Measure argument = (*this)(ast.children[0], is_free ? nullptr : &wanted.dimension);
  if (!is_free && argument.kind == Kind::known && !agree(argument.dimension, wanted.dimension)) {
    report(
        code::k_argument_dimension, ast.children[0],
        fmt::format("the argument of the table '{}' is {}, and this is {}", ast.name, phrase(wanted), phrase(argument)),
        units_of_names(model_, {&ast.children[0]}));
  }
  return measure_of(model_, ast.name);
}

/// Both arguments in one unit, as the sides of a triangle.
Measure Inference::atan2(const Ast& ast) {
  const Term first{&ast.children[0], (*this)(ast.children[0])};
  const Term second{&ast.children[1], (*this)(ast.children[1])};
  const bool both_literal = first.measure.kind == Kind::literal && second.measure.kind == Kind::literal;
  if (both_literal) return first.measure;
  if (counts(first) && counts(second) && !agree(dimension_of(first), dimension_of(second))) {
    report(code::k_argument_dimension, *second.ast,
           fmt::format("'atan2' takes two quantities of one unit: the first is {}, and this is {}",
                       phrase(first.measure), phrase(second.measure)),
           units_of_names(model_, {first.ast, second.ast}));
  }
  return angle();
}

}  // namespace gaussgen::model
