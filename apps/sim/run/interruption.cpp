#include "sim/run/interruption.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>

namespace gausssim {

namespace {

// The handler runs on any thread, and all of them look.
std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

thread_local TimeLimit::Clock::time_point limit = TimeLimit::Clock::time_point::max();

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

TimeLimit::TimeLimit(double seconds) : before_(limit), own_(limit) {
  constexpr double k_for_ever = 1e9;
  const std::chrono::duration<double> span(std::clamp(seconds, 0.0, k_for_ever));
  own_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(span);
  limit = std::min(before_, own_);
}

TimeLimit::~TimeLimit() { limit = before_; }

bool TimeLimit::is_over() const { return Clock::now() >= own_; }

void throw_if_ended(const TimeLimit& limit) {
  if (Interruption::is_asked_for()) throw Interrupted{};
  if (limit.is_over()) throw OutOfTime{};
}

bool ends_steps() {
  // To look at the clock takes as long as some steps do.
  constexpr unsigned k_looks_once_in = 64;
  static thread_local unsigned count = 0;
  if (asked.load(std::memory_order_relaxed)) return true;
  if (limit == TimeLimit::Clock::time_point::max() || ++count % k_looks_once_in != 0) return false;
  return TimeLimit::Clock::now() >= limit;
}

}  // namespace gausssim
