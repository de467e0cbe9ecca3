#pragma once

#include "gauss/integrate/step_result.hpp"
#include "sim/drive/integrator.hpp"

namespace gausssim {

/// What a start misses the constraints by is no error of a step. Where it cannot be mended, the first step will tell.
template <class S>
void project_start(const MotionModel<S>& model, const S& t, typename MotionModel<S>::State& start,
                   Progress<S>& progress) {
  typename MotionModel<S>::State moved = start;
  if (!gauss::integrate::is_motion_known(model.projection(t, moved))) return;
  for (std::size_t i = 0; i < start.values.size(); ++i) {
    const S move = gauss::integrate::magnitude(moved.values[i] - start.values[i]);
    if (!(move > progress.start_moved)) continue;
    progress.start_moved = move;
    progress.start_component = i;
  }
  start = moved;
}

}  // namespace gausssim
