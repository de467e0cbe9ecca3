#pragma once
// What the interpreter says of trees that it cannot run.

#include <stdexcept>
#include <string>

namespace gausssim {

/// While a tree is compiled to instructions, never later: a construct of some function has no instructions. A number that is wrong is worse than none.
class NotRunnable : public std::runtime_error {
 public:
  NotRunnable(const std::string& function, const std::string& what)
      : std::runtime_error("the function '" + function + "' cannot be interpreted: " + what) {}
};

}  // namespace gausssim
