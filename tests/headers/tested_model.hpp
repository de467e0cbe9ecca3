#pragma once
// An emitted model as a type that tests can be written against: what GAUSS_MODEL gives, and the structs of results.

#include "gauss/model_concept.hpp"

namespace gauss {

/// For models that have none of their own: no constraints, no residuals, a massless body.
template <class S>
struct Reactions {};
template <class S>
struct ReactionForces {};
template <class S>
struct Residuals {};
template <class S>
struct Compulsion {};

}  // namespace gauss

// Functions are found by their arguments; types need the namespace, so this reopens it.
#define GAUSS_MAKE_TESTED(name_space)     \
  namespace name_space {                  \
  GAUSS_MODEL(Offered, name_space);       \
  struct Tested : Offered {               \
    template <class S>                    \
    using ReactionsOrNone = Reactions<S>; \
    template <class S>                    \
    using ForcesOf = ReactionForces<S>;   \
    template <class S>                    \
    using ResidualsOf = Residuals<S>;     \
    template <class S>                    \
    using CompulsionOf = Compulsion<S>;   \
    template <class S>                    \
    using EnergyOf = Energy<S>;           \
    template <class S>                    \
    using MassMatrixOf = MassMatrix<S>;   \
    template <class S>                    \
    static constexpr auto parameters() {  \
      return parameter_members<S>;        \
    }                                     \
    template <class S>                    \
    static constexpr auto inputs() {      \
      return input_members<S>;            \
    }                                     \
  };                                      \
  }
