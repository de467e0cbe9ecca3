#pragma once

#include "model/reading.hpp"
#include "sim/scene/ensemble.hpp"

namespace gausssim {

/// The value at the key `ensemble` of `scene`; what is wrong with it is reported, all of it.
Ensemble read_ensemble(const gaussgen::spec::Node& node, const gaussgen::spec::Node& scene,
                       gaussgen::model::Reading& reading);

}  // namespace gausssim
