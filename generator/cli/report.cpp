#include <iostream>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::cli {

int report(const support::Diagnostics& diagnostics, const support::Source& source) {
  std::cerr << support::render(diagnostics, source);
  if (!diagnostics.has_errors()) return k_ok;
  for (const support::Diagnostic& diagnostic : diagnostics.all()) {
    const bool is_limit = diagnostic.code == support::code::k_file_too_large.id ||
                          diagnostic.code == support::code::k_expression_limit.id;
    if (diagnostic.severity == support::Severity::error && !is_limit) return k_model_error;
  }
  return k_too_large;
}

}  // namespace gaussgen::cli
