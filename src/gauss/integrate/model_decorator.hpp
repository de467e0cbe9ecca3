// What a model that leans on another one has from it.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_MODEL_DECORATOR_HPP
#define GAUSS_INTEGRATE_MODEL_DECORATOR_HPP

#include <cstddef>
#include <type_traits>
#include <utility>

namespace gauss::integrate {

/// `Decorated` has a member `base()`, a BoundModel or another such model, and says itself what it changes.
template <class Decorated, class Base>
class ModelDecorator {
 public:
  using State = typename Base::State;
  using Derivative = typename Base::Derivative;
  using Prepared = typename Base::Prepared;
  using Scalar = typename Base::Scalar;
  using Status = typename Base::Status;
  static constexpr std::size_t size = Base::size, n_q = Base::n_q, n_v = Base::n_v;

  Status derivative(const Scalar& t, const State& state, Derivative& result) const {
    return on().derivative(t, state, result);
  }
  template <class Result>
  Status derivatives(const Scalar& t, const State& state, Result& result) const {
    return on().derivatives(t, state, result);
  }
  template <class Result>
  Status energy(const Scalar& t, const State& state, Result& result) const {
    return on().energy(t, state, result);
  }
  Status projection(const Scalar& t, State& state) const { return on().projection(t, state); }
  Status position_step(const Scalar& t, State& state) const { return on().position_step(t, state); }
  Status speed_step(const Scalar& t, State& state) const { return on().speed_step(t, state); }
  decltype(auto) inputs(const Scalar& t, const State& state) const { return on().inputs(t, state); }
  const Prepared& prepared() const { return on().prepared(); }
  const char* unit(std::size_t component) const { return on().unit(component); }

 private:
  const Base& on() const { return static_cast<const Decorated&>(*this).base(); }
};

/// A model that writes the same motion in other coordinates from time to time has `rewrite(state)`. Simulations call it before a step; true: the state is
/// another one now, and what is known of earlier ones does not go on.
template <class Model, class = void>
struct Rewrites : std::false_type {};
template <class Model>
struct Rewrites<Model, std::void_t<decltype(std::declval<Model&>().rewrite(std::declval<typename Model::State&>()))>>
    : std::true_type {};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_MODEL_DECORATOR_HPP
