#pragma once
// The three slips of the paper that change physics, each with the figure that shows it (docs/theory.md, section 9).

#include "closed_form.hpp"

namespace sphere {

/// (3.6): c is printed without its minus sign. Largest difference of the accelerations from those of the multiplier form
/// (3.4), over both sets of units, at the state of docs/theory.md, section 9.
struct EliminationSlip {
  double printed;
  double corrected;
};
EliminationSlip elimination_sign();

/// Second rolling constraint: a minus is printed before its last term. For a harmonic height zeta'' + Omega^2 zeta is constant.
struct RollingSlip {
  struct Variant {
    double contact_speed_at_start;  ///< m/s
    double contact_speed;           ///< m/s, largest over the window
    double change;                  ///< of zeta'' + Omega^2 zeta over the window, m/s^2
    double end;                     ///< s, how far the simulation came
  };
  static constexpr double k_window = 0.5;     // s, before the printed motion meets the Euler singularity
  static constexpr double k_duration = 10.0;  // s
  Variant printed;
  Variant corrected;
};
RollingSlip rolling_along();

/// End of the example: R_1 = -m R chi'^2 is printed.
struct ReactionSlip {
  double printed;    ///< N
  double corrected;  ///< N
  double emitted;    ///< N, from the generated code
};
ReactionSlip normal_reaction();

}  // namespace sphere
