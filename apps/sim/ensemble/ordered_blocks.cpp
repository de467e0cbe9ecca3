#include "sim/ensemble/ordered_blocks.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace gausssim {

namespace {

/// Texts wait for those before them; no thread runs further ahead than this many blocks for each.
constexpr long k_ahead = 16;
constexpr std::chrono::milliseconds k_pause(50);

class Pool {
 public:
  explicit Pool(const Blocks& blocks) : blocks_(blocks), running_(blocks.threads) {}

  void run() {
    std::vector<BlockWork> works;
    works.reserve(static_cast<std::size_t>(blocks_.threads));
    for (int i = 0; i < blocks_.threads; ++i) works.push_back(blocks_.make_work());
    std::vector<std::thread> threads;
    threads.reserve(works.size());
    for (const BlockWork& work : works) threads.emplace_back([this, &work] { take_blocks(work); });
    watch();
    for (std::thread& thread : threads) thread.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void watch() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (running_ > 0) {
      changed_.wait_for(lock, k_pause, [&] { return running_ == 0; });
      const double share = static_cast<double>(taken_) / static_cast<double>(blocks_.count);
      lock.unlock();
      blocks_.on_wait(share);
      lock.lock();
    }
  }

  void take_blocks(const BlockWork& work) {
    try {
      for (long block = begin(); block < blocks_.count; block = begin()) finish(block, work(block));
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    --running_;
    changed_.notify_all();
  }

  /// The next block, or `count` where there is none.
  long begin() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || next_ < taken_ + k_ahead * blocks_.threads; });
    return failure_ || blocks_.ends() || next_ >= blocks_.count ? blocks_.count : next_++;
  }

  void finish(long block, std::string text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    done_.emplace(block, std::move(text));
    for (auto first = done_.begin(); first != done_.end() && first->first == taken_; first = done_.begin()) {
      blocks_.on_text(first->second);
      done_.erase(first);
      ++taken_;
    }
    changed_.notify_all();
  }

  const Blocks& blocks_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<long, std::string> done_;  ///< not taken yet
  long next_ = 0, taken_ = 0;
  int running_;
  std::exception_ptr failure_;
};

}  // namespace

void run_in_order(const Blocks& blocks) { Pool(blocks).run(); }

}  // namespace gausssim
