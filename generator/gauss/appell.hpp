#pragma once

#include "gauss/body_motion.hpp"

namespace gaussgen::gauss {

/// Gibbs–Appell function S = Σ ½ m r̈² + ½ ω̇·Iω̇ + ω̇·(ω × Iω) (2.2)-(2.4), theory section 6, over ÿ, ẏ, y: from the
/// accelerations of points and bodies themselves, without a metric. Terms free of accelerations are whatever they are.
ex gibbs_appell(const std::vector<BodyMotion>& bodies, const Chart& chart);

}  // namespace gaussgen::gauss
