// Functions with jumps and kinks stay where no derivative of them is taken that they do not have.

#include <fmt/format.h>

#include "model/checks.hpp"
#include "model/expressions.hpp"
#include "model/functions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

const char* times(int derivatives) {
  constexpr const char* k_times[] = {"not at all", "once", "twice", "three times"};
  return k_times[derivatives];
}

/// Whether it changes during a motion.
bool varies(const Ast& ast, const Model& model) {
  if (ast.kind == AstKind::symbol) {
    const auto symbol = model.symbols.find(ast.name);
    return symbol != model.symbols.end() && symbol->second.kind != SymbolKind::pi &&
           symbol->second.kind != SymbolKind::parameter;
  }
  for (const Ast& child : ast.children) {
    if (varies(child, model)) return true;
  }
  return false;
}

struct Fault {
  int derivatives;  ///< that there are
  std::string what;
  std::string hint;
};

Fault fault_of_table(const support::Table& table) {
  if (table.derivatives > 1) return {table.derivatives, "", ""};
  const bool is_spline = table.degree() > 1;
  if (is_spline)
    return {1, fmt::format("the table '{}' has kinks at its ends", table.name), "write 'outside: extend' in the table"};
  return {1, fmt::format("the table '{}' has kinks at its points", table.name), "write 'kind: spline' in the table"};
}

class SmoothnessCheck {
 public:
  SmoothnessCheck(const Place& place, Reading& reading) : place_(place), reading_(reading) {}

  /// `dots`: how many dot(...) stand around it.
  void visit(const Ast& ast, int dots) {
    const bool is_dot = ast.kind == AstKind::call && ast.name == k_dot;
    if (const auto fault = fault_of(ast, dots)) {
      if (place_.derivatives + dots > fault->derivatives) return report(ast, *fault, dots);
    }
    for (const Ast& child : ast.children) visit(child, dots + (is_dot ? 1 : 0));
  }

 private:
  /// Of functions that are not smooth in what varies.
  std::optional<Fault> fault_of(const Ast& ast, int dots) const {
    if (ast.kind != AstKind::call) return std::nullopt;
    if (ast.table != nullptr) return varying(ast, fault_of_table(*ast.table));
    if (ast.name == "abs")
      return varying(ast, {1, "abs(...) has a kink", "write sqrt(x^2 + eps^2) with a small eps for abs(x)"});
    if (ast.name == "sign")
      return varying(ast, {0, "sign(...) jumps", "write tanh(x/eps) with a small eps for sign(x)"});
    if (ast.name == "min" || ast.name == "max") {
      return varying(ast, {1, fmt::format("{}(...) has a kink", ast.name),
                           fmt::format("write (a + b {} sqrt((a - b)^2 + eps^2))/2 with a small eps for {}(a, b)",
                                       ast.name == "min" ? "-" : "+", ast.name)});
    }
    if (ast.name == k_piecewise) return of_cases(ast, dots);
    return std::nullopt;
  }

  std::optional<Fault> varying(const Ast& ast, Fault fault) const {
    if (!varies(ast, reading_.model)) return std::nullopt;
    return fault;
  }

  /// Cases that the parameters decide do not change during a motion.
  std::optional<Fault> of_cases(const Ast& ast, int dots) const {
    for (std::size_t i = 0; i + 1 < ast.children.size(); i += 2) {
      if (!varies(ast.children[i], reading_.model)) continue;
      return Fault{0, "piecewise(...) may jump between its cases", hint_for_cases(dots)};
    }
    return std::nullopt;
  }

  std::string hint_for_cases(int dots) const {
    std::string hint = "write a table with 'kind: spline'";
    if (place_.quantity == Quantity::energy) hint += ", or a generalized force in place of a potential";
    if (dots == 1 && place_.derivatives == 0) hint += ", or the rate of each case: piecewise(c, dot(a), dot(b))";
    return hint;
  }

  void report(const Ast& ast, const Fault& fault, int dots) {
    std::string taken = fmt::format("{} is differentiated {}", place_.name, times(place_.derivatives));
    if (dots > 0) taken = place_.derivatives == 0 ? "dot(...) differentiates it" : taken + ", and by dot(...)";
    reading_.diagnostics.error(code::k_not_smooth, ast.span, fmt::format("{}: {}", fault.what, taken), fault.hint);
  }

  const Place& place_;
  Reading& reading_;
};

}  // namespace

void check_smoothness(Reading& reading) {
  for_each_expression(reading.model,
                      [&](const Ast& ast, const Place& place) { SmoothnessCheck(place, reading).visit(ast, 0); });
}

}  // namespace gaussgen::model
