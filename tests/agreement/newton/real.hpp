#pragma once
// The numbers in which a model is moved: double, or a hundred digits where that is built for (GAUSS_NEWTON_WIDE). One program has one of them.

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "support/rational.hpp"

#ifdef GAUSS_NEWTON_WIDE
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#endif

namespace agreement::newton {

#ifdef GAUSS_NEWTON_WIDE
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// With all digits: a quotient of whole numbers.
inline Real real(const gaussgen::support::Rational& value) {
  const std::string text = gaussgen::support::to_text(value);
  const std::size_t slash = text.find('/');
  const Real numerator(text.substr(0, slash));
  return slash == std::string::npos ? numerator : Real(numerator / Real(text.substr(slash + 1)));
}
#else
using Real = double;

inline Real real(const gaussgen::support::Rational& value) { return gaussgen::support::to_double(value); }
#endif

/// Of the standard library, or of the wide type.
namespace functions {
#ifdef GAUSS_NEWTON_WIDE
namespace wide = boost::multiprecision;
#define GAUSS_NEWTON_FUNCTION(name) \
  using std::name;                  \
  using wide::name;
#else
#define GAUSS_NEWTON_FUNCTION(name) using std::name;
#endif
GAUSS_NEWTON_FUNCTION(acos)
GAUSS_NEWTON_FUNCTION(asin)
GAUSS_NEWTON_FUNCTION(atan)
GAUSS_NEWTON_FUNCTION(atan2)
GAUSS_NEWTON_FUNCTION(cos)
GAUSS_NEWTON_FUNCTION(cosh)
GAUSS_NEWTON_FUNCTION(exp)
GAUSS_NEWTON_FUNCTION(fabs)
GAUSS_NEWTON_FUNCTION(log)
GAUSS_NEWTON_FUNCTION(pow)
GAUSS_NEWTON_FUNCTION(sin)
GAUSS_NEWTON_FUNCTION(sinh)
GAUSS_NEWTON_FUNCTION(sqrt)
GAUSS_NEWTON_FUNCTION(tan)
GAUSS_NEWTON_FUNCTION(tanh)
#undef GAUSS_NEWTON_FUNCTION
}  // namespace functions

using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using MatrixX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

}  // namespace agreement::newton
