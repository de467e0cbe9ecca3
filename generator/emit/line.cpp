#include "emit/line.hpp"

namespace gaussgen::emit::cpp {

namespace {

using Kind = Expression::Kind;

enum Precedence { k_any = 0, k_sum = 1, k_product = 2, k_factor = 3 };

int precedence(const Expression& expression) {
  switch (expression.kind) {
    case Kind::sum: return k_sum;
    case Kind::negation:
    case Kind::product:
    case Kind::quotient: return k_product;
    default: return k_factor;
  }
}

constexpr std::size_t k_continuation = 4;
constexpr std::size_t k_line = 110;

}  // namespace

Expression negated(Expression operand) {
  if (operand.kind == Kind::negation) return operand.operands[0];
  return {Kind::negation, {}, {std::move(operand)}};
}

namespace {

/// Takes the signs off the factors; whether an odd number of them was negative.
bool take_signs(std::vector<Expression>& factors) {
  bool is_negative = false;
  for (Expression& factor : factors) {
    if (factor.kind != Kind::negation) continue;
    is_negative = !is_negative;
    factor = Expression(std::move(factor.operands[0]));
  }
  return is_negative;
}

Expression signed_as(bool is_negative, Expression size) { return is_negative ? negated(std::move(size)) : size; }

}  // namespace

Expression product(std::vector<Expression> factors) {
  if (factors.size() == 1) return std::move(factors[0]);
  const bool is_negative = take_signs(factors);
  return signed_as(is_negative, {Kind::product, {}, std::move(factors)});
}

Expression quotient(Expression top, Expression bottom) {
  std::vector<Expression> both{std::move(top), std::move(bottom)};
  const bool is_negative = take_signs(both);
  return signed_as(is_negative, {Kind::quotient, {}, std::move(both)});
}

Expression sum(std::vector<Expression> terms) {
  if (terms.size() == 1) return std::move(terms[0]);
  return {Kind::sum, {}, std::move(terms)};
}

Line& Line::text(std::string_view part) {
  if (pieces_.empty()) pieces_.push_back({{}, 0});
  pieces_.back().text += part;
  return *this;
}

Line& Line::expression(const Expression& expression) {
  write(expression, k_any);
  return *this;
}

void Line::write(const Expression& expression, int outer) {
  const bool brackets = precedence(expression) < outer;
  if (brackets) text("(");
  if (brackets) ++depth_;
  const std::vector<Expression>& operands = expression.operands;
  switch (expression.kind) {
    case Kind::atom: text(expression.text); break;
    case Kind::negation:
      text("-");
      write(operands[0], k_product);
      break;
    case Kind::sum: write_sum(expression); break;
    case Kind::product:
      // A leading minus or quotient reads well without brackets; later factors need them.
      write(operands[0], k_product);
      for (std::size_t i = 1; i < operands.size(); ++i) {
        text(" ");
        break_here();
        text("* ");
        write(operands[i], k_factor);
      }
      break;
    case Kind::quotient:
      write(operands[0], k_product);
      text(" / ");
      write(operands[1], k_factor);
      break;
    case Kind::call:
      text(expression.text).text("(");
      write_list(operands);
      text(")");
      break;
    case Kind::list:
      text("{");
      write_list(operands);
      text("}");
      break;
  }
  if (brackets) --depth_;
  if (brackets) text(")");
}

void Line::write_sum(const Expression& sum) {
  bool is_first = true;
  for (const Expression& term : sum.operands) {
    const bool is_subtracted = term.kind == Kind::negation && !is_first;
    if (!is_first) {
      text(" ");
      break_here();
      text(is_subtracted ? "- " : "+ ");
    }
    ++depth_;
    write(is_subtracted ? term.operands[0] : term, k_product);
    --depth_;
    is_first = false;
  }
}

void Line::write_list(const std::vector<Expression>& operands) {
  ++depth_;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (i > 0) {
      text(", ");
      break_here();
    }
    write(operands[i], k_any);
  }
  --depth_;
}

std::string Line::str() const {
  std::string result;
  std::string line(indent_, ' ');
  std::size_t first = 0;
  while (first < pieces_.size()) {
    // The longest prefix that fits, then the outermost break in its second half.
    std::size_t width = line.size();
    std::size_t end = first;
    while (end < pieces_.size() && (end == first || width + pieces_[end].text.size() <= k_line)) {
      width += pieces_[end].text.size();
      ++end;
    }
    if (end < pieces_.size()) {
      std::size_t best = end;
      std::size_t start = width;
      for (std::size_t i = end; i > first + 1 && start > k_line / 4; --i) {
        if (pieces_[i].depth > 0 && pieces_[i].depth < pieces_[best].depth) best = i;
        start -= pieces_[i - 1].text.size();
      }
      end = best;
    }
    for (std::size_t i = first; i < end; ++i) line += pieces_[i].text;
    first = end;
    if (first == pieces_.size()) break;
    while (!line.empty() && line.back() == ' ') line.pop_back();
    result += line + "\n";
    line.assign(indent_ + k_continuation, ' ');
  }
  return result + line;
}

}  // namespace gaussgen::emit::cpp
