#include "compiled_model.hpp"

#include <algorithm>
#include <memory>

#include "appell_hamel.hpp"
#include "chaplygin_sleigh.hpp"
#include "nonholonomic_particle.hpp"
#include "rotor_on_platform.hpp"
#include "skater_quaternion.hpp"
#include "skew_chart.hpp"
#include "skew_nonholonomic.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"
#include "sphere_turntable.hpp"

namespace agreement {




// The members that a model has depend on the model, so a template could not name them; everything else is the same text.
#define GAUSS_BEGIN_MODEL(name)                                                                        \
  {                                                                                                    \
    namespace model = gauss::name;                                                                     \
    struct Point {                                                                                     \
      double t = 0;                                                                                    \
      model::State<double> state{};                                                                    \
      model::Inputs<double> inputs{};                                                                  \
      model::Prepared<double> prepared = model::prepare(model::Parameters<double>{});                  \
    };                                                                                                 \
    const auto at = std::make_shared<Point>();                                                         \
    CompiledModel compiled;                                                                            \
    compiled.file = #name;                                                                             \
    compiled.parameters = flattened(model::Parameters<double>{});                                      \
    compiled.set = [at](double t, const std::vector<double>& y) {                                      \
      at->t = t;                                                                                       \
      std::copy(y.begin(), y.end(), at->state.values);                                                 \
    };                                                                                                 \
    const auto rates = [at] {                                                                          \
      model::Derivative<double> d{};                                                                   \
      model::rhs(at->t, at->state, at->inputs, at->prepared, d);                                       \
      return d;                                                                                        \
    };                                                                                                 \
    compiled.rhs = [rates] { return flattened(rates()); };                                             \
    GAUSS_RESULT_OF_STATE(energy, Energy)                                                              \
    GAUSS_RESULT_OF_STATE(mass_matrix, MassMatrix)                                                     \
    GAUSS_RESULT_OF_RATES(compulsion, Compulsion)
#define GAUSS_RESULT(function, Type)                                                                   \
  compiled.function = [at] {                                                                           \
    model::Type<double> result{};                                                                      \
    model::function(at->t, at->state, at->inputs, at->prepared, result);                               \
    return flattened(result);                                                                          \
  };
#define GAUSS_RESULT_OF_STATE(function, Type)                                                          \
  compiled.function = [at] {                                                                           \
    model::Type<double> result{};                                                                      \
    model::function(at->t, at->state, at->prepared, result);                                           \
    return flattened(result);                                                                          \
  };
#define GAUSS_RESULT_OF_RATES(function, Type)                                                          \
  compiled.function = [at, rates] {                                                                    \
    model::Type<double> result{};                                                                      \
    model::function(at->t, at->state, at->inputs, at->prepared, rates(), result);                      \
    return flattened(result);                                                                          \
  };
#define GAUSS_CONSTRAINED                                                                              \
  GAUSS_RESULT(reactions, Reactions)                                                                   \
  GAUSS_RESULT(reaction_forces, ReactionForces)
#define GAUSS_WITH_RESIDUALS GAUSS_RESULT_OF_RATES(residuals, Residuals)
#define GAUSS_END_MODEL            \
  models.push_back(compiled);      \
  }

const std::vector<CompiledModel>& compiled_models() {
  static const std::vector<CompiledModel> k_models = [] {
    std::vector<CompiledModel> models;
    GAUSS_BEGIN_MODEL(appell_hamel) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(chaplygin_sleigh) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(nonholonomic_particle) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(rotor_on_platform) GAUSS_CONSTRAINED GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(skater_quaternion) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(skew_chart) GAUSS_CONSTRAINED GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(skew_nonholonomic) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(sphere_in_cylinder) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(sphere_in_cylinder_quaternion) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    GAUSS_BEGIN_MODEL(sphere_turntable) GAUSS_CONSTRAINED GAUSS_WITH_RESIDUALS GAUSS_END_MODEL
    return models;
  }();
  return k_models;
}

}  // namespace agreement
