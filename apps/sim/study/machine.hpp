#pragma once

#include <string>

namespace gausssim {

/// What figures of time belong to.
struct Machine {
  std::string processor, system, compiler, flags;
  int cores = 0;
};

Machine this_machine();

}  // namespace gausssim
