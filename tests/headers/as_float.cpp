#define GAUSS_TEST_TYPE float
#include "as_scalar.inc"
