#pragma once
// One instance of a scene as an ordinary scene.

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"

namespace gausssim {

/// Null: the scene has none of this name.
const Instance* find_instance(const Scene& scene, const std::string& name);

std::vector<std::string> instance_names(const Scene& scene);

/// The scene that says for itself what it says for `one`, which is of another scene, or a copy: it has no instances then.
void take_instance(const Instance& one, Scene& scene);

}  // namespace gausssim
