#pragma once
// Philox4x32 with 10 rounds: random bits as a function of a counter and a key, without a state.
//
// J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, Parallel random numbers: as easy as 1, 2, 3, Proc. SC11 (2011), doi:10.1145/2063384.2063405.

#include <array>
#include <cstdint>

namespace gausssim {

inline std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t k_first = 0xD2511F53, k_second = 0xCD9E8D57;
  constexpr std::uint32_t k_golden = 0x9E3779B9, k_root_3 = 0xBB67AE85;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = k_first * counter[0], b = k_second * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += k_golden;
    key[1] += k_root_3;
  }
  return counter;
}

}  // namespace gausssim
