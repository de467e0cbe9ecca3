#include "model/unit_lexer.hpp"

#include <optional>

#include "support/utf8.hpp"

namespace gaussgen::model {

namespace {

constexpr int k_most_digits = 2;  // of an exponent
constexpr char32_t k_middle_dot = 0xB7;
constexpr char32_t k_dot_operator = 0x22C5;
constexpr char32_t k_raised_minus = 0x207B;

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }
bool is_blank(char32_t c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::optional<int> raised_digit(char32_t c) {
  switch (c) {
    case 0xB9: return 1;
    case 0xB2: return 2;
    case 0xB3: return 3;
    case 0x2070: return 0;
    default: break;
  }
  if (c >= 0x2074 && c <= 0x2079) return static_cast<int>(c - 0x2070);
  return std::nullopt;
}

bool is_raised(char32_t c) { return c == k_raised_minus || raised_digit(c).has_value(); }

/// Ω, µ and ° are letters here.
bool is_letter(char32_t c) {
  if (c >= 0x80) return c != k_middle_dot && c != k_dot_operator && !is_raised(c);
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

UnitTokenKind sign(char32_t c) {
  switch (c) {
    case '*':
    case k_middle_dot:
    case k_dot_operator: return UnitTokenKind::times;
    case '/': return UnitTokenKind::divide;
    case '^': return UnitTokenKind::power;
    case '-': return UnitTokenKind::minus;
    case '(': return UnitTokenKind::open;
    case ')': return UnitTokenKind::close;
    default: return UnitTokenKind::other;
  }
}

class UnitLexer {
 public:
  explicit UnitLexer(const std::string& text) : text_(text) {}

  std::vector<UnitToken> run() {
    while (at_ < text_.size()) next();
    tokens_.push_back({UnitTokenKind::end, at_, at_, 0});
    return std::move(tokens_);
  }

 private:
  char32_t peek() const { return at_ < text_.size() ? support::code_point_at(text_, at_).value : 0; }
  void skip() { at_ += support::code_point_at(text_, at_).size; }

  void next() {
    const char32_t c = peek();
    if (is_blank(c)) return skip();
    const std::size_t begin = at_;
    if (is_letter(c)) {
      while (is_letter(peek())) skip();
      return push(UnitTokenKind::name, begin);
    }
    if (is_digit(c)) return number(begin);
    if (is_raised(c)) return raised(begin);
    skip();
    // Expressions refuse it, too.
    const bool is_double_star = c == '*' && peek() == '*';
    if (is_double_star) skip();
    push(is_double_star ? UnitTokenKind::other : sign(c), begin);
  }

  /// Whole numbers of a size that an exponent may have keep their value; of others no unit is made.
  void number(std::size_t begin) {
    int value = 0;
    while (is_digit(peek()) || peek() == '.') {
      value = peek() == '.' || static_cast<int>(at_ - begin) >= k_most_digits
                  ? 0
                  : 10 * value + static_cast<int>(peek() - '0');
      skip();
    }
    push(UnitTokenKind::number, begin, value);
  }

  void raised(std::size_t begin) {
    const bool is_negative = peek() == k_raised_minus;
    if (is_negative) skip();
    int value = 0;
    int digits = 0;
    for (; const auto digit = raised_digit(peek()); skip()) value = ++digits > k_most_digits ? 0 : 10 * value + *digit;
    push(value == 0 ? UnitTokenKind::other : UnitTokenKind::raised, begin, is_negative ? -value : value);
  }

  void push(UnitTokenKind kind, std::size_t begin, int value = 0) { tokens_.push_back({kind, begin, at_, value}); }

  const std::string& text_;
  std::vector<UnitToken> tokens_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<UnitToken> unit_tokens(const std::string& text) { return UnitLexer(text).run(); }

}  // namespace gaussgen::model
