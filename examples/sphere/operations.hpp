#pragma once
// Counts the operations of generated code by running it on a number type that counts. The type also shows what a type of one's
// own has to offer: arithmetic, and a specialisation of gauss::Math.

#include <cmath>
#include <limits>

#include "gauss/math.hpp"

namespace sphere {

struct Operations {
  int additions = 0;  ///< and subtractions; a change of sign is free
  int multiplications = 0;
  int divisions = 0;
  int functions = 0;  ///< sines, cosines, square roots
};

class Counted {
 public:
  Counted() = default;
  explicit Counted(double value) : value_(value), is_number_(true) {}
  explicit Counted(int value) : value_(value), is_number_(true) {}

  double value() const { return value_; }

  /// As if it came from elsewhere: what is computed with it counts.
  Counted as_given() const { return computed(value_); }
  static Operations& tally() {
    static Operations operations;
    return operations;
  }
  static Counted counted(int& counter, double value) {
    ++counter;
    return computed(value);
  }

  friend Counted operator-(Counted a) { return a.is_number_ ? Counted(-a.value_) : computed(-a.value_); }
  friend Counted operator+(Counted a, Counted b) { return counted(tally().additions, a.value_ + b.value_); }
  friend Counted operator-(Counted a, Counted b) { return counted(tally().additions, a.value_ - b.value_); }
  friend Counted operator*(Counted a, Counted b) { return counted(tally().multiplications, a.value_ * b.value_); }
  /// Compilers divide numbers by numbers.
  friend Counted operator/(Counted a, Counted b) {
    if (a.is_number_ && b.is_number_) return Counted(a.value_ / b.value_);
    return counted(tally().divisions, a.value_ / b.value_);
  }
  friend bool operator<(Counted a, Counted b) { return a.value_ < b.value_; }
  friend bool operator==(Counted a, Counted b) { return a.value_ == b.value_; }

 private:
  static Counted computed(double value) {
    Counted result;
    result.value_ = value;
    return result;
  }

  double value_ = 0;
  bool is_number_ = false;  ///< of the text, not of a computation
};

}  // namespace sphere

template <>
struct gauss::Math<sphere::Counted> : gauss::ScalarLogic<sphere::Counted> {
  using S = sphere::Counted;

  static S sin(S x) { return S::counted(S::tally().functions, std::sin(x.value())); }
  static S cos(S x) { return S::counted(S::tally().functions, std::cos(x.value())); }
  static S sqrt(S x) { return S::counted(S::tally().functions, std::sqrt(x.value())); }
  static void sincos(S x, S& sine, S& cosine) {
    sine = sin(x);
    cosine = cos(x);
  }
  static S epsilon() { return S(std::numeric_limits<double>::epsilon()); }
  /// A look at the results, not an operation of the mechanics.
  template <class... Values>
  static bool not_finite(const Values&...) {
    return false;
  }
};
