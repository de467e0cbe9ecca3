#include "sim/methods/methods.hpp"

#include <algorithm>

#include "gauss/integrate/nystrom_stepper.hpp"
#include "sim/drive/quad.hpp"
#include "sim/methods/makers.hpp"
#include "sim/methods/table.hpp"

namespace gausssim {

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> k_methods = [] {
    std::vector<MethodInfo> all;
    for (const Method& method : method_table()) all.push_back(method.info);
    return all;
  }();
  return k_methods;
}

const MethodInfo* find_method(const std::string& name) {
  const auto found =
      std::find_if(methods().begin(), methods().end(), [&](const MethodInfo& one) { return one.name == name; });
  return found == methods().end() ? nullptr : &*found;
}

template <class S>
std::string why_not_projected(const Functions<S>& functions, Projection how) {
  if (how == Projection::positions && !functions.positions) return "the model has no equations of positions";
  if (how == Projection::velocities && !(functions.projection && functions.is_constrained))
    return "the model has no constraints";
  if (how == Projection::gains && !functions.gains)
    return "gains are for compiled models with constraints, all of positions or all of velocities";
  if (how == Projection::energy && !(functions.energy && functions.energy_layout.is_conserved))
    return "the energy of the model may change: it has dampers, inputs, laws in time or forces without a potential";
  return {};
}

namespace {

const char* const k_no_series =
    "the model has no power series here: it has a jump or a kink, constraints that always follow from others, or it is "
    "interpreted";

std::string why_not_taken(const Method& method, bool has_number, Projection how) {
  if (!method.info.missing.empty()) return method.info.missing;
  if (!has_number) return "it computes in double, and no other number type";
  if (method.info.name == "taylor" && how != Projection::full && how != Projection::off)
    return "series take full projection, or none";
  if (!method.info.projects && how != Projection::off) return "it does not project: choose 'projection: off' with it";
  return {};
}

/// At the start, as far as a state and one that comes soon tell it; the method looks again on its way.
template <class S>
std::string why_not_separable(const Problem<S>& problem) {
  using Model = MotionModel<S>;
  const typename Model::State start{problem.start};
  const gauss::integrate::NystromWatch watch;
  if (watch.suits(problem.model, problem.t, problem.settings.step, start)) return {};
  const auto refused = gauss::integrate::refused_by_nystrom(problem.model, problem.t, start);
  if (refused.outcome != gauss::integrate::StepOutcome::unsuitable) return {};
  return "only models whose accelerations depend on coordinates alone suit it; gauss_legendre4 is symmetric, too, and "
         "takes any model";
}

template <class S>
Method::Make<S> maker_of(const Method& method) {
  if constexpr (std::is_same_v<S, double>) {
    return method.in_double;
  } else if constexpr (std::is_same_v<S, float>) {
    return method.in_float;
  } else {
    return method.in_long_double;
  }
}

}  // namespace

template <class S>
Made<S> make_integrator(const std::string& name, const MotionModel<S>& model, const Numbers<S>& start, const S& t,
                        const MethodSettings<S>& settings, std::string& why) {
  const auto& table = method_table();
  const auto method =
      std::find_if(table.begin(), table.end(), [&](const Method& one) { return one.info.name == name; });
  if (method == table.end()) return why = "there is no method '" + name + "'", nullptr;
  const Method::Make<S> make = maker_of<S>(*method);
  why = why_not_taken(*method, static_cast<bool>(make), settings.projection);
  const Problem<S> problem{model, start, t, settings};
  if (why.empty() && method->info.is_separable) why = why_not_separable(problem);
  if (!why.empty()) return why = "method '" + name + "': " + why, nullptr;
  why = why_not_projected(model.functions(), settings.projection);
  if (!why.empty()) return why = "no projection of this kind: " + why, nullptr;
  Made<S> made = make({model.projecting(settings.projection, t, start), start, t, settings});
  if (!made) why = k_no_series;
  return made;
}

/// The steppers of libraries have coefficients with fewer digits.
template <>
Made<Quad> make_integrator(const std::string& name, const MotionModel<Quad>& model, const Numbers<Quad>& start,
                           const Quad& t, const MethodSettings<Quad>& settings, std::string& why) {
  const bool is_known = settings.projection == Projection::full || settings.projection == Projection::off;
  const MethodInfo* const method = find_method(name);
  if (method == nullptr || !method->has_float128 || !is_known) {
    why = "in float128 there are taylor, bulirsch_stoer and dopri5, with full projection or none";
    return nullptr;
  }
  const Problem<Quad> problem{model, start, t, settings};
  Made<Quad> made = name == "taylor"   ? make_taylor(problem)
                    : name == "dopri5" ? make_dopri5(problem)
                                       : make_bulirsch_stoer(problem);
  if (!made) why = k_no_series;
  return made;
}

#define GAUSS_SIM_NUMBER(S)                                                                                \
  template std::string why_not_projected(const Functions<S>&, Projection);                                 \
  template Made<S> make_integrator(const std::string&, const MotionModel<S>&, const Numbers<S>&, const S&, \
                                   const MethodSettings<S>&, std::string&);
GAUSS_SIM_NUMBER(float)
GAUSS_SIM_NUMBER(double)
GAUSS_SIM_NUMBER(long double)
#undef GAUSS_SIM_NUMBER
template std::string why_not_projected(const Functions<Quad>&, Projection);

}  // namespace gausssim
