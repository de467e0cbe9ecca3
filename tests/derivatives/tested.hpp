#pragma once
// An emitted model with its Jacobian as a type. Functions are found by their arguments; types need the namespace.

#include "gauss/model_concept.hpp"

#define GAUSS_MAKE_TESTED(name_space)                                                                 \
  namespace name_space {                                                                              \
  GAUSS_MODEL(Offered, name_space);                                                                   \
  struct Tested : Offered {                                                                           \
    template <class S>                                                                                \
    using JacobianOf = Jacobian<S>;                                                                   \
    using ByState = JacobianByState;                                                                  \
    using ByInputs = JacobianByInputs;                                                                \
    using ByTime = JacobianByTime;                                                                    \
    template <class S>                                                                                \
    static gauss::StatusOf<S> jacobian_at(const S& t, const State<S>& state, const Inputs<S>& inputs, \
                                          const Prepared<S>& prepared, Jacobian<S>& result) {         \
      return jacobian(t, state, inputs, prepared, result);                                            \
    }                                                                                                 \
  };                                                                                                  \
  }
