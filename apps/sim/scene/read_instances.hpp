#pragma once

#include "model/reading.hpp"
#include "sim/scene/scene.hpp"

namespace gausssim {

/// The value at the key `instances` of `root`, beside all else that the scene says; what is wrong with it is reported, all of it.
void read_instances(const gaussgen::spec::Node& root, Scene& scene, gaussgen::model::Reading& reading);

}  // namespace gausssim
