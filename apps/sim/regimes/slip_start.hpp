#pragma once
// Slip in two directions that begins from rest: which way, and a state from which it goes on.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gauss/event/null_space.hpp"
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
  using Direction = std::vector<S>;  ///< of length 1, in parts of moves
  using Vectors = std::vector<std::vector<S>>;

  /// Frictions whose slips depend on each other, as those of one body do.
  struct Block {
    std::string frictions;            ///< in words
    std::vector<std::size_t> guards;  ///< that tell the slips
    Vectors
        moves;  ///< changes of speeds that make slip, and leave as they are what holds: orthonormal in the metric of masses
    Vectors slips;  ///< of each guard, by each move
    Direction way;
  };

  void find_blocks(const Standing<S>& standing, const Switches& switches, const Modes& modes,
                   const std::vector<std::size_t>& beginning);
  Block block_of(const std::vector<std::size_t>& frictions, const Standing<S>& standing, const Switches& switches,
                 gauss::event::OrthonormalVectors<S> held) const;
  void leave_rest(const Block& block, const std::vector<S>& left);
  Direction moves_with(const Block& block, const std::vector<S>& slips) const;
  Numbers<S> sliding() const;
  Direction acceleration(Block& block, const Direction& way) const;
  Direction turning(Block& block, const Direction& way) const;
  std::optional<Direction> way_of(Block& block) const;
  std::optional<Direction> in_plane(Block& block) const;
  std::optional<Direction> in_space(Block& block) const;
  std::optional<Direction> nearer(Block& block, const Direction& way, const Direction& turn, S& stiffness) const;

  const Regime<S>& regime_;
  const Instant<S>& here_;
  Numbers<S> x_;
  std::vector<Block> blocks_;
  S speed_ = 0;
};

}  // namespace gausssim
