#pragma once
// How long something takes.

#include <chrono>
#include <ctime>

namespace gausssim {

struct Seconds {
  double wall = 0, cpu = 0;  ///< cpu: of this thread, since other runs may be made beside it

  Seconds& operator+=(const Seconds& more) {
    wall += more.wall;
    cpu += more.cpu;
    return *this;
  }
};

class Stopwatch {
 public:
  Seconds seconds() const {
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(), cpu_now() - cpu_};
  }

 private:
  static double cpu_now() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double cpu_ = cpu_now();
};

}  // namespace gausssim
