#pragma once
// Slip in two directions that begins from rest: which way, and a state from which it goes on.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/regimes/instant.hpp"
#include "sim/regimes/standing.hpp"

namespace gausssim {

/// Friction acts against the slip, and the slip grows the way in which all forces, friction among them, accelerate it: that is the one direction in which it can begin. (Seen from any other one,
/// it turns there faster the smaller it is.) Several slips of one body are one motion of it, in whose directions one is looked for.
template <class S>
class SlipStart {
 public:
  /// `beginning`: frictions, by their places, that slide in two directions in `regime` and have no slip yet.
  SlipStart(const Regime<S>& regime, const Switches& switches, const Modes& modes, const Standing<S>& standing,
            std::vector<std::size_t> beginning, const Instant<S>& here, const Numbers<S>& x);

  /// With a slip of 1e-12 of the largest speed, or of the slip that accelerations make in a second. Nothing, and why: friction would turn it back.
  std::optional<Numbers<S>> state(std::string& why);

 private:
  using Direction = std::vector<S>;  ///< of length 1, in parts of moves_

  void find_moves(const Standing<S>& standing, const Switches& switches, const Modes& modes,
                  const std::vector<std::size_t>& beginning);
  void leave_rest(const Standing<S>& standing, const std::vector<std::size_t>& beginning);
  Direction moves_with(const std::vector<S>& slips) const;
  Numbers<S> sliding(const Direction& way) const;
  Direction acceleration(const Direction& way) const;
  Direction turning(const Direction& way) const;
  std::optional<Direction> in_line() const;
  std::optional<Direction> in_plane() const;
  std::optional<Direction> in_space() const;
  std::optional<Direction> nearer(const Direction& way, const Direction& turn, S& stiffness) const;

  const Regime<S>& regime_;
  const Instant<S>& here_;
  Numbers<S> x_;
  std::string frictions_;            ///< in words
  std::vector<std::size_t> guards_;  ///< that tell the slips
  std::vector<std::vector<S>>
      moves_;  ///< changes of speeds that make slip, and leave as they are what holds: orthonormal in the metric of masses
  std::vector<std::vector<S>> slips_;  ///< of each guard, by each move
  S speed_ = 0;
};

}  // namespace gausssim
