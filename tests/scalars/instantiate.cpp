// Compiled by several compilers and standards with all warnings as errors: every function of every sample.

#include "nasty.hpp"
#include "pendulum.hpp"
#include "pendulum.hpp"
#include "springs.hpp"
#include "zoo.hpp"

namespace {

template <class S>
void use_all() {
  {
    namespace model = gauss::pendulum;
    const auto prepared = model::prepare(model::Parameters<S>{});
    model::State<S> state{};
    model::Derivative<S> derivative{};
    model::Reactions<S> reactions{};
    model::Energy<S> energy{};
    model::Residual<S> residual{};
    (void)model::initial_state(prepared, state);
    (void)model::rhs(S(0), state, {}, prepared, derivative);
    (void)model::rhs_and_reactions(S(0), state, {}, prepared, derivative, reactions);
    (void)model::reactions(S(0), state, {}, prepared, reactions);
    (void)model::energy(S(0), state, {}, prepared, energy);
    (void)model::residual(S(0), state, {}, prepared, derivative, residual);
  }
  {
    namespace model = gauss::springs;
    const auto prepared = model::prepare(model::Parameters<S>{});
    model::State<S> state{};
    model::Derivative<S> derivative{};
    model::Energy<S> energy{};
    model::Centre<S> centre{};
    (void)model::rhs(S(0), state, {}, prepared, derivative);
    (void)model::energy(S(0), state, {}, prepared, energy);
    (void)model::centre(S(0), state, {}, prepared, centre);
    (void)model::project(S(0), state, {}, prepared, state);
  }
  {
    namespace model = gauss::linux_;
    const auto prepared = model::prepare(model::Parameters<S>{});
    const model::State<S> state{};
    model::Derivative<S> derivative{};
    model::Outputs<S> outputs{};
    (void)model::rhs(S(0), state, {}, prepared, derivative);
    (void)model::outputs(S(0), state, {}, prepared, outputs);
  }
  {
    namespace model = models::zoo;
    const auto prepared = model::prepare(model::Parameters<S>{});
    const model::State<S> state{};
    model::Functions<S> functions{};
    model::Powers<S> powers{};
    model::Sums<S> sums{};
    model::Numbers<S> numbers{};
    model::Conditions<S> conditions{};
    (void)model::functions(S(0), state, {}, prepared, functions);
    (void)model::powers(S(0), state, {}, prepared, powers);
    (void)model::sums(S(0), state, {}, prepared, sums);
    (void)model::numbers(S(0), state, {}, prepared, numbers);
    (void)model::conditions(S(0), state, {}, prepared, conditions);
  }
}

}  // namespace

int main() {
  use_all<float>();
  use_all<double>();
  use_all<long double>();
  return 0;
}
