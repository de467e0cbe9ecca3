#pragma once
// One for each method; each in a file of its own, since the steppers of Odeint take compilers long.

#include <memory>

#include "sim/drive/quad.hpp"
#include "sim/methods/methods.hpp"

namespace gausssim {

/// `model` projects as the settings say.
template <class S>
struct Problem {
  const MotionModel<S>& model;
  const Numbers<S>& start;
  S t;
  const MethodSettings<S>& settings;
};

template <class S>
using Made = std::unique_ptr<Integrator<S>>;

#define GAUSS_SIM_MAKER(method) \
  template <class S>            \
  Made<S> make_##method(const Problem<S>& problem);

GAUSS_SIM_MAKER(prince87)
GAUSS_SIM_MAKER(fehlberg78)
GAUSS_SIM_MAKER(dopri5)
GAUSS_SIM_MAKER(cash_karp54)
GAUSS_SIM_MAKER(bulirsch_stoer)
/// Null where the engine has no series of the model.
GAUSS_SIM_MAKER(taylor)
GAUSS_SIM_MAKER(radau)
GAUSS_SIM_MAKER(rk4)
GAUSS_SIM_MAKER(verlet)
GAUSS_SIM_MAKER(mclachlan4)
GAUSS_SIM_MAKER(kahan_li8)
GAUSS_SIM_MAKER(gauss_legendre2)
GAUSS_SIM_MAKER(gauss_legendre4)
GAUSS_SIM_MAKER(gauss_legendre6)
#undef GAUSS_SIM_MAKER

template <>
Made<Quad> make_bulirsch_stoer(const Problem<Quad>& problem);
template <>
Made<Quad> make_dopri5(const Problem<Quad>& problem);

// Of SUNDIALS, which computes in double; defined where it is installed.
Made<double> make_cvode_adams(const Problem<double>& problem);
Made<double> make_cvode_bdf(const Problem<double>& problem);
Made<double> make_arkode(const Problem<double>& problem, const std::string& method);
Made<double> make_ida(const Problem<double>& problem);

}  // namespace gausssim
