#include "sim/interpreter/interpreter.inc"

template class gausssim::Interpreter<double>;
