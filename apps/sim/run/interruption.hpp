#pragma once
// What ends a run before its end: Ctrl-C, or a limit of time.

#include <chrono>
#include <functional>

#include "cli/messages.hpp"

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

/// While it lives within an Interruption, Ctrl-C ends the program with a remark: for what does not look, and has nothing to keep.
class EndsAtOnce {
 public:
  explicit EndsAtOnce(const gaussgen::cli::MessageOptions& messages);
  EndsAtOnce(const EndsAtOnce&) = delete;
  EndsAtOnce& operator=(const EndsAtOnce&) = delete;
  ~EndsAtOnce();
};

/// While it lives, runs and compilations of its thread end after so many seconds, or with the limit around it if that is earlier.
class TimeLimit {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Of { run, all };  ///< all: of everything that is done meanwhile, not only of runs

  explicit TimeLimit(double seconds, Of of = Of::run);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
  ~TimeLimit();

  bool is_over() const;

 private:
  friend class LimitsOfRunsWait;

  Clock::time_point end() const;

  TimeLimit* outer_;
  Of of_;
  Clock::time_point own_;
};

/// While it lives, limits of runs of its thread do not count: what is done once for all of them, as to derive and compile, is no time of one.
class LimitsOfRunsWait {
 public:
  LimitsOfRunsWait();
  LimitsOfRunsWait(const LimitsOfRunsWait&) = delete;
  LimitsOfRunsWait& operator=(const LimitsOfRunsWait&) = delete;
  ~LimitsOfRunsWait();

 private:
  TimeLimit::Clock::time_point began_;
};

/// While it lives, calls what it is given after each so many steps of runs of its thread.
class AfterManySteps {
 public:
  static constexpr long k_many = 200'000;

  explicit AfterManySteps(std::function<void()> call);
  AfterManySteps(const AfterManySteps&) = delete;
  AfterManySteps& operator=(const AfterManySteps&) = delete;
  ~AfterManySteps();

  void begin_again() { taken_ = 0; }

 private:
  friend bool ends_steps();

  std::function<void()> call_;
  long taken_ = 0;
};

/// Thrown where a limit is over and nothing is to be kept.
struct OutOfTime {};

/// After a run that may have ended before its end: Interrupted or OutOfTime.
void throw_if_ended(const TimeLimit& whole);

/// After what `ends_now` has ended: likewise.
void throw_if_ended();

/// Whether an interruption is asked for, or a limit of time of this thread is over.
bool ends_now();

/// The same for Settings::ends of integrators, where to look at the clock takes as long as some steps do.
bool ends_steps();

}  // namespace gausssim
