#pragma once
// Runs that hardly go on, as where a motion sticks at a force that jumps.

#include "cli/messages.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/progress_bar.hpp"

namespace gausssim {

/// While it lives, says once that a run takes steps without end, so that it can be stopped.
class StandstillWatch {
 public:
  StandstillWatch(const PreparedModel& prepared, const gaussgen::cli::MessageOptions& messages, ProgressBar& bar)
      : prepared_(prepared), messages_(messages), bar_(bar) {}

  /// Row `k` has been reached.
  void look(long k) {
    last_ = k;
    after_many_steps_.begin_again();
  }

 private:
  void look_after_many_steps();

  const PreparedModel& prepared_;
  const gaussgen::cli::MessageOptions& messages_;
  ProgressBar& bar_;
  long last_ = -1;
  bool has_said_ = false;
  AfterManySteps after_many_steps_{[this] { look_after_many_steps(); }};
};

}  // namespace gausssim
