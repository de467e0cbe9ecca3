#include "gauss/scalar/float128.hpp"

#define GAUSS_TEST_TYPE __float128
#include "as_scalar.inc"
