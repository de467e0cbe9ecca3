#pragma once
// The models that every property is tested on: all below models/, as CMake found them.

#include <string>
#include <vector>

namespace agreement {

/// Below models/, without .yaml.
inline const std::vector<std::string>& model_files() {
  static const std::vector<std::string> k_files{
#include "model_files.inc"
  };
  return k_files;
}

}  // namespace agreement
