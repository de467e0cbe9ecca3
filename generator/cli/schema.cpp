#include "cli/commands.hpp"

namespace gaussgen::cli {

int schema() { return 0; }

}  // namespace gaussgen::cli
