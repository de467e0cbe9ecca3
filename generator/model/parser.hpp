#pragma once
// An expression of a model file to an Ast.

#include <optional>

#include "model/ast.hpp"
#include "spec/node.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen::model {

/// Among the tables, and null: any other name that is called may be a table, since their section could not be read.
inline constexpr const char* k_any_table = "";

inline constexpr int k_deepest_expression = 64;
inline constexpr int k_largest_power = 10'000;  // as many as copies of an entry: q^$i
inline constexpr int k_largest_root = 64;

inline constexpr const char* k_hint_for_empty_expression = "write a number or a formula; what vanishes is written as 0";

/// Knows the grammar, the functions and the tables, not the other names of the model. A mistake of syntax ends the expression, since what follows one
/// is guesswork; after others it goes on. An exponent is folded to one number. After a mistake: broken, with what could be read.
Ast parse_readable(const spec::LocatedText& text, support::Diagnostics& diagnostics, const KnownTables& tables = {});

/// The same, or nothing after a mistake.
std::optional<Ast> parse_expression(const spec::LocatedText& text, support::Diagnostics& diagnostics,
                                    const KnownTables& tables = {});

}  // namespace gaussgen::model
