#pragma once
// The function that fills power series of the state: recurrences of passes/series.hpp as code.

#include <vector>

#include "emit/body.hpp"
#include "emit/cpp_tree.hpp"
#include "emit/plan.hpp"
#include "passes/series.hpp"

namespace gaussgen::emit {

/// Of the values of a function that fills a Derivative; `rates`: its values.
passes::Series series_of(Plan& plan, const std::vector<NodeId>& rates);

/// After the statements that compute order 0: fills `series` with the coefficients of the state.
void write_series(const passes::Series& series, const Plan& plan, const std::vector<NodeId>& rates, Body& body,
                  NameScope& scope);

/// Names that this code needs for itself.
void reserve_names_of_series(NameScope& scope);

cpp::Struct series_struct(const passes::Series& series);

}  // namespace gaussgen::emit
