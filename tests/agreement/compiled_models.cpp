#include "compiled_model.hpp"

#include <algorithm>
#include <memory>
#include <type_traits>

#include "headers/plain_models.hpp"
#include "large_headers.inc"

#define GAUSS_TESTED_MODEL(name_space) GAUSS_MAKE_TESTED(name_space)
#include "large_models.inc"
#undef GAUSS_TESTED_MODEL

namespace agreement {

namespace {

/// Time, state and parameters as they are set from test to test.
template <class M>
struct Point {
  double t = 0;
  typename M::template State<double> state{};
  typename M::template Inputs<double> inputs{};
  typename M::template Prepared<double> prepared = prepare(typename M::template Parameters<double>{});

  typename M::template Derivative<double> rates() const {
    typename M::template Derivative<double> d{};
    (void)rhs(t, state, inputs, prepared, d);
    return d;
  }
};

template <class M>
using Shared = std::shared_ptr<Point<M>>;

// Functions are found by their arguments; those that a model does not have are not called: its struct is empty.
template <class M>
void add_reactions(const Shared<M>& at, CompiledModel& compiled) {
  using Reactions = typename M::template ReactionsOrNone<double>;
  using Forces = typename M::template ForcesOf<double>;
  if constexpr (!std::is_empty_v<Reactions>) {
    compiled.reactions = [at] {
      Reactions result{};
      (void)reactions(at->t, at->state, at->inputs, at->prepared, result);
      return flattened(result);
    };
    compiled.rhs_and_reactions = [at] {
      typename M::template Derivative<double> d{};
      Reactions result{};
      (void)rhs_and_reactions(at->t, at->state, at->inputs, at->prepared, d, result);
      return std::pair{flattened(d), flattened(result)};
    };
    compiled.reaction_forces = [at] {
      Forces result{};
      (void)reaction_forces(at->t, at->state, at->inputs, at->prepared, result);
      return flattened(result);
    };
  }
}

template <class M>
void add_state_functions(const Shared<M>& at, CompiledModel& compiled) {
  compiled.energy = [at] {
    typename M::template EnergyOf<double> result{};
    (void)energy(at->t, at->state, at->prepared, result);
    return flattened(result);
  };
  compiled.mass_matrix = [at] {
    typename M::template MassMatrixOf<double> result{};
    (void)mass_matrix(at->t, at->state, at->prepared, result);
    return flattened(result);
  };
}

template <class M>
void add_functions_of_rates(const Shared<M>& at, CompiledModel& compiled) {
  using Residuals = typename M::template ResidualsOf<double>;
  using Compulsion = typename M::template CompulsionOf<double>;
  if constexpr (!std::is_empty_v<Residuals>) {
    compiled.residuals = [at] {
      Residuals result{};
      (void)residuals(at->t, at->state, at->inputs, at->prepared, at->rates(), result);
      return flattened(result);
    };
  }
  if constexpr (!std::is_empty_v<Compulsion>) {
    compiled.compulsion = [at] {
      Compulsion result{};
      (void)compulsion(at->t, at->state, at->inputs, at->prepared, at->rates(), result);
      return flattened(result);
    };
  }
}

template <class M>
CompiledModel compiled_model() {
  const auto at = std::make_shared<Point<M>>();
  CompiledModel compiled;
  compiled.file = M::name;
  compiled.parameters = flattened(typename M::template Parameters<double>{});
  compiled.set = [at](double t, const std::vector<double>& y) {
    at->t = t;
    std::copy(y.begin(), y.end(), at->state.values);
  };
  compiled.rhs = [at] { return flattened(at->rates()); };
  add_reactions<M>(at, compiled);
  add_state_functions<M>(at, compiled);
  add_functions_of_rates<M>(at, compiled);
  return compiled;
}

}  // namespace

const std::vector<CompiledModel>& compiled_models() {
  static const std::vector<CompiledModel> k_models{
#define GAUSS_TESTED_MODEL(name_space) compiled_model<name_space::Tested>(),
#include "large_models.inc"
#include "plain_models.inc"
#undef GAUSS_TESTED_MODEL
  };
  return k_models;
}

}  // namespace agreement
