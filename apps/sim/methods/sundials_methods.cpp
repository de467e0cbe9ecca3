#include "sim/methods/table.hpp"

namespace gausssim {

namespace {

MethodInfo info(const char* name, int least_order, int order, const char* about) {
  MethodInfo result;
  result.name = name;
  result.library = "SUNDIALS";
  result.least_order = least_order;
  result.order = order;
  result.has_long_double = false;
  result.about = about;
#ifndef GAUSS_SIM_HAS_SUNDIALS
  result.missing = "it is not built in: SUNDIALS 6 (libsundials-dev) was not there when gauss-sim was built";
#endif
  return result;
}

MethodInfo drifting(MethodInfo result) {
  result.projects = false;
  return result;
}

std::vector<Method> of_arkode() {
  std::vector<MethodInfo> all{
      info("arkode_bogacki_shampine", 3, 3, "pair of order 3 (2) of Bogacki and Shampine"),
      info("arkode_zonneveld", 4, 4, "pair of order 4 (3) of Zonneveld"),
      info("arkode_cash_karp", 5, 5, "pair of order 5 (4) of Cash and Karp"),
      info("arkode_fehlberg", 5, 5, "pair of order 5 (4) of Fehlberg"),
      info("arkode_dormand_prince", 5, 5, "pair of order 5 (4) of Dormand and Prince"),
      info("arkode_verner", 6, 6, "pair of order 6 (5) of Verner"),
      blind(info("arkode_fehlberg78", 8, 8, "pair of order 8 (7) of Fehlberg")),
      stiff(info("arkode_trbdf2", 2, 2, "trapezium and backward difference, L-stable: stiff models, few digits")),
      stiff(info("arkode_esdirk4", 4, 4,
                 "diagonally implicit, six stages, of Kennedy and Carpenter, L-stable: stiff models")),
      stiff(info("arkode_kvaerno5", 5, 5, "diagonally implicit, seven stages, of Kvaerno: stiff models, more digits"))};
  std::vector<Method> methods;
  for (MethodInfo& one : all) {
    Method method{one, nullptr, nullptr};
#ifdef GAUSS_SIM_HAS_SUNDIALS
    method.in_double = [name = one.name](const Problem<double>& problem) { return make_arkode(problem, name); };
#endif
    methods.push_back(std::move(method));
  }
  return methods;
}

}  // namespace

std::vector<Method> sundials_methods() {
  std::vector<Method> all{
      {drifting(info("cvode_adams", 1, 12, "multistep method of Adams: rates that are dear to compute")), nullptr,
       nullptr},
      {stiff(info("cvode_bdf", 1, 5, "backward differentiation: stiff models")), nullptr, nullptr},
      {drifting(stiff(info("ida", 1, 5, "backward differentiation of y' - f(t, y) = 0: stiff models"))), nullptr,
       nullptr}};
#ifdef GAUSS_SIM_HAS_SUNDIALS
  all[0].in_double = make_cvode_adams;
  all[1].in_double = make_cvode_bdf;
  all[2].in_double = make_ida;
#endif
  for (Method& method : of_arkode()) all.push_back(std::move(method));
  return all;
}

}  // namespace gausssim
