#include "interpreter/interpreter.inc"

template class gausssim::Interpreter<double>;
