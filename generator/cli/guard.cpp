#include "cli/guard.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

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

namespace {

constexpr int k_seconds_between_lines = 10;

/// What the handler says, made before: inside a signal nothing may be allocated.
struct StageTexts {
  std::string under_way;
  std::string too_long;
};

std::vector<StageTexts> texts_of_stages;
volatile std::sig_atomic_t stage = 0;
volatile std::sig_atomic_t seconds = 0;
volatile std::sig_atomic_t seconds_allowed = 0;
volatile std::sig_atomic_t is_watched = 0;

void write_all(const char* text, std::size_t size) {
  if (write(STDERR_FILENO, text, size) < 0) _exit(k_file_error);
}

void say_what_is_under_way(const StageTexts& texts) {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<int>(seconds));
  write_all(texts.under_way.data(), texts.under_way.size());
  write_all(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
  write_all(" s\n", 3);
}

extern "C" void count_second(int) {
  const int error = errno;
  const StageTexts& texts = texts_of_stages[static_cast<std::size_t>(stage)];
  seconds = seconds + 1;
  if (seconds_allowed > 0 && seconds >= seconds_allowed) {
    write_all(texts.too_long.data(), texts.too_long.size());
    _exit(k_too_large);
  }
  if (is_watched != 0 && seconds % k_seconds_between_lines == 0) say_what_is_under_way(texts);
  errno = error;
}

StageTexts texts_of(const std::string& name, int most_seconds, MessageFormat format) {
  const std::string what = fmt::format(
      "the model is too large: more than {} s in the stage '{}'; --max-seconds allows more", most_seconds, name);
  return {fmt::format("gauss-gen: the stage '{}' is under way after ", name),
          format == MessageFormat::json ? fmt::format("{{\"severity\":\"error\",\"message\":\"{}\"}}\n", what)
                                        : fmt::format("gauss-gen: {}\n", what)};
}

/// Of a signal other than that of the reading.
void count_seconds(int interval) {
  itimerval timer{};
  timer.it_value.tv_sec = interval;
  timer.it_interval.tv_sec = interval;
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

}  // namespace

DerivationGuard::DerivationGuard(const std::vector<std::string>& stages, int most_seconds,
                                 const MessageOptions& options) {
  texts_of_stages.clear();
  for (const std::string& name : stages) texts_of_stages.push_back(texts_of(name, most_seconds, options.format));
  stage = 0;
  seconds = 0;
  seconds_allowed = most_seconds;
  is_watched = options.format == MessageFormat::text && isatty(STDERR_FILENO) != 0 ? 1 : 0;
  struct sigaction action {};
  action.sa_handler = count_second;
  action.sa_flags = SA_RESTART;
  sigaction(SIGVTALRM, &action, nullptr);
  count_seconds(1);
}

DerivationGuard::~DerivationGuard() { count_seconds(0); }

void DerivationGuard::finish_stage() {
  const int last = static_cast<int>(texts_of_stages.size()) - 1;
  stage = std::min<int>(stage + 1, last);
}

}  // namespace gaussgen::cli
