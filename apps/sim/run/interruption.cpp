#include "sim/run/interruption.hpp"

#include <atomic>
#include <csignal>

namespace gausssim {

namespace {

// The handler runs on any thread, and all of them look.
std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void note(int signal) {
  asked = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  asked = false;
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::is_asked_for() { return asked; }

}  // namespace gausssim
