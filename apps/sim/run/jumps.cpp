#include "sim/run/jumps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/constant.hpp"
#include "model/expressions.hpp"

namespace gausssim {

namespace {

namespace model = gaussgen::model;

class Edges {
 public:
  explicit Edges(const model::Model& of) : model_(of) {}

  void visit(const model::Ast& ast) {
    if (ast.kind == model::AstKind::call && changes(ast)) note(ast);
    for (const model::Ast& child : ast.children) visit(child);
  }

  std::string hardest() const { return found_.empty() ? "" : found_.begin()->second; }

 private:
  /// Jumps first, then kinks.
  void note(const model::Ast& ast) {
    static const std::map<std::string, int> k_hardness{
        {"sign", 0}, {"piecewise", 1}, {"abs", 2}, {"min", 2}, {"max", 2}};
    if (ast.name == "sqrt" && (is_square(ast.children.front()) || is_square_of_speeds(ast.children.front()))) {
      found_.insert({2, ast.name});
    } else if (ast.table != nullptr) {
      if (ast.table->degree() <= 1) found_.insert({3, ast.name});
    } else if (const auto one = k_hardness.find(ast.name); one != k_hardness.end()) {
      found_.insert({one->second, ast.name});
    }
  }

  /// Its root is what is squared, or that with another sign: x/sqrt(x^2) jumps, and series of it know of one side alone.
  static bool is_square(const model::Ast& ast) {
    if (ast.kind != model::AstKind::power) return false;
    const auto exponent = model::exact_value(ast.children.back());
    return exponent && gaussgen::support::is_integer(*exponent / 2);
  }

  /// A speed such as that of drag, which is 0 wherever something comes to rest. (Distances hardly ever are.)
  bool is_square_of_speeds(const model::Ast& ast) const {
    return ast.kind == model::AstKind::sum && has_rate(ast) &&
           std::all_of(ast.children.begin(), ast.children.end(), [&](const model::Ast& term) {
             return is_square(term) || (term.kind == model::AstKind::product &&
                                        std::any_of(term.children.begin(), term.children.end(),
                                                    [](const auto& one) { return is_square(one); }));
           });
  }

  bool has_rate(const model::Ast& ast) const {
    if (ast.kind == model::AstKind::call && ast.name == "dot") return true;
    if (ast.kind == model::AstKind::symbol) {
      const auto symbol = model_.symbols.find(ast.name);
      return symbol != model_.symbols.end() &&
             (symbol->second.kind == model::SymbolKind::speed || symbol->second.kind == model::SymbolKind::spin);
    }
    return std::any_of(ast.children.begin(), ast.children.end(), [this](const auto& child) { return has_rate(child); });
  }

  bool changes(const model::Ast& ast) const {
    if (ast.kind == model::AstKind::symbol) {
      const auto symbol = model_.symbols.find(ast.name);
      const bool is_fixed = symbol == model_.symbols.end() || symbol->second.kind == model::SymbolKind::pi ||
                            symbol->second.kind == model::SymbolKind::parameter ||
                            symbol->second.kind == model::SymbolKind::input;
      return !is_fixed;
    }
    return std::any_of(ast.children.begin(), ast.children.end(), [this](const auto& child) { return changes(child); });
  }

  const model::Model& model_;
  std::set<std::pair<int, std::string>> found_;
};

/// Nothing moves by what is only told.
template <class Visit>
void for_each_that_acts(const model::Model& of, Visit&& visit) {
  model::for_each_slot(of, [&](const model::Ast& ast, const model::Slot& slot) {
    const bool is_closed_form =
        std::any_of(of.exact.begin(), of.exact.end(), [&](const auto& form) { return &form.value == &ast; });
    if (slot.stated == nullptr && !is_closed_form) visit(ast);
  });
}

bool has_time(const model::Model& of, const model::Ast& ast) {
  if (ast.kind == model::AstKind::symbol) {
    const auto symbol = of.symbols.find(ast.name);
    return symbol != of.symbols.end() && symbol->second.kind == model::SymbolKind::time;
  }
  return std::any_of(ast.children.begin(), ast.children.end(),
                     [&](const model::Ast& child) { return has_time(of, child); });
}

}  // namespace

std::string function_with_edge(const model::Model& of) {
  Edges edges(of);
  for_each_that_acts(of, [&](const model::Ast& ast) { edges.visit(ast); });
  return edges.hardest();
}

bool acts_in_time(const model::Model& of) {
  bool result = false;
  for_each_that_acts(of, [&](const model::Ast& ast) { result = result || has_time(of, ast); });
  return result;
}

bool is_jump(const std::string& function) {
  return function == "sign" || function == "piecewise" || function == "sqrt";
}

std::string hint_for_edge(const std::string& function) {
  return fmt::format(
      "steps become short where a force has a jump or a kink, as by {}(...), above all where a motion sticks there: "
      "write a smooth law, such as tanh(x/eps) with a small eps for sign(x)",
      function);
}

}  // namespace gausssim
