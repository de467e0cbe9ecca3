#pragma once
// Limits that the program sets itself, so that a file made for the purpose ends with a message and not with the machine.

#include <string>
#include <vector>

#include "cli/messages.hpp"

namespace gaussgen::cli {

/// No more address space than the machine, or the container, has memory: the end is std::bad_alloc and a message. A lower
/// limit of the user stays.
void limit_memory();

/// While it lives, ten seconds of processor time, which no text of a model needs, end the program with a message and
/// k_too_large. What follows from a text, a derivation, may take its time.
class ReadingGuard {
 public:
  explicit ReadingGuard(const MessageOptions& options);
  ReadingGuard(const ReadingGuard&) = delete;
  ReadingGuard& operator=(const ReadingGuard&) = delete;
  ~ReadingGuard();
};

/// While it lives, each ten seconds of processor time are a line on standard error, where that is a terminal, which says which
/// of the `stages` is under way; and `most_seconds` of them, if not 0, end the program with a message and k_too_large.
class DerivationGuard {
 public:
  DerivationGuard(const std::vector<std::string>& stages, int most_seconds, const MessageOptions& options);
  DerivationGuard(const DerivationGuard&) = delete;
  DerivationGuard& operator=(const DerivationGuard&) = delete;
  ~DerivationGuard();

  /// The next one begins; the last has no end.
  void finish_stage();
};

}  // namespace gaussgen::cli
