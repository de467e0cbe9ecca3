#pragma once
// Exact rationals. A number of the model stays one until it meets the scalar type of a run.

#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real_class.h>

#include <cstddef>
#include <string>

namespace gaussgen::support {

using Integer = cln::cl_I;
using Rational = cln::cl_RA;

bool is_integer(const Rational& value);

/// The value as int; asserts that it is an integer that fits.
int to_int(const Rational& value);

/// The nearest double; 0 and infinity beyond its range. Of any real number of CLN.
double to_double(const cln::cl_R& value);

/// "3", "-2/5": independent of locale and of CLN's printer settings.
std::string to_text(const Rational& value);

/// Depends on the value only, so it is the same in every process.
std::size_t hash(const Rational& value);

}  // namespace gaussgen::support
