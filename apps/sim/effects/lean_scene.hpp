#pragma once
// A scene with other effects, else as it was written.

#include <string>
#include <vector>

namespace gausssim {

/// Text of a scene of which `effects:` is another one, with all its other lines and comments; empty where its keys do not stand in lines of their own.
std::string scene_with_effects(const std::string& scene, const std::vector<std::string>& effects);

/// A scene of a model, for files in the same folder as the scene will be.
std::string scene_of_model(const std::string& name, const std::string& model, const std::vector<std::string>& effects);

}  // namespace gausssim
