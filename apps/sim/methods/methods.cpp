#include "sim/methods/methods.hpp"

#include <algorithm>

#include "sim/drive/quad.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> k_methods{
      {"taylor", "gauss", 0, false,
       "power series of the motion, of an order that suits the tolerance; knows the motion within its steps"},
      {"prince87", "Odeint", 8, false, "pair of order 8 (7) of Prince and Dormand"},
      {"fehlberg78", "Odeint", 8, false, "pair of order 7 (8) of Fehlberg, taken at order 8"},
      {"dopri5", "Odeint", 5, false, "pair of order 5 (4) of Dormand and Prince"},
      {"cash_karp54", "Odeint", 5, false, "pair of order 5 (4) of Cash and Karp"},
      {"rk4", "Odeint", 4, true, "classical method of order 4, in steps of one length"}};
  return k_methods;
}

const MethodInfo* find_method(const std::string& name) {
  const auto found =
      std::find_if(methods().begin(), methods().end(), [&](const MethodInfo& one) { return one.name == name; });
  return found == methods().end() ? nullptr : &*found;
}

namespace {

const char* const k_no_series =
    "the model has no power series here: it has a jump or a kink, constraints that always follow from others, or it is "
    "interpreted";

}  // namespace

template <class S>
Made<S> make_integrator(const std::string& method, const MotionModel<S>& model, const Numbers<S>& start, const S& t,
                        const MethodSettings<S>& settings, std::string& why) {
  const Problem<S> problem{model, start, t, settings};
  if (method == "taylor") {
    Made<S> made = make_taylor(problem);
    if (!made) why = k_no_series;
    return made;
  }
  if (method == "prince87") return make_prince87(problem);
  if (method == "fehlberg78") return make_fehlberg78(problem);
  if (method == "dopri5") return make_dopri5(problem);
  if (method == "cash_karp54") return make_cash_karp54(problem);
  if (method == "rk4") return make_rk4(problem);
  why = "there is no method '" + method + "'";
  return nullptr;
}

/// The steppers of libraries have coefficients for less digits.
template <>
Made<Quad> make_integrator(const std::string& method, const MotionModel<Quad>& model, const Numbers<Quad>& start,
                           const Quad& t, const MethodSettings<Quad>& settings, std::string& why) {
  if (method != "taylor") {
    why = "in float128 there is no method but taylor";
    return nullptr;
  }
  Made<Quad> made = make_taylor(Problem<Quad>{model, start, t, settings});
  if (!made) why = k_no_series;
  return made;
}

template Made<double> make_integrator(const std::string&, const MotionModel<double>&, const Numbers<double>&,
                                      const double&, const MethodSettings<double>&, std::string&);
template Made<long double> make_integrator(const std::string&, const MotionModel<long double>&,
                                           const Numbers<long double>&, const long double&,
                                           const MethodSettings<long double>&, std::string&);

}  // namespace gausssim
