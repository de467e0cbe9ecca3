#pragma once
// Texts that cmake makes C++ of.

#include <string>

namespace gaussgen::cli {

/// starter.yaml, with @name@ for the name of the model.
const char* starter();

/// What `gauss-gen init` calls a model that gets no name.
inline constexpr const char* k_starter_name = "pendulum";

/// The model that `gauss-gen init` writes.
std::string starter_called(const std::string& name);

}  // namespace gaussgen::cli
