#define GAUSS_TEST_TYPE long double
#include "as_scalar.inc"
