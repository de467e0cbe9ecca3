#pragma once

#include <cln/float.h>

#include <string>

namespace gaussgen::evaluate {

/// `value` rounded to `digits` significant digits, all of them printed: "0.84147", "-1200.0", "1.0000e-12". Depends on
/// neither a locale nor CLN's printer settings. Zero is "0".
std::string to_decimal(const cln::cl_F& value, int digits);

/// The nearest double; 0 and infinity beyond its range.
double to_double(const cln::cl_F& value);

}  // namespace gaussgen::evaluate
