#pragma once

#include <string>

#include "timing.hpp"

namespace bench {

/// gauss-gen on models/<model>.yaml from start to exit, in seconds.
Times generation(const std::string& model);

}  // namespace bench
