// Hz and rad/s are both 1/s to whoever checks dimensions, and a turn apart: in sin(f*t) a factor 2*pi is missing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/checks.hpp"
#include "model/evaluate.hpp"
#include "model/expressions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

/// Of factors that a product of sums may make.
constexpr std::size_t k_most_terms = 64;
constexpr int k_deepest = 64;

/// How far 6.28 and 3.14 are from quarters of a turn, in quarters.
constexpr double k_rounding = 0.02;

/// One term of an argument, as far as it says whether turns are taken for radians.
struct Term {
  double number = 1;      ///< what plain numbers in it make, those of parameters too
  std::string frequency;  ///< the name in Hz in it; empty for none
};

using Terms = std::optional<std::vector<Term>>;

bool is_plain(const std::optional<Dimension>& dimension) { return !dimension || is_number(*dimension); }

/// Multiples of a quarter turn are what people write: 2*pi*f, pi*f for a half of it, 4*pi*f for twice.
bool is_in_radians(double number) {
  const double quarters = std::abs(number) / std::acos(0.0);
  return std::round(quarters) >= 1 && std::abs(quarters - std::round(quarters)) < k_rounding;
}

/// Takes an argument apart into terms. Nothing comes of what is not understood, and then nothing is said.
class TurnsIn {
 public:
  explicit TurnsIn(const Model& model) : model_(model) {}

  Terms terms(const Ast& ast, int depth = 0) const {
    if (depth > k_deepest) return std::nullopt;
    if (const auto number = value_of(ast, k_pi)) return plain(*number);
    switch (ast.kind) {
      case AstKind::symbol: return symbol(ast.name, depth);
      case AstKind::negate: return terms(ast.children[0], depth + 1);
      case AstKind::sum: return sum(ast, depth);
      case AstKind::product: return product(ast, depth);
      case AstKind::reciprocal: return raised(ast.children[0], -1, depth);
      case AstKind::power: return raised(ast.children[0], support::to_double(ast.children[1].number), depth);
      default: return std::nullopt;
    }
  }

 private:
  static Terms plain(double value) {
    if (!std::isfinite(value)) return std::nullopt;
    return std::vector<Term>{{value, ""}};
  }

  /// What has another dimension, as a time has, does not change what is missing.
  static Terms of_dimension(const std::optional<Dimension>& dimension) {
    if (is_plain(dimension)) return std::nullopt;
    return std::vector<Term>{Term{}};
  }

  Terms symbol(const std::string& name, int depth) const {
    const auto found = model_.symbols.find(name);
    if (found == model_.symbols.end()) return std::nullopt;
    const std::size_t index = found->second.index;
    switch (found->second.kind) {
      case SymbolKind::time:
      case SymbolKind::place: return std::vector<Term>{Term{}};
      case SymbolKind::parameter: return parameter(model_.parameters[index], depth);
      case SymbolKind::input: return named(model_.inputs[index], of_dimension(model_.inputs[index].dimension));
      case SymbolKind::coordinate: return of_dimension(model_.coordinates[index].dimension);
      default: return std::nullopt;
    }
  }

  template <class Owner>
  static Terms named(const Owner& owner, Terms otherwise) {
    if (owner.unit == "Hz") return std::vector<Term>{{1, owner.name.text}};
    return otherwise;
  }

  Terms parameter(const Parameter& parameter, int depth) const {
    if (parameter.unit == "Hz") return named(parameter, std::nullopt);
    if (parameter.is_formula) return terms(parameter.value, depth + 1);
    const auto number = value_of(parameter.value, k_pi);
    return is_plain(parameter.dimension) && number ? plain(*number) : of_dimension(parameter.dimension);
  }

  Terms sum(const Ast& ast, int depth) const {
    std::vector<Term> all;
    for (const Ast& child : ast.children) {
      const Terms more = terms(child, depth + 1);
      if (!more || all.size() + more->size() > k_most_terms) return std::nullopt;
      all.insert(all.end(), more->begin(), more->end());
    }
    return all;
  }

  Terms product(const Ast& ast, int depth) const {
    std::vector<Term> all{Term{}};
    for (const Ast& child : ast.children) {
      const Terms more = terms(child, depth + 1);
      if (!more || all.size() * more->size() > k_most_terms) return std::nullopt;
      std::vector<Term> products;
      for (const Term& a : all) {
        for (const Term& b : *more) {
          if (!a.frequency.empty() && !b.frequency.empty()) return std::nullopt;
          products.push_back({a.number * b.number, a.frequency + b.frequency});
        }
      }
      all = std::move(products);
    }
    return all;
  }

  /// A frequency below the line, as in f/f_0, leaves a ratio.
  Terms raised(const Ast& base, double exponent, int depth) const {
    const Terms of = terms(base, depth + 1);
    if (!of || of->size() != 1 || !of->front().frequency.empty()) return std::nullopt;
    return plain(std::pow(of->front().number, exponent));
  }

  const Values k_pi{{"pi", std::acos(-1.0)}};
  const Model& model_;
};

class FrequencyCheck {
 public:
  explicit FrequencyCheck(Reading& reading) : reading_(reading), turns_(reading.model) {}

  void check(const Ast& ast) {
    for (const Ast& child : ast.children) check(child);
    const bool is_of_angle = ast.name == "sin" || ast.name == "cos" || ast.name == "tan";
    if (ast.kind != AstKind::call || ast.table != nullptr || !is_of_angle) return;
    const Terms terms = turns_.terms(ast.children[0]);
    if (!terms) return;
    const auto missing = std::find_if(terms->begin(), terms->end(), [](const Term& term) {
      return !term.frequency.empty() && !is_in_radians(term.number);
    });
    if (missing != terms->end()) report(ast, missing->frequency);
  }

 private:
  void report(const Ast& call, const std::string& frequency) {
    reading_.diagnostics.warning(
        support::code::k_scaled_unit, call.children[0].span,
        fmt::format("'{}' is in Hz, and '{}' takes radians: turns are not converted", frequency, call.name),
        fmt::format("write 2*pi*{} for the angular velocity; one that is given as such is in rad/s", frequency));
  }

  Reading& reading_;
  TurnsIn turns_;
};

}  // namespace

void check_frequencies(Reading& reading) {
  FrequencyCheck frequencies(reading);
  for_each_expression(reading.model, [&](const Ast& ast, const Place&) { frequencies.check(ast); });
}

}  // namespace gaussgen::model
