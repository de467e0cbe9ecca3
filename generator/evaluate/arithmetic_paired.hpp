#pragma once
// One number in two precisions at once, so that what is nothing but rounding is seen where it arises.

#include "evaluate/arithmetic_cln.hpp"

namespace gaussgen::evaluate {

/// True values agree in both precisions, rounding does not.
struct Paired {
  cln::cl_F fine;
  cln::cl_F coarse;
};

/// After each operation that may cancel, a number that both precisions do not agree about to half of its size is 0 where it is small
/// beside what it was made of. Where it is not, it is not known, which is no harm in a sum with larger ones, as that of a state and the
/// last step of Newton's method; in what has no bound beside zero it is undefined. So cos(pi/2) is 0, 1/cos(pi/2) a division by
/// zero, and sin(10^200 x) has no value unless x has 200 digits.
template <>
class Arithmetic<Paired> {
 public:
  /// Decimal digits of the coarse numbers, and by how many the fine ones have more.
  Arithmetic(int digits, int more);

  const Arithmetic<cln::cl_F>& fine() const { return fine_; }

  template <class Number>
  Paired number(const Number& value) const {
    return {fine_.number(value), coarse_.number(value)};
  }

  Paired pi() const { return {fine_.pi(), coarse_.pi()}; }
  /// Of the coarse numbers.
  Paired epsilon() const { return number(coarse_.epsilon()); }
  Outcome<Paired> sum(const Rational& constant, const ir::Coefficients& coefficients,
                      const std::vector<Paired>& x) const;
  Outcome<Paired> product(const std::vector<Paired>& x) const;
  Outcome<Paired> power(const Paired& x, const Rational& exponent) const;
  Outcome<Paired> call(ir::Function function, const std::vector<Paired>& x) const;
  bool less(const Paired& a, const Paired& b) const;
  bool is_true(const Paired& x) const { return fine_.is_true(x.fine); }
  /// Both precisions agree about it, to half of its size.
  bool is_known(const Paired& x) const;

 private:
  using Numbers = Outcome<cln::cl_F>;

  Outcome<Paired> settled(const Numbers& fine, const Numbers& coarse, const cln::cl_F& size) const;
  cln::cl_F apart(const Paired& x) const;
  cln::cl_F rounding() const;
  Paired within_arc(const Paired& x) const;
  cln::cl_F integer(int value) const { return fine_.number(Rational(value)); }

  Arithmetic<cln::cl_F> fine_;
  Arithmetic<cln::cl_F> coarse_;
};

}  // namespace gaussgen::evaluate
