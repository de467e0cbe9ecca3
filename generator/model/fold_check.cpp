#include "model/fold_check.hpp"

#include "model/constant.hpp"
#include "model/expressions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace {

/// Less than numbers in the text may grow to: from here on they meet in products of several expressions.
constexpr double k_largest_folded_growth = k_largest_growth / 8;

}  // namespace

void check_fold(const Model& model, support::Diagnostics& diagnostics) {
  BitsOfNames bits;
  for (const Parameter& parameter : model.parameters) bits[parameter.name.text] = growth(parameter.value, bits);
  for_each_expression(model, [&](const Ast& ast, const Place&) {
    if (growth(ast, bits) <= k_largest_folded_growth) return;
    diagnostics.error(support::code::k_expression_limit, ast.span,
                      "with parameters put in as numbers, those of this expression grow too large",
                      "leave out --fold, choose smaller exponents, or units in which numbers are of moderate size");
  });
}

}  // namespace gaussgen::model
