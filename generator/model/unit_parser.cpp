#include "model/unit_parser.hpp"

#include <fmt/format.h>

#include "model/unit_lexer.hpp"
#include "model/unit_names.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

constexpr int k_deepest_unit = 16;
constexpr const char* k_hint_for_form = "a unit is names with *, / and ^, as kg*m^2/s; 1 is a plain number";

/// unit   = factor { (*|/) factor }
/// factor = primary [ ^ exponent | raised digits ]
class UnitParser {
 public:
  UnitParser(const spec::LocatedText& text, support::Diagnostics& diagnostics)
      : text_(text), tokens_(unit_tokens(text.text)), diagnostics_(diagnostics) {}

  std::optional<Dimension> run() {
    const Dimension dimension = product();
    if (token().kind != UnitTokenKind::end) refuse_rest();
    if (is_faulty_) return std::nullopt;
    return dimension;
  }

 private:
  const UnitToken& token() const { return tokens_[next_]; }
  bool accept(UnitTokenKind kind) { return token().kind == kind ? (++next_, true) : false; }
  std::string written(const UnitToken& token) const { return text_.text.substr(token.begin, token.end - token.begin); }

  /// Ends the unit: all that follows sees its end.
  Dimension refuse(const UnitToken& at, const std::string& message, const std::string& hint) {
    if (!is_faulty_)
      diagnostics_.error(support::code::k_malformed_unit, text_.span_of(at.begin, at.end), message, hint);
    is_faulty_ = true;
    next_ = tokens_.size() - 1;
    return {};
  }

  Dimension product() {
    Dimension result = factor();
    while (token().kind == UnitTokenKind::times || token().kind == UnitTokenKind::divide) {
      const bool divides = tokens_[next_++].kind == UnitTokenKind::divide;
      const Dimension next = factor();
      result = divides ? result / next : result * next;
    }
    return result;
  }

  Dimension factor() {
    const Dimension base = primary();
    if (token().kind == UnitTokenKind::raised) return power(base, tokens_[next_++].value);
    return accept(UnitTokenKind::power) ? power(base, exponent()) : base;
  }

  Dimension primary() {
    const UnitToken at = token();
    if (at.kind == UnitTokenKind::name) return named(at);
    if (at.kind == UnitTokenKind::open) return bracket(at);
    if (at.kind == UnitTokenKind::number) return number(at);
    if (at.kind == UnitTokenKind::other || at.kind == UnitTokenKind::minus) return refuse_other(at);
    const bool is_first = next_ == 0;
    return refuse(at,
                  at.kind == UnitTokenKind::end ? "the unit stops where a name should follow"
                                                : fmt::format("a unit should stand before '{}'", written(at)),
                  is_first && at.kind == UnitTokenKind::divide ? "write 1/s for 'per second'" : k_hint_for_form);
  }

  Dimension named(const UnitToken& at) {
    const auto unit = find_unit(written(at));
    if (!unit) return refuse(at, fmt::format("unknown unit '{}'", written(at)), hint_for_unit(written(at)));
    ++next_;
    return unit->dimension;
  }

  Dimension number(const UnitToken& at) {
    if (written(at) != "1") {
      return refuse(at, fmt::format("the number {} in a unit", written(at)),
                    "numbers are not converted: 1 is the only one in a unit, and a power is written m^2 or m^(1/2)");
    }
    ++next_;
    return {};
  }

  Dimension bracket(const UnitToken& at) {
    if (++depth_ > k_deepest_unit)
      return refuse(at, "the brackets of this unit are too deep", "write out fewer of them");
    ++next_;
    const Dimension inside = product();
    if (!accept(UnitTokenKind::close)) {
      if (token().kind != UnitTokenKind::end) return refuse_rest();
      return refuse(at, "this bracket is never closed", "add ')'");
    }
    --depth_;
    return inside;
  }

  /// 2, -1, (1/2), (-3/2)
  support::Rational exponent() {
    const bool in_brackets = accept(UnitTokenKind::open);
    support::Rational value = accept(UnitTokenKind::minus) ? -1 : 1;
    value = value * digits();
    if (in_brackets && accept(UnitTokenKind::divide)) {
      const support::Rational divisor = digits();
      value = value / divisor;
    }
    if (in_brackets && !accept(UnitTokenKind::close)) refuse_exponent();
    return value;
  }

  /// Never 0 where it could be a divisor: no unit is to the power of 0 either.
  support::Rational digits() {
    const UnitToken& at = token();
    const bool is_small = at.kind == UnitTokenKind::number && at.value > 0;
    if (!is_small) return refuse_exponent();
    return tokens_[next_++].value;
  }

  support::Rational refuse_exponent() {
    refuse(token(), "the exponent of a unit is a whole number or a fraction in brackets", "write m^2, s^-1 or m^(1/2)");
    return 1;
  }

  Dimension refuse_other(const UnitToken& at) {
    return refuse(at, fmt::format("'{}' does not belong in a unit", written(at)),
                  written(at) == "-"    ? "write 1 for a plain number"
                  : written(at) == "**" ? "write ^ for a power"
                                        : k_hint_for_form);
  }

  /// A complete unit stands before the current token, which cannot follow one.
  Dimension refuse_rest() {
    const UnitToken at = token();
    if (at.kind == UnitTokenKind::other || at.kind == UnitTokenKind::minus) return refuse_other(at);
    if (at.kind == UnitTokenKind::close) return refuse(at, "this bracket closes nothing", "remove it, or add its '('");
    const bool is_power = at.kind == UnitTokenKind::number;
    return refuse(at, fmt::format("an operator is missing before '{}'", written(at)),
                  is_power ? fmt::format("write ^{} for a power", written(at)) : "write * for a product");
  }

  const spec::LocatedText& text_;
  std::vector<UnitToken> tokens_;
  support::Diagnostics& diagnostics_;
  std::size_t next_ = 0;
  int depth_ = 0;
  bool is_faulty_ = false;
};

}  // namespace

std::optional<Dimension> parse_unit(const spec::LocatedText& text, support::Diagnostics& diagnostics) {
  return UnitParser(text, diagnostics).run();
}

}  // namespace gaussgen::model
