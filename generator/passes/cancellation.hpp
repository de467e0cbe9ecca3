#pragma once

#include <string>
#include <vector>

#include "passes/program.hpp"

namespace gaussgen::passes {

/// Sums that lose digits by how they are written, and not by their values, in a form that keeps them: 1 - cos x is 2 sin²(x/2),
/// √(L² + x²) - L is x²/(√(L² + x²) + L). Each rule is an identity of real numbers (docs/decisions/0011-cancellation.md).
///
/// Behind differentiation, so that derivatives are those of what was written, which have no such sums: the slope of 1 - cos x is sin x.
Request keep_digits(Graph& graph, const Request& request);

/// Without the rules that are named, of `digit_rules`.
Request keep_digits_except(Graph& graph, const Request& request, const std::vector<std::string>& as_written);

const std::vector<std::string>& digit_rules();

/// Those whose forms are chosen by the values that they have: at the edge of a case, derivatives are not those of what was written.
const std::vector<std::string>& digit_rules_by_cases();

}  // namespace gaussgen::passes
