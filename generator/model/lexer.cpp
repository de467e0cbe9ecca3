#include "model/lexer.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "model/character_name.hpp"
#include "model/functions.hpp"
#include "model/number.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::model {

namespace code = support::code;

using support::is_digit;
using support::is_letter;

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::optional<TokenKind> sign(char c) {
  switch (c) {
    case '+': return TokenKind::plus;
    case '-': return TokenKind::minus;
    case '*': return TokenKind::times;
    case '/': return TokenKind::divide;
    case '^': return TokenKind::power;
    case '(': return TokenKind::open;
    case ')': return TokenKind::close;
    case ',': return TokenKind::comma;
    case '<': return TokenKind::less;
    case '>': return TokenKind::greater;
    default: return std::nullopt;
  }
}

class Lexer {
 public:
  Lexer(const spec::LocatedText& text, support::Diagnostics& diagnostics) : text_(text), diagnostics_(diagnostics) {}

  Tokens run() {
    bool is_cut = false;
    while (!is_cut && skip_blanks()) is_cut = tokens_.size() < k_most_tokens ? !next() : !too_many();
    if (is_cut) drop_part();
    tokens_.push_back({TokenKind::end, at_, at_, {}, 0});
    return {std::move(tokens_), is_cut};
  }

 private:
  /// Of `x'` the x would be another name.
  void drop_part() {
    if (tokens_.empty() || tokens_.back().end != at_) return;
    const TokenKind kind = tokens_.back().kind;
    if (kind == TokenKind::name || kind == TokenKind::number) tokens_.pop_back();
  }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.text.size() ? text_.text[at_ + ahead] : '\0'; }

  bool skip_blanks() {
    while (at_ < text_.text.size() && is_blank(peek())) ++at_;
    return at_ < text_.text.size();
  }

  bool next() {
    const char c = peek();
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
    if (is_letter(c)) return name();
    if (c == '*' && peek(1) == '*')
      return refuse(code::k_unexpected_character, 2, "'**' is not an operator", "write ^ for a power");
    if (peek(1) == '=' && (c == '=' || c == '!') && text_.text.find(k_piecewise) != std::string::npos)
      return refuse(code::k_unexpected_character, 2, fmt::format("'{}=' is not an operator", c),
                    "conditions of piecewise(...) are comparisons by <, <=, > and >=");
    if (peek(1) == c && (c == '&' || c == '|'))
      return refuse(code::k_unexpected_character, 2, fmt::format("'{0}{0}' does not join conditions", c),
                    "write piecewise(a < b, piecewise(c < d, x, y), y) for x where both hold, else y");
    const bool is_comparison = c == '<' || c == '>';
    if (is_comparison && peek(1) == '=') {
      push(c == '<' ? TokenKind::at_most : TokenKind::at_least, 2);
      return true;
    }
    if (const auto kind = sign(c)) {
      push(*kind, 1);
      return true;
    }
    return unexpected();
  }

  bool number() {
    NumberScan scan = scan_number(std::string_view(text_.text).substr(at_));
    if (!scan.problem.empty()) return refuse(*scan.code, scan.size, scan.problem, scan.hint);
    push(TokenKind::number, scan.size);
    tokens_.back().number = std::move(scan.value);
    return true;
  }

  bool name() {
    std::size_t size = 1;
    while (is_letter(peek(size)) || is_digit(peek(size)) || peek(size) == '_') ++size;
    // A component of a place, as in tip.x.
    if (peek(size) == '.' && is_letter(peek(size + 1))) {
      for (++size; is_letter(peek(size)) || is_digit(peek(size)) || peek(size) == '_';) ++size;
    }
    std::string text = text_.text.substr(at_, size);
    push(TokenKind::name, size);
    tokens_.back().name = std::move(text);
    return true;
  }

  void push(TokenKind kind, std::size_t size) {
    tokens_.push_back({kind, at_, at_ + size, {}, 0});
    at_ += size;
  }

  bool unexpected() {
    if (peek() == '.' && is_letter(peek(1))) {
      const bool is_behind_name =
          !tokens_.empty() && tokens_.back().kind == TokenKind::name && tokens_.back().end == at_;
      if (is_behind_name)
        return refuse(
            code::k_unexpected_character, 1, fmt::format("'{}' has no parts", tokens_.back().name),
            "a place has the components x, y and z, as in tip.x; forces of constraints are in the results, no part "
            "of expressions");
      return refuse(code::k_malformed_number, 2, "values that are infinite or not a number are not accepted",
                    "write a finite number");
    }
    const support::CodePoint point = support::code_point_at(text_.text, at_);
    const CharacterAdvice advice = advise(point.value);
    return refuse(code::k_unexpected_character, point.size, advice.name + " does not belong in an expression",
                  advice.hint);
  }

  bool refuse(const support::ErrorCode& code, std::size_t size, std::string message, std::string hint) {
    diagnostics_.error(code, text_.span_of(at_, at_ + size), std::move(message), std::move(hint));
    return false;
  }

  bool too_many() {
    tokens_.clear();
    return refuse(code::k_expression_limit, 1, fmt::format("the expression has more than {} parts", k_most_tokens),
                  "split it with parameters");
  }

  const spec::LocatedText& text_;
  support::Diagnostics& diagnostics_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

}  // namespace

Tokens tokenize(const spec::LocatedText& text, support::Diagnostics& diagnostics) {
  if (text.text.size() > k_longest_expression) {
    diagnostics.error(
        code::k_expression_limit, text.span_of(0, 1),
        fmt::format("the expression has {} bytes; the limit is {}", text.text.size(), k_longest_expression),
        "split it with parameters");
    return {{Token{}}, true};
  }
  return Lexer(text, diagnostics).run();
}

}  // namespace gaussgen::model
