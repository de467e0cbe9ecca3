#pragma once
// One function per case, each in a file of its own.

#include "case.hpp"

namespace hard_cases {

std::vector<Figure> euler_pole(const Scope& scope);
std::vector<Figure> long_run(const Scope& scope);
std::vector<Figure> constraint_drift(const Scope& scope);
std::vector<Figure> accumulated_time(const Scope& scope);
std::vector<Figure> moving_pivot(const Scope& scope);
std::vector<Figure> time_reversal(const Scope& scope);
std::vector<Figure> ill_start(const Scope& scope);

}  // namespace hard_cases
