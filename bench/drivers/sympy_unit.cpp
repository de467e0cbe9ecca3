// Code by SymPy alone, with its solution, for compile time and size: see unit.cpp.

#include HEADER

#include "solve.hpp"

void right_hand_side(const double* x, double* rates, double* u_dot) {
  double M[by_sympy::n_u * by_sympy::n_u];
  by_sympy::mass_and_force(x, by_sympy::parameters, M, u_dot, rates);
  if constexpr (by_sympy::is_symmetric) {
    bench::solve_symmetric<by_sympy::n_u>(M, u_dot);
  } else {
    bench::solve_by_pivots<by_sympy::n_u>(M, u_dot);
  }
}
