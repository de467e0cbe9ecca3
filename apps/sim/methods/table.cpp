#include "sim/methods/table.hpp"

#include <iterator>
#include <utility>

namespace gausssim {

namespace {

MethodInfo info(const char* name, const char* library, int order, const char* about) {
  MethodInfo result;
  result.name = name;
  result.library = library;
  result.least_order = result.order = order;
  result.about = about;
  return result;
}

MethodInfo in_float(MethodInfo result) {
  result.has_float = true;
  return result;
}

/// Whose coefficients are exact in any number type.
MethodInfo in_float128(MethodInfo result) {
  result.has_float128 = true;
  return result;
}

MethodInfo stepwise(MethodInfo result) {
  result.tells_steps = true;
  return result;
}

MethodInfo fixed(MethodInfo result) {
  result.takes_step = true;
  return result;
}

MethodInfo symplectic(MethodInfo result) {
  result.takes_step = result.is_separable = true;
  return blind(result);
}

MethodInfo of_orders(int least, MethodInfo result) {
  result.least_order = least;
  return result;
}

#define GAUSS_SIM_METHOD(said, make) \
  { said, make<double>, make<long double> }
#define GAUSS_SIM_METHOD_IN_FLOAT(said, make) \
  { in_float(said), make<double>, make<long double>, make<float> }

MethodInfo within_steps(MethodInfo result) {
  result.ends_at_samples = false;
  return result;
}

std::vector<Method> of_everywhere() {
  return {
      GAUSS_SIM_METHOD_IN_FLOAT(
          blind(within_steps(in_float128(
              of_orders(2, info("taylor", "gauss", 40,
                                "power series of the motion, of an order that suits the tolerance; knows the "
                                "motion within its steps: the default"))))),
          make_taylor),
      GAUSS_SIM_METHOD_IN_FLOAT(
          stepwise(info("prince87", "Odeint", 8,
                        "pair of order 8 (7) of Prince and Dormand: the default where there is no series")),
          make_prince87),
      GAUSS_SIM_METHOD(
          stepwise(blind(info("fehlberg78", "Odeint", 8, "pair of order 7 (8) of Fehlberg, taken at order 8"))),
          make_fehlberg78),
      GAUSS_SIM_METHOD_IN_FLOAT(
          stepwise(
              in_float128(info("dopri5", "Odeint", 5,
                               "pair of order 5 (4) of Dormand and Prince: few digits, cheaply; forces that jump"))),
          make_dopri5),
      GAUSS_SIM_METHOD(stepwise(info("cash_karp54", "Odeint", 5, "pair of order 5 (4) of Cash and Karp")),
                       make_cash_karp54),
      GAUSS_SIM_METHOD(
          blind(in_float128(of_orders(
              4, info("bulirsch_stoer", "Odeint", 16, "extrapolation of the midpoint rule: long steps, many digits")))),
          make_bulirsch_stoer),
      GAUSS_SIM_METHOD_IN_FLOAT(
          stepwise(stiff(info("radau", "gauss", 9, "collocation at 5 points of Radau: stiff models, many digits"))),
          make_radau),
      GAUSS_SIM_METHOD_IN_FLOAT(fixed(info("rk4", "Odeint", 4, "classical method of Runge and Kutta")), make_rk4),
      GAUSS_SIM_METHOD(
          symplectic(info("verlet", "gauss", 2, "symplectic, one call in a step: the energy stays bounded")),
          make_verlet),
      GAUSS_SIM_METHOD(symplectic(info("mclachlan4", "Odeint", 4, "symplectic, five calls in a step")),
                       make_mclachlan4),
      GAUSS_SIM_METHOD(
          symplectic(info("kahan_li8", "gauss", 8, "symplectic, 17 calls in a step, compensated sums: very long runs")),
          make_kahan_li8),
      GAUSS_SIM_METHOD(fixed(info("gauss_legendre2", "gauss", 2, "implicit midpoint rule: symmetric, for any model")),
                       make_gauss_legendre2),
      GAUSS_SIM_METHOD(fixed(info("gauss_legendre4", "gauss", 4, "collocation at 2 points of Gauss: symmetric")),
                       make_gauss_legendre4),
      GAUSS_SIM_METHOD(
          fixed(info("gauss_legendre6", "gauss", 6, "collocation at 3 points of Gauss: symmetric, compensated sums")),
          make_gauss_legendre6)};
}
#undef GAUSS_SIM_METHOD
#undef GAUSS_SIM_METHOD_IN_FLOAT

}  // namespace

const std::vector<Method>& method_table() {
  static const std::vector<Method> k_table = [] {
    std::vector<Method> all = of_everywhere();
    for (Method& method : sundials_methods()) all.push_back(std::move(method));
    return all;
  }();
  return k_table;
}

}  // namespace gausssim
