#pragma once
// An emitted model as a type that tests can be written against: what GAUSS_MODEL gives, and the structs of results.

#include "gauss/model_concept.hpp"

namespace gauss {

/// For models without constraints, which have no Reactions of their own.
template <class S>
struct Reactions {};

}  // namespace gauss

// Functions are found by their arguments; types need the namespace, so this reopens it.
#define GAUSS_MAKE_TESTED(name_space)            \
  namespace name_space {                         \
  GAUSS_MODEL(Offered, name_space);              \
  struct Tested : Offered {                      \
    template <class S>                           \
    using ReactionsOrNone = Reactions<S>;        \
    template <class S>                           \
    using EnergyOf = Energy<S>;                  \
    template <class S>                           \
    static constexpr auto parameters() {         \
      return parameter_members<S>;               \
    }                                            \
    template <class S>                           \
    static constexpr auto inputs() {             \
      return input_members<S>;                   \
    }                                            \
  };                                             \
  }
