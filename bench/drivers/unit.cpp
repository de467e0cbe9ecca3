// One right-hand side alone, to be compiled as a user would: how long that takes, and how many bytes come out.

#if defined(HEADER)
#include HEADER

gauss::Status right_hand_side(double t, const MODEL::State<double>& state, const MODEL::Inputs<double>& inputs,
                              const MODEL::Prepared<double>& prepared, MODEL::Derivative<double>& derivative) {
  return MODEL::rhs(t, state, inputs, prepared, derivative);
}
#elif defined(CASE_planar_chain)
#include "by_hand/planar_chain.hpp"

#if SIZE <= 2
void right_hand_side(const double* q, const double* v, double* a) { by_hand::planar_chain_closed<SIZE>(q, v, a); }
#else
void right_hand_side(const double* q, const double* v, double* a) { by_hand::planar_chain<SIZE>(q, v, a); }
#endif
#elif defined(CASE_spatial_chain)
#include "by_hand/spatial_chain.hpp"

void right_hand_side(const double* q, const double* v, double* a) { by_hand::spatial::spatial_chain<SIZE>(q, v, a); }
#elif defined(CASE_four_bar)
#include "by_hand/four_bar.hpp"

void right_hand_side(const double* q, const double* v, double* a) { by_hand::four_bar(q, v, a); }
#elif defined(CASE_rolling_disc)
#include "by_hand/rolling_disc.hpp"

void right_hand_side(const double* q, const double* v, double* a) { by_hand::rolling_disc(q, v, a); }
#endif
