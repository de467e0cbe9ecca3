#pragma once
// CLN floats of one precision: the reference that double is judged by.

#include <cln/float.h>

#include "evaluate/arithmetic.hpp"

namespace gaussgen::evaluate {

/// Works with `digits` decimal digits and a few more, so that the rounding of single operations stays below them.
/// (What cancels in a difference is lost all the same: Scaled<cl_F> tells how much.)
template <>
class Arithmetic<cln::cl_F> {
 public:
  explicit Arithmetic(int digits);

  int digits() const { return digits_; }

  /// `value` in the working precision. Whatever enters goes through here: CLN lets the shorter operand decide.
  cln::cl_F number(const cln::cl_F& value) const { return cln::cl_float(value, format_); }
  cln::cl_F number(const Rational& value) const { return cln::cl_float(value, format_); }
  cln::cl_F number(double value) const;

  cln::cl_F pi() const { return cln::pi(format_); }
  cln::cl_F epsilon() const;
  Outcome<cln::cl_F> sum(const Rational& constant, const ir::Coefficients& coefficients,
                         const std::vector<cln::cl_F>& x) const;
  Outcome<cln::cl_F> product(const std::vector<cln::cl_F>& x) const;
  Outcome<cln::cl_F> power(const cln::cl_F& x, const Rational& exponent) const;
  Outcome<cln::cl_F> call(ir::Function function, const std::vector<cln::cl_F>& x) const;
  bool less(const cln::cl_F& a, const cln::cl_F& b) const { return a < b; }
  bool is_true(const cln::cl_F& x) const { return !cln::zerop(x); }

 private:
  Outcome<cln::cl_F> checked(const cln::cl_F& value) const;
  cln::cl_F widened(const cln::cl_F& x, std::int64_t bits) const;
  Outcome<cln::cl_F> applied(ir::Function function, const std::vector<cln::cl_F>& x) const;
  Outcome<cln::cl_F> exponential(ir::Function function, const cln::cl_F& x) const;
  Outcome<cln::cl_F> trigonometric(ir::Function function, const cln::cl_F& x) const;

  int digits_;
  cln::float_format_t format_;
};

}  // namespace gaussgen::evaluate
