#pragma once
// Another program, run to its end or until somebody asks for that.

#include <functional>
#include <string>
#include <vector>

namespace gausssim {

struct Finished {
  int status = -1;         ///< its exit status; -1 where it has none
  std::string said;        ///< on standard output and standard error
  bool was_ended = false;  ///< by `ends`
};

/// `words`: the path of the program and its arguments; no shell has a part in it. It is in a process group of its own, so that Ctrl-C reaches this program alone,
/// which ends it with all that it has started when `ends` says so.
Finished run_program(const std::vector<std::string>& words, const std::function<bool()>& ends);

}  // namespace gausssim
