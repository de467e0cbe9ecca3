// What a driver (integrator, simulator, table printer) may rely on in every emitted model.
// SPDX-License-Identifier: MIT-0
//
// An emitted model is a namespace, and C++17 cannot pass one to a template. GAUSS_MODEL makes a type of it:
//
//     GAUSS_MODEL(Pendulum, gauss::pendulum);
//     static_assert(gauss::is_model<Pendulum, double>);
//     gauss::Status s = Pendulum::rhs(t, state, inputs, prepared, derivative);

#ifndef GAUSS_MODEL_CONCEPT_HPP
#define GAUSS_MODEL_CONCEPT_HPP

#include <type_traits>
#include <utility>

#include "gauss/math.hpp"

namespace gauss {

namespace concept_detail {

template <class M, class S>
using RhsOf = decltype(M::rhs(std::declval<const S&>(), std::declval<const typename M::template State<S>&>(),
                              std::declval<const typename M::template Inputs<S>&>(),
                              std::declval<const typename M::template Prepared<S>&>(),
                              std::declval<typename M::template Derivative<S>&>()));

template <class M, class S>
using PreparedOf = decltype(M::prepare(std::declval<const typename M::template Parameters<S>&>()));

template <class M, class S, class = void>
struct IsModel : std::false_type {};

template <class M, class S>
struct IsModel<M, S, std::void_t<RhsOf<M, S>, PreparedOf<M, S>>>
    : std::bool_constant<std::is_same_v<RhsOf<M, S>, StatusOf<S>> &&
                         std::is_same_v<PreparedOf<M, S>, typename M::template Prepared<S>> &&
                         // The state and its rate are arrays of coordinates and speeds and nothing else.
                         sizeof(typename M::template State<S>) == sizeof(S[static_cast<unsigned>(M::n_q + M::n_v)]) &&
                         sizeof(typename M::template Derivative<S>) == sizeof(typename M::template State<S>)> {};

}  // namespace concept_detail

/// True for types made by GAUSS_MODEL from a model that can be evaluated with S.
template <class M, class S>
inline constexpr bool is_model = concept_detail::IsModel<M, S>::value;

}  // namespace gauss

/// A type that stands for the emitted namespace `name_space`. Forwarding costs nothing: all of it is inline.
#define GAUSS_MODEL(type, name_space)                                                                                 \
  struct type {                                                                                                       \
    template <class S>                                                                                                \
    using Parameters = name_space::Parameters<S>;                                                                     \
    template <class S>                                                                                                \
    using Inputs = name_space::Inputs<S>;                                                                             \
    template <class S>                                                                                                \
    using Prepared = name_space::Prepared<S>;                                                                         \
    template <class S>                                                                                                \
    using State = name_space::State<S>;                                                                               \
    template <class S>                                                                                                \
    using Derivative = name_space::Derivative<S>;                                                                     \
    static constexpr int n_q = name_space::n_q;                                                                       \
    static constexpr int n_v = name_space::n_v;                                                                       \
    static constexpr int n_parameters = name_space::n_parameters;                                                     \
    static constexpr int n_inputs = name_space::n_inputs;                                                             \
    template <class S>                                                                                                \
    static constexpr auto parameters_of() {                                                                       \
      return name_space::parameter_members<S>;                                                                        \
    }                                                                                                                 \
    template <class S>                                                                                                \
    static constexpr auto inputs_of() {                                                                           \
      return name_space::input_members<S>;                                                                            \
    }                                                                                                                 \
    static constexpr const char* name = name_space::name_of_model;                                                    \
    static constexpr const ::gauss::Quantity* coordinates = name_space::coordinate_table;                             \
    static constexpr const ::gauss::Quantity* speeds = name_space::speed_table;                                       \
    static constexpr const ::gauss::Quantity* parameters = name_space::parameter_table;                               \
    static constexpr const ::gauss::Quantity* inputs = name_space::input_table;                                       \
    template <class S>                                                                                                \
    GAUSS_FUNCTION static Prepared<S> prepare(const Parameters<S>& values) noexcept {                                 \
      return name_space::prepare(values);                                                                             \
    }                                                                                                                 \
    template <class S>                                                                                                \
    GAUSS_FUNCTION static ::gauss::StatusOf<S> rhs(const S& t, const State<S>& state, const Inputs<S>& supplied,      \
                                                   const Prepared<S>& prepared, Derivative<S>& derivative) noexcept { \
      return name_space::rhs(t, state, supplied, prepared, derivative);                                               \
    }                                                                                                                 \
  }

#endif  // GAUSS_MODEL_CONCEPT_HPP
