#pragma once
// Runs that hardly go on, since steps are refused over and over.

#include "cli/messages.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/progress_bar.hpp"

namespace gausssim {

/// Says so once, while the run can still be stopped.
class RefusalWatch {
 public:
  RefusalWatch(const PreparedModel& prepared, const gaussgen::cli::MessageOptions& messages, ProgressBar& bar)
      : prepared_(prepared), messages_(messages), bar_(bar) {}

  void look(double t, long steps, long refused);

 private:
  const PreparedModel& prepared_;
  const gaussgen::cli::MessageOptions& messages_;
  ProgressBar& bar_;
  bool has_said_ = false;
};

}  // namespace gausssim
