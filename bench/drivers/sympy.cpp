// Code by SymPy for mass matrix and forces, and a small solution of the equations. CASE_… says how its state comes from that of the
// case, HEADER is the code, TOOL who takes part.

#include "counted.hpp"

#include HEADER

#include "cases.hpp"
#include "solve.hpp"

namespace {

using by_sympy::n_q;
using by_sympy::n_u;

template <class S>
void right_hand_side(const S* x, const S* p, S* rates, S* u_dot) {
  S M[n_u * n_u];
  by_sympy::mass_and_force(x, p, M, u_dot, rates);
  if constexpr (!by_sympy::has_kinematics) {
    for (int i = 0; i < n_q; ++i) rates[i] = x[n_q + i];
  }
  if constexpr (by_sympy::is_symmetric) {
    bench::solve_symmetric<n_u>(M, u_dot);
  } else {
    bench::solve_by_pivots<n_u>(M, u_dot);
  }
}

#if defined(CASE_sphere) || defined(CASE_rolling_disc)
/// The two dependent speeds come last.
constexpr std::size_t k_order[] = {2, 3, 4, 0, 1};
#endif

struct System {
  struct State {
    double x[n_q + n_u];
  };
  struct Result {
    double rates[n_q], u_dot[n_u];
  };

  static State own(const bench::Sample& sample) {
    State state{};
#if defined(CASE_bicycle)
    bench::bicycle::to_sympy(sample, state.x);
#else
    [[maybe_unused]] double q = 0, v = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_q); ++i) {
#if defined(CASE_planar_chain) || defined(CASE_planar_pendulum)
      state.x[i] = q += sample.q[i];
      state.x[n_q + i] = v += sample.v[i];
#elif defined(CASE_spatial_chain)
      state.x[i] = sample.q[i];
      state.x[n_q + i] = sample.v[i];
#else
      state.x[i] = sample.q[k_order[i]];
      state.x[n_q + i] = sample.v[k_order[i]];
#endif
    }
#endif
    return state;
  }
  void operator()(const State& state, Result& result) const { right_hand_side(state.x, by_sympy::parameters, result.rates, result.u_dot); }
  static bool common(const State&, const Result& result, double* a) {
#if defined(CASE_bicycle)
    bench::bicycle::from_sympy(result.u_dot, a);
#else
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_u); ++i) {
#if defined(CASE_planar_chain) || defined(CASE_planar_pendulum)
      a[i] = result.u_dot[i] - (i == 0 ? 0 : result.u_dot[i - 1]);
#elif defined(CASE_spatial_chain)
      a[i] = result.u_dot[i];
#else
      a[k_order[i]] = result.u_dot[i];
#endif
    }
#endif
    return true;
  }
  static bool count([[maybe_unused]] bench::Operations& operations) {
#ifndef COUNT
    return false;
#else
    bench::Counted x[n_q + n_u], p[by_sympy::n_p], rates[n_q], u_dot[n_u];
    for (int i = 0; i < n_q + n_u; ++i) x[i] = bench::Counted::variable(0.3 + 0.11 * i);
    for (int i = 0; i < by_sympy::n_p; ++i) p[i] = bench::Counted::variable(by_sympy::parameters[i]);
    bench::Counted::tally() = {};
    right_hand_side(x, p, rates, u_dot);
    operations = bench::Counted::tally();
    return true;
#endif
  }
};

const bench::Registration k_registration({TOOL, "rhs", 1, true,
                                          [](const std::string&, int) { return bench::loop<System>(); }});

}  // namespace
