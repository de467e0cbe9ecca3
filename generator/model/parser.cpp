#include "model/parser.hpp"

#include <fmt/format.h>

#include <deque>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "model/ast_build.hpp"
#include "model/constant.hpp"
#include "model/functions.hpp"
#include "model/lexer.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

constexpr Function k_table{"", 1};
constexpr const char* k_misplaced_comparison = "a comparison may stand only as a condition of piecewise(...)";
constexpr const char* k_for_cases = "write piecewise(x < 0, a, b): a where x < 0, else b";
constexpr double k_largest_exponent_growth = 1 << 14;  // before its exact value is formed

/// Recursive descent:
///   sum     = product { (+|-) product }
///   product = unary { (*|/) unary }
///   unary   = { +|- } power
///   power   = primary [ ^ unary ]
///   primary = number | name | name ( argument { , argument } ) | ( sum )
///   argument = sum [ (<|<=|>|>=) sum ], a comparison only as a condition of piecewise
class Parser {
 public:
  Parser(const spec::LocatedText& text, Tokens tokens, const KnownTables& tables, support::Diagnostics& diagnostics)
      : text_(text),
        tokens_(std::move(tokens.all)),
        is_cut_(tokens.is_cut),
        tables_(tables),
        diagnostics_(diagnostics) {}

  Ast run() {
    if (token().kind == TokenKind::end) {
      refuse(code::k_empty_expression, text_.span, "an expression is missing here", k_hint_for_empty_expression);
      return broken_expression();
    }
    Ast ast = sum();
    if (token().kind != TokenKind::end) refuse_rest();
    if (!is_faulty() && growth(ast) > k_largest_growth) {
      note(code::k_expression_limit, ast.span, "the numbers in this expression grow too large",
           "nested powers multiply their exponents; choose smaller ones");
    }
    if (!is_faulty()) return ast;
    std::vector<Ast> readable;
    readable.push_back(std::move(ast));
    return broken_expression(std::move(readable));
  }

 private:
  /// Counts one level of brackets, signs or exponents for as long as it lives.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > k_deepest_expression) {
        parser_.refuse(code::k_expression_limit, parser_.span_of(parser_.token()),
                       fmt::format("the expression is nested more than {} deep", k_deepest_expression),
                       "write it with fewer brackets; a part in which nothing moves may be a parameter");
      }
    }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    ~Level() { --parser_.depth_; }

   private:
    Parser& parser_;
  };

  const Token& token() const { return tokens_[next_]; }
  Token take() { return tokens_[next_++]; }
  bool accept(TokenKind kind) { return token().kind == kind ? (++next_, true) : false; }
  support::Span span_of(const Token& token) const { return text_.span_of(token.begin, token.end); }

  /// From the token with index `first` to the last one taken.
  support::Span span_since(std::size_t first) const {
    return {span_of(tokens_[first]).begin, span_of(tokens_[next_ - 1]).end};
  }

  bool is_faulty() const { return faults_ > 0 || is_cut_; }

  /// A mistake after which reading goes on. One expression is found to have no more than anybody reads.
  void note(const support::ErrorCode& code, support::Span span, std::string message, std::string hint) {
    if (!is_over_ && faults_ < support::k_most_findings)
      diagnostics_.error(code, span, std::move(message), std::move(hint));
    ++faults_;
  }

  /// A mistake that ends the expression: everything above sees its end, and says nothing more. Where the text is cut, that is reported.
  void refuse(const support::ErrorCode& code, support::Span span, std::string message, std::string hint) {
    is_over_ = is_over_ || (is_cut_ && token().kind == TokenKind::end);
    note(code, span, std::move(message), std::move(hint));
    is_over_ = true;
    next_ = tokens_.size() - 1;
  }

  static Ast node(AstKind kind, support::Span span, std::vector<Ast> children = {}) {
    Ast ast;
    ast.kind = kind;
    ast.span = span;
    ast.children = std::move(children);
    return ast;
  }

  Ast sum() { return chain(AstKind::sum, TokenKind::plus, TokenKind::minus, AstKind::negate); }
  Ast product() { return chain(AstKind::product, TokenKind::times, TokenKind::divide, AstKind::reciprocal); }
  Ast operand(AstKind chain_kind) { return chain_kind == AstKind::sum ? product() : unary(); }

  /// a + b - c as one node of three children, the last one wrapped; so too for * and /.
  Ast chain(AstKind kind, TokenKind plain, TokenKind inverse, AstKind wrapper) {
    const std::size_t first = next_;
    Ast head = operand(kind);
    if (token().kind != plain && token().kind != inverse) return head;
    // A vector that grows copies what its nodes hold, and keeps room for half as many again.
    std::deque<Ast> parts;
    parts.push_back(std::move(head));
    while (token().kind == plain || token().kind == inverse) {
      const std::size_t sign = next_;
      const bool wrap = take().kind == inverse;
      Ast child = operand(kind);
      if (wrap) {
        const support::Span span = span_since(sign);
        std::vector<Ast> inner;
        inner.push_back(std::move(child));
        child = node(wrapper, span, std::move(inner));
      }
      parts.push_back(std::move(child));
    }
    return node(kind, span_since(first),
                {std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end())});
  }

  Ast unary() {
    const std::size_t first = next_;
    if (accept(TokenKind::plus)) {
      const Level level(*this);
      return unary();
    }
    if (!accept(TokenKind::minus)) return power();
    const Level level(*this);
    std::vector<Ast> inner;
    inner.push_back(unary());
    return node(AstKind::negate, span_since(first), std::move(inner));
  }

  Ast power() {
    const std::size_t first = next_;
    Ast base = primary();
    if (!accept(TokenKind::power)) return base;
    const Level level(*this);
    const std::size_t faults = faults_;
    Ast exponent = unary();
    exponent = faults_ == faults ? fold_exponent(exponent) : broken_expression();
    std::vector<Ast> children;
    children.push_back(std::move(base));
    children.push_back(std::move(exponent));
    return node(AstKind::power, span_since(first), std::move(children));
  }

  static std::string hint_for_size() {
    return fmt::format("it may be up to {}, and its denominator up to {}", k_largest_power, k_largest_root);
  }

  Ast without_value(support::Span span, std::string message, std::string hint) {
    note(code::k_exponent, span, std::move(message), std::move(hint));
    return broken_expression();
  }

  Ast fold_exponent(const Ast& exponent) {
    if (growth(exponent) > k_largest_exponent_growth) {
      return without_value(exponent.span, "this exponent is too large", hint_for_size());
    }
    const auto value = exact_value(exponent);
    if (!value) {
      return without_value(exponent.span, "an exponent must be a constant integer or fraction",
                           "write exp(b*log(a)) for a^b with a variable b");
    }
    const bool small =
        cln::abs(cln::numerator(*value)) <= k_largest_power && cln::denominator(*value) <= k_largest_root;
    if (!small && cln::abs(*value) <= k_largest_power) {
      return without_value(exponent.span,
                           fmt::format("the exponent {} is no simple fraction", support::to_text(*value)),
                           hint_for_size() + ", as in x^(1/3)");
    }
    if (!small) {
      return without_value(exponent.span, fmt::format("the exponent {} is too large", support::to_text(*value)),
                           hint_for_size());
    }
    Ast folded = node(AstKind::number, exponent.span);
    folded.number = *value;
    return folded;
  }

  Ast primary() {
    switch (token().kind) {
      case TokenKind::number: {
        Ast ast = node(AstKind::number, span_of(token()));
        ast.is_decimal = is_decimal(token());
        ast.number = take().number;
        return ast;
      }
      case TokenKind::name: return name();
      case TokenKind::open: return bracket();
      default: refuse_operand(); return broken_expression();
    }
  }

  /// Looked for in the token alone: a sum of whole numbers has none up to its end.
  bool is_decimal(const Token& number) const {
    const std::string_view digits = std::string_view(text_.text).substr(number.begin, number.end - number.begin);
    return digits.find_first_of(".eE") != std::string_view::npos;
  }

  Ast bracket() {
    const std::size_t first = next_;
    const Level level(*this);
    if (is_over_) return broken_expression();
    ++next_;
    Ast inner = sum();
    close(first);
    inner.span = span_since(first);
    return inner;
  }

  bool is_table(const std::string& name, bool is_called) const {
    const bool may_be_any = is_called && tables_.count(k_any_table) > 0 && find_function(name) == nullptr;
    return may_be_any || tables_.count(name) > 0;
  }

  Ast name() {
    const std::size_t first = next_;
    const std::string text = take().name;
    const bool called = token().kind == TokenKind::open;
    const Function* function = is_table(text, called) ? &k_table : find_function(text);
    if (function != nullptr && !called) {
      refuse(
          code::k_function_call, span_of(tokens_[first]),
          fmt::format("the {} '{}' needs its argument in brackets", function == &k_table ? "table" : "function", text),
          fmt::format("write {}(...)", text));
      return broken_expression();
    }
    if (called) return call(first, text, function);
    Ast ast = node(AstKind::symbol, span_of(tokens_[first]));
    ast.name = text;
    return ast;
  }

  Ast call(std::size_t first, const std::string& text, const Function* function) {
    if (function == nullptr) {
      note(code::k_function_call, span_of(tokens_[first]), fmt::format("'{}' is not a function", text),
           hint_for_function(text, has_comma(first + 1)));
    }
    const Level level(*this);
    if (is_over_) return broken_expression();
    const std::size_t bracket = next_++;
    Ast ast = node(AstKind::call, {});
    ast.name = text;
    if (token().kind != TokenKind::close) {
      ast.children.push_back(argument());
      while (accept(TokenKind::comma)) ast.children.push_back(argument());
    }
    close(bracket);
    ast.span = span_since(first);
    return function == nullptr ? ast : checked_call(std::move(ast), *function);
  }

  Ast argument() {
    const std::size_t first = next_;
    Ast left = sum();
    if (!is_comparison(token().kind)) return left;
    Ast ast = node(AstKind::comparison, {});
    ast.name = text_.text.substr(token().begin, token().end - token().begin);
    ++next_;
    ast.children.push_back(std::move(left));
    ast.children.push_back(sum());
    ast.span = span_since(first);
    if (is_comparison(token().kind)) {
      refuse(code::k_comparison, span_of(token()), "comparisons do not form chains",
             "write piecewise(a < b, piecewise(b < c, x, y), y) for x where a < b < c, else y");
    }
    return ast;
  }

  Ast checked_call(Ast ast, const Function& function) {
    if (!has_good_count(ast, function)) {
      note(code::k_function_call, ast.span, fault_of_count(ast, function), hint_for_count(ast, function));
      return ast;
    }
    check_conditions(ast);
    if (&function == &k_table) {
      const auto table = tables_.find(ast.name);
      if (table != tables_.end()) ast.table = table->second;
      if (ast.table == nullptr) ++faults_;  // its own fault is reported where the table is
    }
    if (ast.name == k_distance) return distance(ast);
    if (ast.name != "pow" || is_faulty()) return ast;
    ast.children[1] = fold_exponent(ast.children[1]);
    return node(AstKind::power, ast.span, std::move(ast.children));
  }

  /// Of two places: the root of the sum of squares.
  Ast distance(const Ast& ast) {
    std::vector<Name> places;
    for (const Ast& child : ast.children) {
      const bool is_name = child.kind == AstKind::symbol && child.name.find('.') == std::string::npos;
      if (is_name && !is_broken(child)) places.push_back({child.name, child.span});
    }
    if (places.size() == 2) {
      Ast root = distance_between(places[0], places[1]);
      root.span = ast.span;
      root.is_derived = false;  // as a whole it is what the user wrote
      return root;
    }
    note(code::k_function_call, ast.span, "'distance' takes the names of two places",
         "write distance(P, Q) for two frames, points or bodies");
    return ast;
  }

  static bool has_good_count(const Ast& ast, const Function& function) {
    const std::size_t count = ast.children.size();
    if (count < function.arguments || count > function.most_arguments) return false;
    return ast.name != k_piecewise || count % 2 == 1;
  }

  static std::string fault_of_count(const Ast& ast, const Function& function) {
    const std::size_t count = ast.children.size();
    if (ast.name == k_piecewise && count <= function.most_arguments) {
      return fmt::format("'piecewise' takes pairs of a condition and a value, then a last value, not {} argument{}",
                         count, count == 1 ? "" : "s");
    }
    if (function.most_arguments == function.arguments) {
      return fmt::format("'{}' takes {} argument{}, not {}", ast.name, function.arguments,
                         function.arguments == 1 ? "" : "s", count);
    }
    return fmt::format("'{}' takes from {} to {} arguments, not {}", ast.name, function.arguments,
                       function.most_arguments, count);
  }

  static std::string hint_for_count(const Ast& ast, const Function& function) {
    if (ast.name == k_piecewise) return k_for_cases;
    const bool is_extreme = function.most_arguments > function.arguments;
    const char* const arguments = ast.name == "atan2" ? "(y, x)"
                                  : ast.name == "pow" ? "(a, 2)"
                                  : is_extreme        ? "(a, b)"
                                                      : "(x)";
    return fmt::format("write {}{}", ast.name, arguments) +
           (ast.children.size() > function.most_arguments ? "; the decimal sign is a point" : "");
  }

  /// Comparisons where piecewise has its conditions, and nowhere else.
  void check_conditions(const Ast& ast) {
    const std::size_t count = ast.children.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Ast& child = ast.children[i];
      const bool is_wanted = ast.name == k_piecewise && i % 2 == 0 && i + 1 < count;
      const bool is_found = child.kind == AstKind::comparison;
      if (is_found && !is_wanted) note(code::k_comparison, child.span, k_misplaced_comparison, k_for_cases);
      if (!is_found && is_wanted && !is_broken(child)) {
        note(code::k_comparison, child.span, "this condition of 'piecewise' is not a comparison", k_for_cases);
      }
    }
  }

  static bool is_comparison(TokenKind kind) {
    return kind == TokenKind::less || kind == TokenKind::at_most || kind == TokenKind::greater ||
           kind == TokenKind::at_least;
  }

  /// Whether several arguments follow the bracket.
  bool has_comma(std::size_t bracket) const {
    int depth = 0;
    for (std::size_t i = bracket; i < tokens_.size(); ++i) {
      depth += tokens_[i].kind == TokenKind::open ? 1 : tokens_[i].kind == TokenKind::close ? -1 : 0;
      if (depth == 0) return false;
      if (depth == 1 && tokens_[i].kind == TokenKind::comma) return true;
    }
    return false;
  }

  /// All that may be called.
  std::vector<std::string> callable_names() const {
    std::vector<std::string> names = function_names();
    for (const auto& table : tables_) {
      if (table.first != k_any_table) names.push_back(table.first);
    }
    return names;
  }

  std::string hint_for_function(const std::string& text, bool has_several) const {
    // np.sin, math.sin: the function of a library.
    const std::string bare = text.substr(text.rfind('.') + 1);
    if (bare != text && find_function(bare) != nullptr) return fmt::format("write {}(...)", bare);
    std::string what = substitute_for(text);
    if (what.empty()) {
      const std::string near = support::did_you_mean(text, callable_names());
      if (!near.empty()) return near;
      if (has_several) return "the functions are " + support::joined(function_names());
      what = fmt::format("for a product write {}*(...)", text);
    }
    return what + "; the functions are " + support::joined(function_names());
  }

  void close(std::size_t bracket) {
    if (accept(TokenKind::close)) return;
    if (token().kind != TokenKind::end) return refuse_rest();
    refuse(code::k_unbalanced_brackets, span_of(tokens_[bracket]), "this bracket is never closed",
           "add ')'; an expression that YAML cuts at ',', ' #' or ': ' needs quotes");
  }

  void refuse_operand() {
    const support::Span span = span_of(token());
    const TokenKind kind = token().kind;
    if (kind == TokenKind::end) {
      return refuse(code::k_expression_syntax, span, "the expression stops where an operand should follow",
                    "write what is missing, or remove the operator at the end");
    }
    if (kind == TokenKind::close && next_ > 0 && tokens_[next_ - 1].kind == TokenKind::open) {
      return refuse(code::k_expression_syntax, span, "there is nothing between these brackets",
                    "write an expression between them, or remove them");
    }
    refuse(code::k_expression_syntax, span,
           fmt::format("an operand should stand before '{}'",
                       text_.text.substr(token().begin, token().end - token().begin)),
           "write what is missing, or remove an operator");
  }

  /// A complete operand stands before the current token, which cannot follow one.
  void refuse_rest() {
    const support::Span span = span_of(token());
    if (token().kind == TokenKind::close) {
      return refuse(code::k_unbalanced_brackets, span, "this bracket closes nothing",
                    "remove it, or add the '(' that it belongs to");
    }
    if (is_comparison(token().kind)) return refuse(code::k_comparison, span, k_misplaced_comparison, k_for_cases);
    const bool is_word = token().name == "and" || token().name == "or" || token().name == "not";
    if (is_word) {
      return refuse(code::k_comparison, span, fmt::format("'{}' does not join conditions", token().name),
                    "write piecewise(a < b, piecewise(c < d, x, y), y) for x where both hold, else y");
    }
    if (token().kind == TokenKind::comma) {
      return refuse(code::k_expression_syntax, span, "a comma outside the arguments of a function",
                    "the decimal sign is a point: 1.5");
    }
    const bool after_number = next_ > 0 && tokens_[next_ - 1].kind == TokenKind::number;
    const bool apart = next_ > 0 && tokens_[next_ - 1].end < token().begin;
    const bool unit_like = after_number && apart && token().kind == TokenKind::name;
    refuse(code::k_implicit_product, span, "an operator is missing before this",
           unit_like
               ? "write * for a product; numbers are in SI units and radians, such as 30*pi/180, and a unit stands "
                 "beside them where the entry has a key 'unit'"
               : "write * for a product");
  }

  const spec::LocatedText& text_;
  std::vector<Token> tokens_;
  bool is_cut_;
  const KnownTables& tables_;
  support::Diagnostics& diagnostics_;
  std::size_t next_ = 0;
  int depth_ = 0;
  std::size_t faults_ = 0;
  bool is_over_ = false;
};

}  // namespace

Ast parse_readable(const spec::LocatedText& text, support::Diagnostics& diagnostics, const KnownTables& tables) {
  return Parser(text, tokenize(text, diagnostics), tables, diagnostics).run();
}

std::optional<Ast> parse_expression(const spec::LocatedText& text, support::Diagnostics& diagnostics,
                                    const KnownTables& tables) {
  Ast ast = parse_readable(text, diagnostics, tables);
  if (is_broken(ast)) return std::nullopt;
  return ast;
}

}  // namespace gaussgen::model
