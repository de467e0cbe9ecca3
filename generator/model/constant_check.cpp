#include "model/constant_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "model/constant.hpp"
#include "model/evaluate.hpp"
#include "model/number.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using support::Rational;

namespace {

/// Below this a value computed from pi counts as zero: sin(pi) in double is 1.2e-16.
constexpr double k_rounding = 1e-14;

constexpr const char* k_hint_for_zero_base = "correct the base: it is zero whatever the motion";

/// What is known of a part: exact when it is made of numbers alone, approximate when pi or a function is in it.
struct Constant {
  std::optional<Rational> exact;
  std::optional<double> approximate;

  bool known() const { return approximate.has_value(); }
  bool is_zero() const { return exact ? cln::zerop(*exact) : known() && std::abs(*approximate) < k_rounding; }
  bool is_negative() const { return exact ? cln::minusp(*exact) : known() && *approximate < -k_rounding; }
  bool exceeds_one() const { return exact ? cln::abs(*exact) > 1 : known() && std::abs(*approximate) > 1 + k_rounding; }
};

Constant constant(const Rational& value) { return {value, support::to_double(value)}; }

class ConstantCheck {
 public:
  explicit ConstantCheck(support::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  bool good() const { return good_; }

  Constant visit(const Ast& ast) {
    if (ast.kind == AstKind::number) return finite(ast, constant(ast.number));
    if (ast.kind == AstKind::symbol) return ast.name == "pi" ? Constant{std::nullopt, std::acos(-1.0)} : Constant{};
    std::vector<Constant> parts;
    for (const Ast& child : ast.children) parts.push_back(visit(child));
    if (!good_ || ast.kind == AstKind::comparison) return {};
    switch (ast.kind) {
      case AstKind::negate: return negated(parts[0]);
      case AstKind::reciprocal: return reciprocal(ast, parts[0]);
      case AstKind::power: return power(ast, parts[0], *parts[1].exact);
      case AstKind::call: return call(ast, parts);
      default: return combined(ast, parts);
    }
  }

 private:
  Constant refuse(const Ast& ast, const support::ErrorCode& code, std::string message, std::string hint) {
    if (good_) diagnostics_.error(code, ast.span, std::move(message), std::move(hint));
    good_ = false;
    return {};
  }

  Constant finite(const Ast& ast, Constant value) {
    if (!value.known()) return value;
    const bool lost = value.exact && !cln::zerop(*value.exact) && *value.approximate == 0.0;
    if (std::isfinite(*value.approximate) && !lost) return value;
    return refuse(ast, code::k_not_finite, lost ? k_too_small : k_too_large, k_hint_for_range);
  }

  static Constant negated(const Constant& part) {
    if (part.exact) return constant(-*part.exact);
    return part.known() ? Constant{std::nullopt, -*part.approximate} : Constant{};
  }

  Constant reciprocal(const Ast& ast, const Constant& part) {
    if (part.is_zero())
      return refuse(ast.children[0], code::k_undefined_value, "division by zero",
                    "correct the divisor: it is zero whatever the motion");
    if (part.exact) return finite(ast, constant(cln::recip(*part.exact)));
    return part.known() ? finite(ast, {std::nullopt, 1.0 / *part.approximate}) : Constant{};
  }

  Constant power(const Ast& ast, const Constant& base, const Rational& exponent) {
    if (cln::minusp(exponent) && base.is_zero())
      return refuse(ast, code::k_undefined_value, "a negative power of zero", k_hint_for_zero_base);
    if (cln::zerop(exponent) && base.is_zero())
      return refuse(ast, code::k_undefined_value, "zero to the power of zero", k_hint_for_zero_base);
    if (!support::is_integer(exponent) && base.is_negative()) {
      return refuse(ast, code::k_undefined_value, "a fractional power of a negative number is not real",
                    "correct the sign of the base; the cube root of -8 is written -(8^(1/3))");
    }
    if (base.exact && support::is_integer(exponent))
      return finite(ast, constant(cln::expt(*base.exact, support::to_int(exponent))));
    return base.known() ? finite(ast, {std::nullopt, std::pow(*base.approximate, support::to_double(exponent))})
                        : Constant{};
  }

  Constant call(const Ast& ast, const std::vector<Constant>& parts) {
    if (const auto exact = exact_value(ast)) return finite(ast, constant(*exact));
    const std::string& name = ast.name;
    const Constant& x = parts[0];
    if (name == "log" && (x.is_negative() || x.is_zero()))
      return refuse(ast, code::k_undefined_value, "the logarithm of a number that is not positive",
                    "correct the argument: it has to be positive");
    if (name == "sqrt" && x.is_negative())
      return refuse(ast, code::k_undefined_value, "the square root of a negative number is not real",
                    "correct the argument: it has to be zero or positive");
    if ((name == "asin" || name == "acos") && x.exceeds_one()) {
      return refuse(ast, code::k_undefined_value, fmt::format("'{}' of a number beyond 1 is not real", name),
                    "correct the argument: it has to be from -1 to 1");
    }
    if (name == "tan" && x.known() && std::abs(std::cos(*x.approximate)) < k_rounding) {
      return refuse(ast, code::k_undefined_value, "the tangent has no value here",
                    "correct the angle: it is an odd multiple of pi/2");
    }
    if (name == "atan2" && x.is_zero() && parts[1].is_zero())
      return refuse(ast, code::k_undefined_value, "atan2(0, 0) has no value",
                    "correct the arguments: one of them has to differ from zero");
    const auto value = value_of(ast, {{"pi", std::acos(-1.0)}});
    return finite(ast, {std::nullopt, value});
  }

  /// Numbers inside a sum or product meet each other even where other terms hold symbols.
  Constant combined(const Ast& ast, const std::vector<Constant>& parts) {
    const bool is_sum = ast.kind == AstKind::sum;
    Rational exact = is_sum ? 0 : 1;
    double approximate = is_sum ? 0.0 : 1.0;
    bool all_exact = true, all_known = true;
    for (const Constant& part : parts) {
      if (part.exact) exact = is_sum ? exact + *part.exact : exact * *part.exact;
      if (part.known()) approximate = is_sum ? approximate + *part.approximate : approximate * *part.approximate;
      all_exact = all_exact && part.exact;
      all_known = all_known && part.known();
    }
    finite(ast, constant(exact));
    if (!good_) return {};
    if (all_exact) return constant(exact);
    return all_known ? finite(ast, {std::nullopt, approximate}) : Constant{};
  }

  support::Diagnostics& diagnostics_;
  bool good_ = true;
};

}  // namespace

bool check_constants(const Ast& ast, support::Diagnostics& diagnostics) {
  ConstantCheck check(diagnostics);
  check.visit(ast);
  return check.good();
}

}  // namespace gaussgen::model
