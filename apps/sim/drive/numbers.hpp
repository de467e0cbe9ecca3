#pragma once
// States whose size is known when a program runs, or with room for the state of any small model.

#include <array>
#include <boost/container/small_vector.hpp>
#include <cstddef>

namespace gausssim {

/// In place up to the size of small models: a step allocates nothing then.
inline constexpr std::size_t k_in_place = 16;

template <class S>
using Numbers = boost::container::small_vector<S, k_in_place>;

/// Loops over a state are straight code then. A state that is shorter ends with zeros.
template <class S, std::size_t room>
struct InPlace : std::array<S, room> {
  InPlace() : std::array<S, room>{} {}
  /// As containers are made.
  InPlace(std::size_t, const S& value) { this->fill(value); }
};

}  // namespace gausssim
