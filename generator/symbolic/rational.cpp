#include "symbolic/rational.hpp"

#include "support/assert.hpp"

namespace gaussgen::symbolic {

GiNaC::ex number(const support::Rational& value) { return GiNaC::numeric(cln::cl_N(value)); }

support::Rational rational(const GiNaC::numeric& value) {
  GAUSS_ASSERT(value.is_rational(), "an inexact number: {}", value.to_double());
  return cln::the<cln::cl_RA>(value.to_cl_N());
}

}  // namespace gaussgen::symbolic
