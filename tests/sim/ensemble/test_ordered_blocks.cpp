#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "catch_shim.hpp"
#include "sim/ensemble/ordered_blocks.hpp"

namespace {

gausssim::Blocks blocks_of(int threads, std::string& all) {
  gausssim::Blocks blocks;
  blocks.count = 200;
  blocks.threads = threads;
  blocks.make_work = [] {
    return [](long block) {
      // Earlier ones take longer.
      std::this_thread::sleep_for(std::chrono::microseconds(block % 7 == 0 ? 2000 : 10));
      return std::to_string(block) + "\n";
    };
  };
  blocks.on_text = [&](const std::string& text) { all += text; };
  blocks.ends = [] { return false; };
  blocks.on_wait = [](double) {};
  return blocks;
}

}  // namespace

TEST_CASE("texts come in the order of blocks, whoever makes them") {
  std::string expected;
  for (int i = 0; i < 200; ++i) expected += std::to_string(i) + "\n";
  for (const int threads : {1, 2, 5}) {
    std::string all;
    gausssim::run_in_order(blocks_of(threads, all));
    CHECK(all == expected);
  }
}

TEST_CASE("what a block throws ends the run and comes out of it") {
  std::string all;
  auto blocks = blocks_of(3, all);
  blocks.make_work = [] {
    return [](long block) -> std::string {
      if (block == 50) throw std::runtime_error("block 50");
      return "x";
    };
  };
  CHECK_THROWS_WITH(gausssim::run_in_order(blocks), "block 50");
  CHECK(all.size() <= 200);
}

TEST_CASE("a run that is ended has all blocks that were begun, and no gap") {
  std::string all;
  std::atomic<int> begun{0};
  auto blocks = blocks_of(3, all);
  blocks.make_work = [&] {
    return [&](long) {
      ++begun;
      return std::string("x");
    };
  };
  blocks.ends = [&] { return begun >= 20; };
  gausssim::run_in_order(blocks);
  CHECK(all.size() == static_cast<std::size_t>(begun));
  CHECK(all.size() >= 20);
  CHECK(all.size() < 30);
}
