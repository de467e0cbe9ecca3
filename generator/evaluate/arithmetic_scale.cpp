#include "evaluate/arithmetic_scale.hpp"

namespace gaussgen::evaluate {

namespace {

template <class T>
std::vector<T> values_of(const std::vector<Scaled<T>>& x) {
  std::vector<T> values;
  for (const Scaled<T>& entry : x) values.push_back(entry.value);
  return values;
}

template <class T>
std::vector<T> scales_of(const std::vector<Scaled<T>>& x) {
  std::vector<T> scales;
  for (const Scaled<T>& entry : x) scales.push_back(entry.scale);
  return scales;
}

}  // namespace

// A scale is never below |v|: the first-order bound alone would vanish where a slope does.
template <class T>
Outcome<Scaled<T>> Arithmetic<Scaled<T>>::joined(const Outcome<T>& value, const Outcome<T>& scale) const {
  using Joined = Outcome<Scaled<T>>;
  if (!value) return Joined::undefined(value.reason());
  if (!scale) return Joined::undefined(reason::k_no_bound);
  const T least = magnitude(*value);
  return Scaled<T>{*value, *scale < least ? least : *scale};
}

template <class T>
Outcome<Scaled<T>> Arithmetic<Scaled<T>>::sum(const Rational& constant, const ir::Coefficients& coefficients,
                                              const std::vector<Scaled<T>>& x) const {
  ir::Coefficients sizes;
  for (const Rational& coefficient : coefficients) sizes.push_back(cln::abs(coefficient));
  return joined(base_.sum(constant, coefficients, values_of(x)), base_.sum(cln::abs(constant), sizes, scales_of(x)));
}

// Π s_i counts errors of second order in full: of the square of a sine of a large angle, the square of the angle. Where that is more
// than the first order, Σ s_i Π |v_j| over the other factors, it is the first order that counts.
template <class T>
Outcome<Scaled<T>> Arithmetic<Scaled<T>>::product(const std::vector<Scaled<T>>& x) const {
  T size = base_.number(Rational(1));
  T first_order = base_.number(Rational(0));
  for (const Scaled<T>& factor : x) {
    const T own = magnitude(factor.value);
    first_order = first_order * own + size * factor.scale;
    size = size * own;
  }
  return joined(base_.product(values_of(x)), lesser(base_.product(scales_of(x)), first_order));
}

template <class T>
Outcome<Scaled<T>> Arithmetic<Scaled<T>>::power(const Scaled<T>& x, const Rational& exponent) const {
  const Outcome<T> value = base_.power(x.value, exponent);
  const bool is_whole = exponent > 0 && support::is_integer(exponent);
  if (!value || !base_.is_true(x.scale)) return joined(value, value);
  const Outcome<T> slope_of = base_.power(x.value, exponent - 1);
  if (!slope_of) return joined(value, slope_of);
  const T size = magnitude(*slope_of) * base_.number(cln::abs(exponent));
  const Outcome<T> first_order = base_.product({size, x.scale});
  if (!is_whole || !first_order) return joined(value, first_order);
  return joined(value, lesser(base_.power(x.scale, exponent), *first_order));
}

template <class T>
Outcome<T> Arithmetic<Scaled<T>>::lesser(const Outcome<T>& a, const T& b) const {
  return a && *a < b ? a : b;
}

template <class T>
Outcome<Scaled<T>> Arithmetic<Scaled<T>>::call(ir::Function function, const std::vector<Scaled<T>>& x) const {
  const Outcome<T> value = base_.call(function, values_of(x));
  return joined(value, value ? spread(function, x) : value);
}

/// Σ |∂f/∂x_i| s_i
template <class T>
Outcome<T> Arithmetic<Scaled<T>>::spread(ir::Function function, const std::vector<Scaled<T>>& x) const {
  if (function == ir::Function::atan2) {
    const T length = x[0].value * x[0].value + x[1].value * x[1].value;
    const Outcome<T> reciprocal = base_.power(length, -1);
    if (!reciprocal) return reciprocal;
    const T across = magnitude(x[1].value) * x[0].scale + magnitude(x[0].value) * x[1].scale;
    return base_.product({across, *reciprocal});
  }
  if (!base_.is_true(x[0].scale)) return base_.number(Rational(0));
  const Outcome<T> slope_of = slope(function, x[0].value);
  if (!slope_of) return slope_of;
  return base_.product({magnitude(*slope_of), x[0].scale});
}

/// |f'(x)| up to sign
template <class T>
Outcome<T> Arithmetic<Scaled<T>>::slope(ir::Function function, const T& x) const {
  using ir::Function;
  const auto one_plus_square = [this](int sign, const T& a) { return base_.sum(1, {Rational(sign)}, {T(a * a)}); };
  const auto one_plus_square_of = [&](int sign, Function inner) {
    const Outcome<T> a = base_.call(inner, {x});
    return a ? one_plus_square(sign, *a) : a;
  };
  const auto power_of = [this](const Outcome<T>& a, const Rational& r) { return a ? base_.power(*a, r) : a; };
  switch (function) {
    case Function::sin: return base_.call(Function::cos, {x});
    case Function::cos: return base_.call(Function::sin, {x});
    case Function::tan: return one_plus_square_of(1, Function::tan);
    case Function::asin:
    case Function::acos: return power_of(one_plus_square(-1, x), Rational(-1) / 2);
    case Function::atan: return power_of(one_plus_square(1, x), -1);
    case Function::exp: return base_.call(Function::exp, {x});
    case Function::log: return base_.power(x, -1);
    case Function::sinh: return base_.call(Function::cosh, {x});
    case Function::cosh: return base_.call(Function::sinh, {x});
    case Function::tanh: return one_plus_square_of(-1, Function::tanh);
    default: return Outcome<T>::undefined(reason::k_no_bound);
  }
}

template class Arithmetic<Scaled<double>>;
template class Arithmetic<Scaled<long double>>;
template class Arithmetic<Scaled<cln::cl_F>>;

}  // namespace gaussgen::evaluate
