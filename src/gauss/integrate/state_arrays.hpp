// Arrays with a number for each component of a model's state.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_INTEGRATE_STATE_ARRAYS_HPP
#define GAUSS_INTEGRATE_STATE_ARRAYS_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace gauss::integrate {

/// Of number types of libraries, too.
template <class Scalar>
Scalar magnitude(const Scalar& x) {
  using std::abs;
  return abs(x);
}

template <class Model, class = void>
struct HasOwnArrays : std::false_type {};
template <class Model>
struct HasOwnArrays<Model, std::void_t<typename Model::Array>> : std::true_type {};

/// Of a model whose size its type tells, as of an emitted header.
template <class Model, bool has_own = HasOwnArrays<Model>::value>
struct StateArrays {
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  using Array = std::array<Scalar, Model::size>;
  template <class T>
  using Of = std::array<T, Model::size>;

  static constexpr std::size_t size(const Model&) { return Model::size; }
  static constexpr std::size_t n_q(const Model&) { return Model::n_q; }
  static Array zeros(const Model&) { return {}; }
  /// What the model's rates are to be written to.
  static auto rates(const Model&) { return typename Model::Derivative{}; }
  static State state_of(const Array& x) {
    State state;
    std::copy(x.begin(), x.end(), state.values);
    return state;
  }
  static Array array_of(const State& state) {
    Array x;
    std::copy(std::begin(state.values), std::end(state.values), x.begin());
    return x;
  }
  template <class T>
  static Of<T> filled(const Model&, const T& value) {
    Of<T> result{};
    result.fill(value);
    return result;
  }
};

/// Of one that knows its size at run time: it has the types Array and Of<T>, containers that are made with a size and a value, size() and coordinates(), a
/// State that is a struct of `Array values`, and rates(t, x, dxdt).
template <class Model>
struct StateArrays<Model, true> {
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  using Array = typename Model::Array;
  template <class T>
  using Of = typename Model::template Of<T>;

  static std::size_t size(const Model& model) { return model.size(); }
  static std::size_t n_q(const Model& model) { return model.coordinates(); }
  static Array zeros(const Model& model) { return Array(model.size(), Scalar(0)); }
  static auto rates(const Model& model) { return typename Model::Derivative{zeros(model)}; }
  static State state_of(const Array& x) { return {x}; }
  static const Array& array_of(const State& state) { return state.values; }
  template <class T>
  static Of<T> filled(const Model& model, const T& value) {
    return Of<T>(model.size(), value);
  }
};

template <class Model>
using StateArray = typename StateArrays<Model>::Array;

/// One number for each coordinate.
template <class Model, bool has_own = HasOwnArrays<Model>::value>
struct HalfArrays {
  using Array = std::array<typename Model::Scalar, Model::n_q>;
  static Array zeros(const Model&) { return {}; }
};
template <class Model>
struct HalfArrays<Model, true> {
  using Array = typename Model::Array;
  static Array zeros(const Model& model) { return Array(model.coordinates(), typename Model::Scalar(0)); }
};

namespace detail {

template <class Array, class = void>
struct Grows : std::false_type {};
template <class Array>
struct Grows<Array, std::void_t<decltype(std::declval<Array&>().resize(std::size_t{}))>> : std::true_type {};

}  // namespace detail

/// A container gets `size` elements; an array has them.
template <class Array>
void fit([[maybe_unused]] Array& x, [[maybe_unused]] std::size_t size) {
  if constexpr (detail::Grows<Array>::value) {
    if (x.size() != size) x.resize(size, typename Array::value_type{});
  }
}

/// Zeros, as many as `like` has.
template <class Array>
Array zeros_like(const Array& like) {
  Array result = like;
  std::fill(result.begin(), result.end(), typename Array::value_type(0));
  return result;
}

template <class State, class Array>
void copy_values(const State& state, Array& x) {
  std::copy(std::begin(state.values), std::end(state.values), x.begin());
}

template <class Array, class State>
void copy_into(const Array& x, State& state) {
  std::copy(x.begin(), x.end(), std::begin(state.values));
}

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_STATE_ARRAYS_HPP
