#pragma once

#include <string>

#include "emit/plan.hpp"

namespace gaussgen::emit {

/// The text on top of the header: what it is, where it comes from, what it costs. No date, path or host.
std::string provenance_text(const Plan& plan);

}  // namespace gaussgen::emit
