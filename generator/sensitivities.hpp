#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// `--sensitivities`: these parameters in place of those that the model names.
void choose_sensitivities(const std::vector<std::string>& names, model::Model& model,
                          support::Diagnostics& diagnostics);

}  // namespace gaussgen
