// Derivatives where constraints follow from others wherever they hold: along motions that the constraints leave, they are those of rhs.

#include <algorithm>
#include <cmath>
#include <random>

#include "ball_in_cylinder.hpp"
#include "bennett.hpp"
#include "bricard.hpp"
#include "catch_shim.hpp"
#include "conveyor.hpp"
#include "disc_in_ring.hpp"
#include "gauss/model_concept.hpp"
#include "planetary_gear.hpp"
#include "said_twice.hpp"
#include "sarrus.hpp"
#include "stiff_conveyor.hpp"
#include "two_hinge_door.hpp"

#ifdef GAUSS_HAS_SUNDIALS
#include "gauss/integrate/corrections.hpp"
#include "gauss/simulate/cvode.hpp"
#endif

namespace {

using gauss::Status;

// A model by its namespace, with its Jacobian as a dense matrix.
#define GAUSS_REDUNDANT(type, name_space)                                               \
  GAUSS_MODEL(type##Model, gauss::name_space);                                          \
  struct type : type##Model {                                                           \
    static constexpr int size = n_q + n_v;                                              \
    using JacobianOf = gauss::name_space::Jacobian<double>;                             \
    static void dense(const JacobianOf& jacobian, double* matrix) {                     \
      gauss::name_space::dense(jacobian, gauss::name_space::JacobianByState{}, matrix); \
    }                                                                                   \
  }

GAUSS_REDUNDANT(Ball, ball_in_cylinder);
GAUSS_REDUNDANT(Bennett, bennett);
GAUSS_REDUNDANT(Bricard, bricard);
GAUSS_REDUNDANT(Conveyor, conveyor);
GAUSS_REDUNDANT(Disc, disc_in_ring);
GAUSS_REDUNDANT(Door, two_hinge_door);
GAUSS_REDUNDANT(Gear, planetary_gear);
GAUSS_REDUNDANT(Sarrus, sarrus);
GAUSS_REDUNDANT(Twice, said_twice);

template <class Model, class S>
struct At {
  typename Model::template Prepared<S> prepared = Model::prepare(typename Model::template Parameters<S>{});

  /// The nearest state on the constraints.
  typename Model::template State<S> projected(const typename Model::template State<S>& near) const {
    typename Model::template State<S> state{};
    REQUIRE(project(S(0), near, prepared, state) == Status::ok);
    return state;
  }
  typename Model::template Derivative<S> rates(const typename Model::template State<S>& state) const {
    typename Model::template Derivative<S> derivative{};
    REQUIRE(Model::rhs(S(0), state, {}, prepared, derivative) == Status::ok);
    return derivative;
  }
};

/// Differences of long double between two states on the constraints, of the largest.
template <class Model>
void check_along_motions(double beside) {
  using Long = long double;
  const At<Model, double> here;
  const At<Model, Long> exact;
  constexpr int size = Model::size;
  std::mt19937_64 engine(11);
  std::normal_distribution<double> spread;
  double worst = 0;
  for (int trial = 0; trial < 10; ++trial) {
    typename Model::template State<Long> state{};
    REQUIRE(initial_state(exact.prepared, state) == Status::ok);
    for (int i = 0; i < size; ++i) state.values[i] += Long(beside * spread(engine));
    state = exact.projected(state);
    typename Model::template State<double> rounded{};
    for (int i = 0; i < size; ++i) rounded.values[i] = static_cast<double>(state.values[i]);
    typename Model::JacobianOf jacobian{};
    REQUIRE(jacobian_of(rounded, here, jacobian) == Status::ok);
    double matrix[size][size];
    Model::dense(jacobian, &matrix[0][0]);
    typename Model::template State<Long> ahead = state, behind = state;
    const Long step = 1e-6L;
    for (int i = 0; i < size; ++i) {
      const Long by = step * Long(spread(engine));
      ahead.values[i] += by;
      behind.values[i] -= by;
    }
    ahead = exact.projected(ahead);
    behind = exact.projected(behind);
    const auto rates_ahead = exact.rates(ahead), rates_behind = exact.rates(behind);
    Long error = 0, largest = 0;
    for (int i = 0; i < size; ++i) {
      Long sum = 0, of_terms = 0;
      for (int j = 0; j < size; ++j) {
        const Long term = Long(matrix[i][j]) * (ahead.values[j] - behind.values[j]);
        sum += term;
        of_terms += std::abs(term);
      }
      const Long difference = rates_ahead.values[i] - rates_behind.values[i];
      error = std::max(error, std::abs(sum - difference));
      largest = std::max({largest, std::abs(difference), of_terms});
    }
    worst = std::max(worst, static_cast<double>(error / largest));
  }
  CHECK(worst < 1e-9);
}

template <class State, class Here, class Jacobian>
Status jacobian_of(const State& state, const Here& here, Jacobian& result) {
  return jacobian(0.0, state, {}, here.prepared, result);
}

}  // namespace

TEST_CASE("the Jacobian of what rolls and says more than it must") {
  check_along_motions<Ball>(0.5);
  check_along_motions<Conveyor>(0.5);
  check_along_motions<Disc>(0.5);
  check_along_motions<Gear>(0.5);
}

TEST_CASE("the Jacobian of loops in space, a door on two hinges, and a constraint that is said twice") {
  check_along_motions<Bennett>(0.1);
  check_along_motions<Bricard>(0.1);
  check_along_motions<Sarrus>(0.1);
  check_along_motions<Door>(0.1);
  check_along_motions<Twice>(0.1);
}

#ifdef GAUSS_HAS_SUNDIALS
GAUSS_MODEL(StiffConveyor, gauss::stiff_conveyor);

// Newton's method of BDF converges with it: explicit steps would be 1e-5 s and shorter.
TEST_CASE("a stiff plate on rollers that say more than they must") {
  namespace emitted = gauss::stiff_conveyor;
  using Derivatives = gauss::integrate::EmittedJacobian<emitted::Jacobian<double>, emitted::JacobianByState>;
  const auto model = gauss::integrate::bind_model<StiffConveyor>();
  emitted::State<double> start;
  REQUIRE(initial_state(model.prepared(), start) == Status::ok);
  gauss::simulate::Settings<double> settings;
  settings.tolerance = 1e-9;
  gauss::simulate::CvodeSimulation<std::decay_t<decltype(model)>, Derivatives> run(model, start, 0, settings);
  REQUIRE(run.advance_to(5));
  CHECK(run.state().s() == Approx(std::sin(5.0)).epsilon(0).margin(1e-7));
  CHECK(run.state().q1() == Approx(-10 * std::sin(5.0)).epsilon(0).margin(1e-6));
  CHECK(run.report().steps < 2000);
}
#endif
