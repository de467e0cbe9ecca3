#pragma once

#include <chrono>
#include <string>

namespace gausssim {

/// A line on standard error, where that is a terminal, that follows a run; gone when it ends.
class ProgressBar {
 public:
  explicit ProgressBar(bool is_wanted);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// `share`: of the whole, from 0 to 1.
  void show(double share, const std::string& text);
  /// Of a whole that nobody knows.
  void say(const std::string& text);
  /// For a message in its place, until it is shown again.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void draw(const std::string& line);

  bool is_shown_;
  bool is_drawn_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

}  // namespace gausssim
