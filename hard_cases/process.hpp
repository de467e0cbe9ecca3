#pragma once
// Other programs: the generator and compilers, for cases that are about them.

#include <string>

namespace hard_cases {

struct Outcome {
  int exit_code = -1;  ///< of the program; -1 if it could not be run, or was ended by a signal
  std::string said;    ///< on standard output and standard error
};

/// Runs a line of the shell.
Outcome run_program(const std::string& line);

/// The line that runs a Python file of tests/ with what it reads of its environment; arguments follow.
std::string python_test(const std::string& file, const std::string& environment);

/// A number that a program said behind `name`, as in `"name": 12` or `name 12`; breaks down where there is none.
double number_behind(const std::string& text, const std::string& name);

}  // namespace hard_cases
