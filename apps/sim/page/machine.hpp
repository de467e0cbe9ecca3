#pragma once

#include <string>

namespace gausssim {

/// What figures of time belong to.
struct Computer {
  std::string processor, system, compiler, flags;
  int cores = 0;
};

Computer this_machine();

}  // namespace gausssim
