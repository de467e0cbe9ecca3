#define GAUSS_TEST_TYPE double
#include "as_scalar.inc"
