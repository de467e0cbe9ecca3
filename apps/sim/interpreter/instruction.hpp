#pragma once
// What the interpreter runs: instructions over one array of scalars.

#include <cstdint>

namespace gausssim {

/// Of the array of scalars. Each function has places of its own there, since none calls itself; conditions are 0 and 1, a status is its number.
using Slot = std::uint32_t;

enum class Op : std::uint16_t {
  move,   ///< to = a
  load,   ///< to = scalar b of argument a
  store,  ///< scalar b of argument a = to
  add,
  subtract,
  multiply,
  divide,
  negate,
  negative_product,  ///< to = -(a b)
  add_product,       ///< to = to + a b, rounded twice, as all that is written as a product and a sum
  subtract_product,
  add_difference,  ///< to = to + (a - a)
  less,
  at_most,
  either,
  is_no_number,  ///< to = a is not equal to itself
  select,        ///< to = to ? a : b
  replace,       ///< to = a ? b : to
  status,        ///< to = Math<S>::status of four conditions, at a in the list of operands
  worse,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  exp,
  log,
  sinh,
  cosh,
  tanh,
  sqrt,
  pow,
  sincos,        ///< to = sin a, b = cos a
  call,          ///< to = status of call a
  newton,        ///< a step of Newton's method: at a in the list of operands
  solve,         ///< the system a of the program
  solve_each,    ///< to = status; for each of other right sides
  jump_if_zero,  ///< to instruction b, if a is 0
  give_status,   ///< the function ends with the status a
  give_nothing,
};

struct Instruction {
  Op op;
  std::uint16_t run =
      1;  ///< of the first of some with the same operation: how many; they are done without a look at what each is
  std::uint32_t to = 0, a = 0, b = 0;
};

}  // namespace gausssim
