// Numbers in place of parameters, and the paper's route term by term, change nothing but rounding.
//
// The bar: 1e-13 (size + sensitivity) as in test_scalars.cpp. The paper's route eliminates dependent speeds by a fixed
// partition even where that is not safe everywhere, and loses digits close to where its partition fails: eight states
// out of ten must keep the bar, and none may be off by more than 1e-6.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch_shim.hpp"
#include "samples.hpp"
#include "variants.hpp"

namespace {

using headertest::Computed;
using headertest::k_parts;
using headertest::Wide;

constexpr std::size_t k_states = 50;

/// Relative to size + sensitivity, of each state, the smallest first.
std::vector<double> differences(const Computed& plain, const Computed& other,
                                const headertest::Sensitivity& sensitivity) {
  const auto samples = headertest::random_samples(plain, k_states, false);
  REQUIRE(samples.size() == k_states);
  const auto expected = plain.answers(samples);
  const auto answers = other.answers(samples);
  std::vector<double> result;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const auto sensitivities = sensitivity(samples[s]);
    Wide worst = 0;
    for (std::size_t p = 0; p < k_parts.size(); ++p) {
      REQUIRE(answers[s].parts[p].size() == expected[s].parts[p].size());
      const Wide scale = headertest::largest(expected[s].parts[p]) + sensitivities[p];
      if (scale == 0) continue;
      const Wide now = headertest::largest_difference(answers[s].parts[p], expected[s].parts[p]) / scale;
      if (!(now <= worst)) worst = now;
    }
    // After four steps of Newton's method from anywhere, a position is at the bar now and then, and rounding decides.
    const bool may_differ = plain.name == "double_pendulum_planar";
    CHECK((may_differ || answers[s].statuses == expected[s].statuses));
    result.push_back(isfinite(worst) ? static_cast<double>(worst) : HUGE_VAL);
  }
  std::sort(result.begin(), result.end());
  return result;
}

void agree(const char* variant, const std::vector<Computed>& others, double bar_of_most, double bar_of_all) {
  const auto plain = headertest::plain_models<double>();
  const auto sensitivities = headertest::sensitivities();
  REQUIRE(others.size() == plain.size());
  for (std::size_t m = 0; m < plain.size(); ++m) {
    INFO(variant << ", " << plain[m].name);
    REQUIRE(plain[m].name == others[m].name);
    const std::vector<double> found = differences(plain[m], others[m], sensitivities.at(m));
    const double most = found[found.size() * 8 / 10];
    std::printf("%-8s %-32s %8.3g in eight of ten states, %8.3g in all\n", variant, plain[m].name.c_str(), most,
                found.back());
    CHECK(most <= bar_of_most);
    CHECK(found.back() <= bar_of_all);
  }
}

}  // namespace

TEST_CASE("--fold gives the results of the parameters' default values") {
  // In all: 1500 eps, as every scalar type has (test_scalars.cpp), for the pivots of Euler angles.
  agree("--fold", headertest::folded_models(), 1e-13, 3.4e-13);
}

TEST_CASE("--route=paper gives the results of the emitted route") {
  agree("paper", headertest::paper_models(), 1e-13, 1e-6);
}
