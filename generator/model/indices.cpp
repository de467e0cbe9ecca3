#include "model/indices.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "model/rewriting.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;

using support::is_digit;
using support::is_letter;

namespace {

constexpr int k_deepest = 16;

std::string known_names(const Indices& indices, const char* otherwise) {
  std::vector<std::string> names;
  for (const auto& [name, value] : indices) names.push_back(name);
  return names.empty() ? otherwise : "known here: " + support::joined(names);
}

/// sum = product {(+|-) product}; product = factor {(*|/|%) factor}; factor = number | name | (sum) | (+|-) factor.
class Formula {
 public:
  /// `hint` says how to get an index where there is none.
  Formula(const spec::LocatedText& text, std::size_t begin, const Indices& indices, const char* hint,
          support::Diagnostics& diagnostics)
      : text_(text), at_(begin), indices_(indices), hint_(hint), diagnostics_(diagnostics) {}

  std::size_t at() const { return at_; }

  std::optional<std::int64_t> sum() {
    std::optional<std::int64_t> result = product();
    for (char sign = next(); result && (sign == '+' || sign == '-'); sign = next()) {
      ++at_;
      const auto other = product();
      result = other ? checked(sign == '+' ? *result + *other : *result - *other) : std::nullopt;
    }
    return result;
  }

  std::optional<std::int64_t> factor() {
    const char c = next();
    if (is_digit(c)) return number();
    if (is_letter(c)) return name();
    const std::size_t begin = at_;
    if (c != '-' && c != '+' && c != '(')
      return refuse(begin, "a whole number is missing here", "as in $(i - 1), with + - * / % and brackets");
    if (++depth_ > k_deepest) return refuse(begin, "too many brackets in an index", "simplify it");
    ++at_;
    const auto inner = c == '(' ? sum() : factor();
    --depth_;
    if (!inner) return std::nullopt;
    if (c != '(') return c == '-' ? -*inner : *inner;
    if (next() != ')' && text_.text.find(')', at_) != std::string::npos)
      return refuse(at_, "only whole numbers stand in the brackets of an index",
                    "as in $(i - 1), with + - * / % and brackets");
    if (next() != ')') return refuse(begin, "this bracket is never closed", "an index is written $i or $(i - 1)");
    ++at_;
    return inner;
  }

  bool is_at_end() { return next() == '\0'; }

  std::nullopt_t refuse(std::size_t begin, std::string message, std::string hint) {
    diagnostics_.error(code::k_index, text_.span_of(begin, at_), std::move(message), std::move(hint));
    return std::nullopt;
  }

 private:
  char next() {
    while (at_ < text_.text.size() && text_.text[at_] == ' ') ++at_;
    return at_ < text_.text.size() ? text_.text[at_] : '\0';
  }

  std::optional<std::int64_t> checked(std::int64_t value) {
    if (value <= k_largest_index && value >= -k_largest_index) return value;
    return refuse(at_ - 1, fmt::format("an index beyond {}", k_largest_index), "count in smaller numbers");
  }

  std::optional<std::int64_t> product() {
    std::optional<std::int64_t> result = factor();
    for (char sign = next(); result && (sign == '*' || sign == '/' || sign == '%'); sign = next()) {
      const std::size_t begin = at_++;
      const auto other = factor();
      result = other ? combined(*result, sign, *other, begin) : std::nullopt;
    }
    return result;
  }

  std::optional<std::int64_t> combined(std::int64_t a, char sign, std::int64_t b, std::size_t begin) {
    if (sign == '*') return checked(a * b);
    if (b == 0) return refuse(begin, "an index is divided by 0", "mend the formula");
    if (sign == '%') return a % b;
    if (a % b == 0) return a / b;
    return refuse(begin, fmt::format("{}/{} is no whole number", a, b), "an index is whole");
  }

  std::optional<std::int64_t> number() {
    std::int64_t value = 0;
    for (; at_ < text_.text.size() && is_digit(text_.text[at_]); ++at_) {
      if (value <= k_largest_index) value = 10 * value + (text_.text[at_] - '0');
    }
    return checked(value);
  }

  std::optional<std::int64_t> name() {
    const std::size_t begin = at_;
    while (at_ < text_.text.size() && (is_letter(text_.text[at_]) || is_digit(text_.text[at_]))) ++at_;
    const std::string name = text_.text.substr(begin, at_ - begin);
    const auto found = indices_.find(name);
    if (found != indices_.end()) return found->second;
    return refuse(begin, fmt::format("there is no index '{}' here", name), known_names(indices_, hint_));
  }

  const spec::LocatedText& text_;
  std::size_t at_;
  const Indices& indices_;
  const char* hint_;
  support::Diagnostics& diagnostics_;
  int depth_ = 0;
};

/// A negative number stays one factor of a product.
std::string written(std::int64_t value) { return value < 0 ? fmt::format("({})", value) : std::to_string(value); }

}  // namespace

spec::LocatedText with_indices(const spec::LocatedText& text, const Indices& indices, UnknownIndex unknown,
                               support::Diagnostics& diagnostics) {
  if (text.text.find('$') == std::string::npos) return text;
  Rewriting result(text);
  while (!result.is_done()) {
    if (result.peek() == '$' && result.peek(1) == '{' && unknown == UnknownIndex::error) {
      diagnostics.error(code::k_index, text.span_of(result.at(), result.at() + 2), "an index has no braces",
                        "write $i, or $(i) where a letter or digit follows");
      return text;
    }
    const bool is_index = result.peek() == '$' && (is_letter(result.peek(1)) || result.peek(1) == '(');
    if (!is_index) {
      result.keep(1);
      continue;
    }
    support::Diagnostics found;
    Formula formula(text, result.at() + 1, indices, "an entry with 'count: 3' has $i, which runs from 1 to 3", found);
    if (const auto value = formula.factor()) {
      result.replace(formula.at() - result.at(), written(*value));
      continue;
    }
    result.keep(1);
    if (unknown == UnknownIndex::keep) continue;
    for (const support::Diagnostic& finding : found.all()) diagnostics.add(finding);
  }
  return std::move(result).result();
}

spec::Node with_indices(spec::Node node, const Indices& indices, support::Diagnostics& diagnostics) {
  if (node.kind == spec::NodeKind::scalar)
    node.scalar = with_indices(node.scalar, indices, UnknownIndex::error, diagnostics);
  for (spec::Node& item : node.items) item = with_indices(std::move(item), indices, diagnostics);
  for (spec::Entry& entry : node.entries) {
    entry.key = with_indices(entry.key, indices, UnknownIndex::error, diagnostics);
    if (entry.key.text == "about" && entry.value.kind == spec::NodeKind::scalar) {
      entry.value.scalar = with_indices(entry.value.scalar, indices, UnknownIndex::keep, diagnostics);
    } else {
      entry.value = with_indices(std::move(entry.value), indices, diagnostics);
    }
  }
  return node;
}

std::optional<std::int64_t> whole_number(const spec::LocatedText& text, const Indices& indices,
                                         support::Diagnostics& diagnostics) {
  Formula formula(text, 0, indices, "write a number, or declare 'counts: {n: 3}': parameters are not known yet",
                  diagnostics);
  const std::optional<std::int64_t> value = formula.sum();
  if (!value || formula.is_at_end()) return value;
  diagnostics.error(code::k_index, text.span_of(formula.at(), text.text.size()),
                    "this does not belong to a whole number",
                    "write a whole number, or a formula over names of 'counts', as in 2*n");
  return std::nullopt;
}

}  // namespace gaussgen::model
