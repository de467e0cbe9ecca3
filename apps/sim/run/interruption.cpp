#include "sim/run/interruption.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>

#include "cli/exit_codes.hpp"

namespace gausssim {

namespace {

// The handler runs on any thread, and all of them look.
std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

thread_local TimeLimit* innermost = nullptr;
thread_local TimeLimit::Clock::time_point deadline = TimeLimit::Clock::time_point::max();  ///< that of the innermost

thread_local AfterManySteps* watch = nullptr;

const char* const k_text = "interrupted; nothing is written\n";
const char* const k_json = "{\"severity\":\"note\",\"message\":\"interrupted; nothing is written\"}\n";

std::atomic<const char*> last_words{nullptr};  ///< null: an interruption is only asked for
static_assert(std::atomic<const char*>::is_always_lock_free);

/// When an interruption was asked for; 0: it was not.
std::atomic<std::int64_t> asked_at{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t milliseconds_now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000 + 1;
}

/// Who asks for an end twice wants it at once; but one wish may come as two signals, to the process and to its group.
constexpr std::int64_t k_same_wish = 500;  ///< ms

/// Inside a signal only such calls are allowed.
void note(int signal) {
  if (const char* const words = last_words) {
    const ssize_t written = ::write(STDERR_FILENO, words, std::strlen(words));
    ::_exit(written < 0 ? gaussgen::cli::k_file_error : gaussgen::cli::k_interrupted);
  }
  asked = true;
  const std::int64_t now = milliseconds_now();
  std::int64_t first = 0;
  if (asked_at.compare_exchange_strong(first, now) || now - first < k_same_wish) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

Interruption::Interruption() {
  asked = false;
  asked_at = 0;
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

TimeLimit::TimeLimit(double seconds, Of of) : outer_(innermost), of_(of) {
  constexpr double k_for_ever = 1e9;
  const std::chrono::duration<double> span(std::clamp(seconds, 0.0, k_for_ever));
  own_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(span);
  innermost = this;
  deadline = end();
}

TimeLimit::~TimeLimit() {
  innermost = outer_;
  deadline = outer_ == nullptr ? Clock::time_point::max() : outer_->end();
}

TimeLimit::Clock::time_point TimeLimit::end() const { return outer_ == nullptr ? own_ : std::min(own_, outer_->end()); }

bool TimeLimit::is_over() const { return Clock::now() >= end(); }

LimitsOfRunsWait::LimitsOfRunsWait() : began_(TimeLimit::Clock::now()) {
  deadline = TimeLimit::Clock::time_point::max();
  for (const TimeLimit* one = innermost; one != nullptr; one = one->outer_)
    if (one->of_ == TimeLimit::Of::all) deadline = std::min(deadline, one->own_);
}

LimitsOfRunsWait::~LimitsOfRunsWait() {
  const auto taken = TimeLimit::Clock::now() - began_;
  for (TimeLimit* one = innermost; one != nullptr; one = one->outer_)
    if (one->of_ == TimeLimit::Of::run) one->own_ += taken;
  if (innermost != nullptr) deadline = innermost->end();
}

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
