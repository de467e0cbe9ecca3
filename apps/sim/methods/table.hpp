#pragma once
// All methods: what is said of them, and what makes them.

#include <functional>
#include <vector>

#include "sim/methods/makers.hpp"

namespace gausssim {

struct Method {
  template <class S>
  using Make = std::function<Made<S>(const Problem<S>&)>;

  MethodInfo info;
  Make<double> in_double;
  Make<long double> in_long_double;
  Make<float> in_float = nullptr;  ///< for few digits: of few methods
};

const std::vector<Method>& method_table();

/// For what decays, or is held, much faster than it moves.
inline MethodInfo stiff(MethodInfo result) {
  result.is_stiff = true;
  result.takes = {"jacobian"};
  return result;
}

/// Whose estimate of the error may not see that a force jumps.
inline MethodInfo blind(MethodInfo result) {
  result.sees_jumps = false;
  return result;
}

/// Those of SUNDIALS; where it is not there, with the reason.
std::vector<Method> sundials_methods();

}  // namespace gausssim
