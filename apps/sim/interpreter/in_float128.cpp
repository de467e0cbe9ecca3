#include "gauss/scalar/float128.hpp"

#include "sim/interpreter/interpreter.inc"

template class gausssim::Interpreter<__float128>;
