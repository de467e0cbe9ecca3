#pragma once
// Whether coordinates describe all motion at a position, as Euler angles do not where two of their axes are one.

#include "model_values.hpp"

namespace gaussgen {

/// False where some speeds other than zero leave every frame and body at rest: then bodies can move in ways that no speed stands for,
/// and forces along those are in no equation. At the state that is bound in `values`.
bool describes_all_motion(Mechanics& mechanics, ModelValues& values);

}  // namespace gaussgen
