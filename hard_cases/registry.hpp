#pragma once
// One function per case, each in a file of its own.

#include "case.hpp"

namespace hard_cases {

std::vector<Figure> knife_edge(const Scope& scope);
std::vector<Figure> said_twice();  ///< part of the next
std::vector<Figure> redundant(const Scope& scope);
std::vector<Figure> contradictory(const Scope& scope);
std::vector<Figure> near_parallel(const Scope& scope);
std::vector<Figure> singular_mass(const Scope& scope);
std::vector<Figure> mass_ratio(const Scope& scope);
std::vector<Figure> even_crank();  ///< part of the next
std::vector<Figure> flat_parallelogram(const Scope& scope);
std::vector<Figure> over_constrained(const Scope& scope);
std::vector<Figure> fast_spin(const Scope& scope);
std::vector<Figure> angle_growth(const Scope& scope);
std::vector<Figure> euler_pole(const Scope& scope);
std::vector<Figure> long_run(const Scope& scope);
std::vector<Figure> constraint_drift(const Scope& scope);
std::vector<Figure> accumulated_time(const Scope& scope);
std::vector<Figure> stiff(const Scope& scope);  ///< only with SUNDIALS
std::vector<Figure> stick(const Scope& scope);  ///< these four only with gauss-sim
std::vector<Figure> painleve(const Scope& scope);
std::vector<Figure> zeno(const Scope& scope);
std::vector<Figure> cradle(const Scope& scope);
std::vector<Figure> shaken_bar();  ///< part of the next
std::vector<Figure> moving_pivot(const Scope& scope);
std::vector<Figure> affine(const Scope& scope);
std::vector<Figure> cancellation(const Scope& scope);
std::vector<Figure> rounding(const Scope& scope);
std::vector<Figure> rounding_in_float();  ///< part of the next
std::vector<Figure> single_precision(const Scope& scope);
std::vector<Figure> same_bits(const Scope& scope);
std::vector<Figure> denormals(const Scope& scope);
std::vector<Figure> swell(const Scope& scope);
std::vector<Figure> time_reversal(const Scope& scope);
std::vector<Figure> degenerate(const Scope& scope);
std::vector<Figure> ill_start(const Scope& scope);
std::vector<Figure> units(const Scope& scope);

}  // namespace hard_cases
