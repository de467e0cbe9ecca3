// Where lanes of a batch turn to another way, the others keep what they have.
// SPDX-License-Identifier: MIT-0
#ifndef GAUSS_LOST_LANES_HPP
#define GAUSS_LOST_LANES_HPP

#include <type_traits>

#include "gauss/math.hpp"

namespace gauss {

namespace detail {

/// Whether any lane has a status other than ok.
template <class S>
GAUSS_FUNCTION bool is_lost(const StatusOf<S>& status) {
  if constexpr (std::is_enum_v<StatusOf<S>>) {
    return status != StatusOf<S>::ok;
  } else {
    return status.any();
  }
}

/// In these lanes, the values of `from`; both are structs of nothing but S.
template <class S, class Values>
GAUSS_FUNCTION void take_lost(const StatusOf<S>& status, const Values& from, Values& to) {
  if constexpr (std::is_enum_v<StatusOf<S>>) {
    to = from;
  } else {
    static_assert(sizeof(Values) % sizeof(S) == 0, "a struct of nothing but S is expected");
    const S* source = reinterpret_cast<const S*>(&from);
    S* target = reinterpret_cast<S*>(&to);
    for (unsigned i = 0; i < sizeof(Values) / sizeof(S); ++i)
      target[i] = Math<S>::select(status.bad(), source[i], target[i]);
  }
}

/// What they have to say now.
template <class S>
GAUSS_FUNCTION StatusOf<S> status_of_lost(const StatusOf<S>& before, const StatusOf<S>& now) {
  if constexpr (std::is_enum_v<StatusOf<S>>) {
    return now;
  } else {
    return now.within(before.bad());
  }
}

}  // namespace detail

}  // namespace gauss

#endif  // GAUSS_LOST_LANES_HPP
