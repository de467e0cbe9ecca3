#pragma once
// Names that emitted code keeps for itself. Others that it uses get an underscore when they are emitted.

#include <string_view>

namespace gaussgen::model {

/// Macros of the emitted header and of those who include it begin with GAUSS_: no scope keeps them apart from names.
bool is_emitted_macro(std::string_view name);

/// What the emitted header declares in namespace gauss, where the namespace of a model lies, too.
bool is_taken_in_gauss(std::string_view name);

}  // namespace gaussgen::model
