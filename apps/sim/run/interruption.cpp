#include "sim/run/interruption.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstring>

#include "cli/exit_codes.hpp"

namespace gausssim {

namespace {

// The handler runs on any thread, and all of them look.
std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

thread_local TimeLimit::Clock::time_point deadline = TimeLimit::Clock::time_point::max();

thread_local AfterManySteps* watch = nullptr;

const char* const k_text = "interrupted; nothing is written\n";
const char* const k_json = "{\"severity\":\"note\",\"message\":\"interrupted; nothing is written\"}\n";

std::atomic<const char*> last_words{nullptr};  ///< null: an interruption is only asked for
static_assert(std::atomic<const char*>::is_always_lock_free);

/// Inside a signal only such calls are allowed.
void note(int signal) {
  if (const char* const words = last_words) {
    const ssize_t written = ::write(STDERR_FILENO, words, std::strlen(words));
    ::_exit(written < 0 ? gaussgen::cli::k_file_error : gaussgen::cli::k_interrupted);
  }
  asked = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  asked = false;
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
  // Of a terminal that was closed; not for who asked by nohup to go on then.
  if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (std::signal(SIGHUP, SIG_DFL) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

bool Interruption::is_asked_for() { return asked; }

EndsAtOnce::EndsAtOnce(const gaussgen::cli::MessageOptions& messages) {
  last_words = messages.format == gaussgen::cli::MessageFormat::json ? k_json : k_text;
}

EndsAtOnce::~EndsAtOnce() { last_words = nullptr; }

TimeLimit::TimeLimit(double seconds) : before_(deadline), own_(deadline) {
  constexpr double k_for_ever = 1e9;
  const std::chrono::duration<double> span(std::clamp(seconds, 0.0, k_for_ever));
  own_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(span);
  deadline = std::min(before_, own_);
}

TimeLimit::~TimeLimit() { deadline = before_; }

bool TimeLimit::is_over() const { return Clock::now() >= std::min(before_, own_); }

AfterManySteps::AfterManySteps(std::function<void()> call) : call_(std::move(call)) { watch = this; }

AfterManySteps::~AfterManySteps() { watch = nullptr; }

void throw_if_ended(const TimeLimit& whole) {
  if (Interruption::is_asked_for()) throw Interrupted{};
  if (whole.is_over()) throw OutOfTime{};
}

void throw_if_ended() {
  if (Interruption::is_asked_for()) throw Interrupted{};
  if (ends_now()) throw OutOfTime{};
}

bool ends_now() { return asked || TimeLimit::Clock::now() >= deadline; }

bool ends_steps() {
  constexpr unsigned k_looks_once_in = 64;
  static thread_local unsigned count = 0;
  if (asked.load(std::memory_order_relaxed)) return true;
  if (watch != nullptr && ++watch->taken_ % AfterManySteps::k_many == 0) watch->call_();
  if (deadline == TimeLimit::Clock::time_point::max() || ++count % k_looks_once_in != 0) return false;
  return TimeLimit::Clock::now() >= deadline;
}

}  // namespace gausssim
