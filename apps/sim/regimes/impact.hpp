#pragma once
// Speeds that jump where gaps close (docs/regimes.md, what an impact does).

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/regimes/instant.hpp"
#include "sim/regimes/regime_pool.hpp"
#include "sim/regimes/standing.hpp"

namespace gausssim {

/// Of one contact.
struct Hit {
  std::string contact;
  double impulse = 0;
};

/// Impulses on all that touches; contacts whose impacts would follow each other without end do not rebound. `before`: the regime until then, which tells what closes them again. `here.x` becomes the
/// state after them. Nothing, and why: none satisfy the law.
template <class S>
std::optional<std::vector<Hit>> hit(const Regime<S>& ground, const Regime<S>& before, const Standing<S>& standing,
                                    const Switches& switches, const std::set<std::string>& closing, Instant<S>& here,
                                    std::string& why);

}  // namespace gausssim
