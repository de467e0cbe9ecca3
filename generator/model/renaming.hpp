#pragma once
// Names of a submodel, as the model around it calls them. Private to the folder.

#include "spec/node.hpp"

namespace gaussgen::model {

/// Puts `prefix` in front of every name that the sections of a model file declare or mention. Names that mean the same in every
/// model (functions, t, pi, space) stay.
void prefix_names(spec::Node& root, const std::string& prefix);

}  // namespace gaussgen::model
