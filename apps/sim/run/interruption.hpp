#pragma once

namespace gausssim {

/// Thrown where there is nothing to be kept.
struct Interrupted {};

/// While it lives, the first Ctrl-C (SIGINT, SIGTERM) only asks for an end, a second one ends the program.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  static bool is_asked_for();
};

}  // namespace gausssim
