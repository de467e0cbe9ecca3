#pragma once
// Numbers cross between our rationals and GiNaC without rounding.

#include <ginac/ginac.h>

#include "support/rational.hpp"

namespace gaussgen::symbolic {

GiNaC::ex number(const support::Rational& value);

/// Asserts that the number is rational; nothing on the paper's route makes an inexact one.
support::Rational rational(const GiNaC::numeric& value);

}  // namespace gaussgen::symbolic
