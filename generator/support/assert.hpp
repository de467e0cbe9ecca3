#pragma once
// Checks of our own invariants. A failure is a bug in the generator, never a user's mistake.

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace gaussgen::support {

/// Thrown by GAUSS_ASSERT; the command line turns it into exit code 70.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

template <class... Args>
[[noreturn]] void fail(const char* file, int line, const char* condition, fmt::format_string<Args...> format,
                       Args&&... args) {
  throw InternalError(
      fmt::format("{}:{}: {}: {}", file, line, condition, fmt::format(format, std::forward<Args>(args)...)));
}

}  // namespace gaussgen::support

/// GAUSS_ASSERT(a < b, "a={} b={}", a, b): the message prints the operands.
#define GAUSS_ASSERT(condition, ...)                                                          \
  do {                                                                                        \
    if (!(condition)) ::gaussgen::support::fail(__FILE__, __LINE__, #condition, __VA_ARGS__); \
  } while (false)
