#pragma once
// Blocks of work on several threads, whose results are taken in order.

#include <functional>
#include <string>

namespace gausssim {

/// What a thread does: the text of a block. Each thread has one of its own.
using BlockWork = std::function<std::string(long block)>;

struct Blocks {
  long count = 0;
  int threads = 1;
  std::function<BlockWork()> make_work;             ///< called before threads begin, once for each
  std::function<void(const std::string&)> on_text;  ///< in the order of blocks, one at a time
  std::function<bool()> ends;                       ///< no block is begun any more
  std::function<void(double share)> on_wait;        ///< by the caller's thread, now and then
};

/// Throws what a block threw, when all threads have ended.
void run_in_order(const Blocks& blocks);

}  // namespace gausssim
