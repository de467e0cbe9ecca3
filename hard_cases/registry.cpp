#include "registry.hpp"

namespace hard_cases {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"H01", "Euler angles at their pole: a rolling ball", euler_pole},
      {"H02", "No choice of dependent velocities is good everywhere: a knife edge", knife_edge},
      {"H03", "Constraints that follow from each other: said twice, a door on two hinges, a table on four legs",
       redundant},
      {"H04", "Constraints that contradict each other: two bars of other lengths", contradictory},
      {"H05", "Gradients of constraints that are nearly parallel", near_parallel},
      {"H06", "A mass matrix without inverse: an angle, a rod and a hub without inertia", singular_mass},
      {"H07", "A chain with a heavy or a light end", mass_ratio},
      {"H08", "Loops through their change points: a parallelogram that lies flat, a slider-crank with equal bars",
       flat_parallelogram},
      {"H09", "Loops in space with more equations than say something: Bennett, Bricard, Sarrus", over_constrained},
      {"H10", "A fast spin", fast_spin},
      {"H11", "An angle grows without end", angle_growth},
      {"H12", "A pendulum swings for very long", long_run},
      {"H13", "Constraints drift: a pendulum in Cartesian coordinates", constraint_drift},
      {"H14", "Time adds up", accumulated_time},
#ifdef GAUSS_HAS_SUNDIALS
      {"H15", "Stiff: fast rates beside a slow motion", stiff},
#endif
#ifdef GAUSS_HAS_SIM
      {"H16", "Friction that holds: a block on an incline", stick},
      {"H17", "Friction that leaves no motion: Painleve's rod", painleve},
      {"H18", "Infinitely many impacts in a finite time: a ball that bounces to rest", zeno},
      {"H19", "Impacts at one instant: a row of balls", cradle},
#endif
      {"H20", "A pivot that shakes by a law in time", moving_pivot},
      {"H21", "Constraints of velocities that are not linear: a turntable, Appell and Hamel's particle", affine},
      {"H22", "Sums that lose their digits as they are written", cancellation},
      {"H23", "Rounding in emitted expressions: chains", rounding},
      {"H24", "Single precision", single_precision},
      {"H25", "The same bits from every compiler", same_bits},
      {"H26", "Denormal numbers", denormals},
      {"H27", "Expressions that swell: a chain in space", swell},
      {"H28", "Out and back in time", time_reversal},
      {"H29", "Degenerate input", degenerate},
      {"H30", "A start that violates the constraints", ill_start},
      {"H31", "Units in which numbers are very large or very small", units},
  };
  return all;
}

}  // namespace hard_cases
