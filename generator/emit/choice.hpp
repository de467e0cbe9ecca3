#pragma once
// abs, sign, min, max and piecewise by comparison and selection, which every scalar type has. A comparison with what is
// not a number does not hold; each of these is written such that the result then is no number either, so that the status
// says so.

#include "emit/cpp_tree.hpp"

namespace gaussgen::emit {

struct Comparand {
  cpp::Expression value;
  bool is_number = false;  ///< a constant: no NaN comes from it
};

/// a < b, or a <= b.
struct Comparison {
  bool is_strict = true;
  Comparand a;
  Comparand b;
};

cpp::Expression size_of(const cpp::Expression& x);
cpp::Expression sign_of(const cpp::Expression& x);
cpp::Expression smaller(const Comparand& a, const Comparand& b);
cpp::Expression larger(const Comparand& a, const Comparand& b);
cpp::Expression by_case(const Comparison& condition, cpp::Expression yes, cpp::Expression no);

}  // namespace gaussgen::emit
