// Emitted code with what keeps it right in hard cases, and without, on one motion. HEADER, MODEL and TOOL say which; RULE, where there are two
// ways to accelerations, is the rule of its ranks. WITH_STEPS: steps of a Runge-Kutta method, too, with projection and without.

#include HEADER

#include "contender.hpp"
#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/corrections.hpp"
#include "gauss/integrate/explicit_stepper.hpp"
#ifdef RULE
#include "gauss/integrate/held_partition.hpp"
#endif

namespace {

namespace emitted = MODEL;
using Bound = gauss::integrate::BoundModel<emitted::State<double>, emitted::Derivative<double>,
                                           emitted::Prepared<double>, emitted::Inputs<double>, emitted::n_q>;
using Rk4 = gauss::integrate::Rk4<Bound>;

/// States of the motion that begins where the model says.
class OnItsMotion {
 public:
  using State = emitted::State<double>;

  State own(const bench::Sample& /*sample*/) {
    constexpr double h = 0.005;
    constexpr int k_steps = 4;
    if (!has_begun_) (void)emitted::initial_state(prepared_, state_);
    has_begun_ = true;
    gauss::integrate::Projected<Rk4> stepper;
    for (int i = 0; i < k_steps; ++i) (void)stepper.step(model_, 0.0, h, state_);
    return state_;
  }
  static bool count(bench::Operations&) { return false; }

 protected:
  emitted::Prepared<double> prepared_ = emitted::prepare(emitted::Parameters<double>{});
  emitted::Inputs<double> inputs_{};
  Bound model_{prepared_, inputs_};

 private:
  State state_{};
  bool has_begun_ = false;
};

struct Accelerations {
  emitted::Derivative<double> derivative;
  gauss::Status status;
};

template <class Result>
bool accelerations(const Result& result, double* a) {
  for (std::size_t i = 0; i < emitted::n_v; ++i) a[i] = result.derivative.values[emitted::n_q + i];
  return result.status == gauss::Status::ok;
}

struct AsEmitted : OnItsMotion {
  using Result = Accelerations;
  void operator()(const State& state, Result& result) const {
    result.status = emitted::rhs(0.0, state, inputs_, prepared_, result.derivative);
  }
  static bool common(const State&, const Result& result, double* a) { return accelerations(result, a); }
};
const bench::Registration k_rhs({TOOL, "rhs", 1, true,
                                 [](const std::string&, int) { return bench::loop<AsEmitted>(); }});

#ifdef RULE
struct CheapWay : OnItsMotion {
  using Result = Accelerations;
  void operator()(const State& state, Result& result) const {
    result.status = emitted::rhs_regular(0.0, state, inputs_, prepared_, result.derivative);
  }
  static bool common(const State&, const Result& result, double* a) { return accelerations(result, a); }
};
const bench::Registration k_cheap({TOOL, "rhs_regular", 1, true,
                                   [](const std::string&, int) { return bench::loop<CheapWay>(); }});

/// The best partition of the first state, held.
struct HeldChoice : OnItsMotion {
  using Result = Accelerations;
  using System = emitted::LinearSystem<double>;
  using ByParts = gauss::integrate::PartitionedModel<Bound, System>;
  static constexpr int n = static_cast<int>(emitted::n_v), l = static_cast<int>(emitted::n_constraints);

  State own(const bench::Sample& sample) {
    const State state = OnItsMotion::own(sample);
    if (!has_choice_) {
      System system;
      (void)emitted::linear_system(0.0, state, inputs_, prepared_, system);
      choice_ = gauss::integrate::Elimination<double, n, l>(system, RULE).best();
    }
    has_choice_ = true;
    return state;
  }
  void operator()(const State& state, Result& result) const {
    const Bound model(prepared_, inputs_);
    result.status = ByParts(model, RULE, choice_).derivative(0.0, state, result.derivative);
  }
  static bool common(const State&, const Result& result, double* a) { return accelerations(result, a); }

 private:
  ByParts::Choice choice_;
  bool has_choice_ = false;
};
const bench::Registration k_held({TOOL, "held", 1, true,
                                  [](const std::string&, int) { return bench::loop<HeldChoice>(); }});
#endif

#ifdef WITH_STEPS
template <class Stepper>
struct Steps : OnItsMotion {
  using Result = State;
  void operator()(const State& state, Result& result) const {
    const Bound model(prepared_, inputs_);
    Stepper stepper;
    result = state;
    (void)stepper.step(model, 0.0, 0.001, result);
  }
  static bool common(const State&, const Result&, double*) { return false; }
};
const bench::Registration k_step({TOOL, "step", 1, true,
                                  [](const std::string&, int) { return bench::loop<Steps<Rk4>>(); }});
const bench::Registration k_projected({TOOL, "step_projected", 1, true, [](const std::string&, int) {
                                         return bench::loop<Steps<gauss::integrate::Projected<Rk4>>>();
                                       }});
#endif

}  // namespace
