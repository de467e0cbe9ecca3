#pragma once

#include "cli/messages.hpp"

namespace CLI {
class App;
}

namespace gausssim {

/// --diagnostics and --color, as gauss-gen has them.
void add_messages(CLI::App& command, gaussgen::cli::MessageOptions& options);

}  // namespace gausssim
