#pragma once

#include "passes/program.hpp"
#include "passes/share.hpp"

namespace gaussgen::passes {

/// Puts the temporaries in order: functions of the state first, then each section with what it needs, then the rest.
/// A shared term stands right before its first use.
Program schedule(const Writing& writing, const Sharing& sharing, const Request& request);

}  // namespace gaussgen::passes
