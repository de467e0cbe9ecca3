#include "catch_shim.hpp"
#include "gauss/model_concept.hpp"

#include "pendulum.hpp"
#include "springs.hpp"

namespace {

GAUSS_MODEL(Pendulum, gauss::pendulum);
GAUSS_MODEL(Springs, gauss::springs);

static_assert(gauss::is_model<Pendulum, double> && gauss::is_model<Springs, float>);
static_assert(!gauss::is_model<int, double>);

/// A driver that knows no model.
template <class Model>
gauss::Status first_step(typename Model::template State<double>& state) {
  const auto prepared = Model::prepare(typename Model::template Parameters<double>{});
  typename Model::template Derivative<double> derivative;
  const gauss::Status status = Model::rhs(0.0, state, {}, prepared, derivative);
  for (int i = 0; i < Model::n_q + Model::n_v; ++i) state.values[i] += 0.5 * derivative.values[i];
  return status;
}

}  // namespace

TEST_CASE("a driver runs any emitted model by what every model offers") {
  gauss::pendulum::State<double> pendulum{{0, 2}};
  CHECK(first_step<Pendulum>(pendulum) == gauss::Status::ok);
  CHECK(pendulum.theta() == 1);
  gauss::springs::State<double> springs{{0, 0, 1, 3}};
  CHECK(first_step<Springs>(springs) == gauss::Status::ok);
  CHECK(springs.y() == 1.5);
  CHECK(std::string(Springs::coordinates[1].name) == "y");
}
