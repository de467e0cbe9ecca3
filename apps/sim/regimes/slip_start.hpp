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
/// it turns there faster the smaller it is.)
template <class S>
class SlipStart {
 public:
  /// `beginning`: frictions, by their places, that slide in two directions in `regime` and have no slip yet.
  SlipStart(const Regime<S>& regime, const Switches& switches, const Modes& modes, const Standing<S>& standing,
            std::vector<std::size_t> beginning, const Instant<S>& here, const Numbers<S>& x);

  /// With a slip of 1e-12 of the largest speed, or of the slip that accelerations make in a second. Nothing, and why: friction would turn it back.
  std::optional<Numbers<S>> state(std::string& why);

 private:
  struct Beginning {
    std::string friction;
    std::vector<std::size_t> guards;   ///< that tell its slip
    std::vector<S> along[2], against;  ///< changes of speeds: by a slip of 1 along each direction; that of what is left
    S angle = 0;
  };

  void find_changes(const Standing<S>& standing, const Switches& switches, const Modes& modes,
                    const std::vector<std::size_t>& beginning);
  Numbers<S> with_slips() const;
  std::vector<S> acceleration(const Beginning& of) const;
  S turning(const Beginning& of) const;
  bool turn(Beginning& one);

  const Regime<S>& regime_;
  const Instant<S>& here_;
  Numbers<S> x_;
  std::vector<Beginning> beginnings_;
  S speed_ = 0;
};

}  // namespace gausssim
