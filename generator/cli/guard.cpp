#include "cli/guard.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>

#include "cli/exit_codes.hpp"

namespace gaussgen::cli {

namespace {

constexpr int k_seconds_to_read = 10;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool k_is_sanitized = true;  // the shadow memory takes terabytes of address space
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool k_is_sanitized = true;
#else
constexpr bool k_is_sanitized = false;
#endif
#else
constexpr bool k_is_sanitized = false;
#endif

/// Of the machine, or of the container if that has less.
rlim_t memory() {
  const auto pages = sysconf(_SC_PHYS_PAGES);
  const auto page = sysconf(_SC_PAGESIZE);
  rlim_t bytes = pages > 0 && page > 0 ? static_cast<rlim_t>(pages) * static_cast<rlim_t>(page) : RLIM_INFINITY;
  rlim_t of_container = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> of_container) bytes = std::min(bytes, of_container);
  return bytes;
}

const char* const k_text =
    "gauss-gen: too large: the text of the model takes more than 10 seconds to read; split it, or shorten its "
    "expressions\n";
const char* const k_json =
    "{\"severity\":\"error\",\"message\":\"too large: the text of the model takes more than 10 seconds to read; split "
    "it, or shorten its expressions\"}\n";

const char* message = k_text;

/// Inside a signal only such calls are allowed.
extern "C" void stop_reading(int) {
  const ssize_t written = write(STDERR_FILENO, message, std::strlen(message));
  _exit(written < 0 ? k_file_error : k_too_large);
}

void set_timer(int seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

void limit_memory() {
  rlimit limit{};
  if (k_is_sanitized || getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, memory());
  setrlimit(RLIMIT_AS, &limit);
}

ReadingGuard::ReadingGuard(const MessageOptions& options) {
  message = options.format == MessageFormat::json ? k_json : k_text;
  struct sigaction action {};
  action.sa_handler = stop_reading;
  sigaction(SIGPROF, &action, nullptr);
  set_timer(k_seconds_to_read);
}

ReadingGuard::~ReadingGuard() { set_timer(0); }

}  // namespace gaussgen::cli
