#pragma once
// The states of numbers.hpp for the steppers of Odeint. Apart, since Odeint takes compilers long.

#include <boost/numeric/odeint/algebra/algebra_dispatcher.hpp>
#include <boost/numeric/odeint/algebra/default_operations.hpp>
#include <boost/numeric/odeint/util/copy.hpp>
#include <boost/numeric/odeint/util/is_resizeable.hpp>
#include <boost/numeric/odeint/util/resize.hpp>
#include <boost/numeric/odeint/util/same_size.hpp>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include "sim/drive/numbers.hpp"

namespace gausssim {

/// Odeint's operations, entry by entry. The arrays of a step are apart from each other, or the same.
struct FlatAlgebra {
  template <class Operation, class First, class... Rest>
  static void each(Operation operation, First& first, Rest&... rest) {
    along(first.size(), operation, first.data(), rest.data()...);
  }

#define GAUSS_SIM_EACH(n)                                 \
  template <class... Arguments>                           \
  static void for_each##n(Arguments&&... arguments) {     \
    last_to_front(std::forward<Arguments>(arguments)...); \
  }
  GAUSS_SIM_EACH(1)
  GAUSS_SIM_EACH(2)
  GAUSS_SIM_EACH(3)
  GAUSS_SIM_EACH(4)
  GAUSS_SIM_EACH(5)
  GAUSS_SIM_EACH(6)
  GAUSS_SIM_EACH(7)
  GAUSS_SIM_EACH(8)
  GAUSS_SIM_EACH(9)
  GAUSS_SIM_EACH(10)
  GAUSS_SIM_EACH(11)
  GAUSS_SIM_EACH(12)
  GAUSS_SIM_EACH(13)
  GAUSS_SIM_EACH(14)
  GAUSS_SIM_EACH(15)
#undef GAUSS_SIM_EACH

  template <class S>
  static typename S::value_type norm_inf(const S& x) {
    using std::abs;
    typename S::value_type largest = 0;
    for (const auto& value : x) largest = abs(value) > largest ? abs(value) : largest;
    return largest;
  }

 private:
  template <class Operation, class... Pointers>
  static void along(std::size_t n, Operation operation, Pointers... at) {
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < n; ++i) operation(at[i]...);
  }

  template <class Tuple, std::size_t... i>
  static void rotated(Tuple arguments, std::index_sequence<i...>) {
    each(std::get<sizeof...(i)>(arguments), std::get<i>(arguments)...);
  }

  /// Odeint gives the operation behind the arrays.
  template <class... Arguments>
  static void last_to_front(Arguments&&... arguments) {
    rotated(std::tuple<Arguments&&...>(std::forward<Arguments>(arguments)...),
            std::make_index_sequence<sizeof...(Arguments) - 1>());
  }
};

}  // namespace gausssim

namespace boost::numeric::odeint {

template <class S>
struct is_resizeable<gausssim::Numbers<S>> {
  using type = boost::true_type;
  static const bool value = true;
};

template <class S>
struct algebra_dispatcher_sfinae<gausssim::Numbers<S>> {
  using algebra_type = gausssim::FlatAlgebra;
};
template <class S, std::size_t room>
struct algebra_dispatcher_sfinae<gausssim::InPlace<S, room>> {
  using algebra_type = gausssim::FlatAlgebra;
};

}  // namespace boost::numeric::odeint
