#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/completion_scripts.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/option_rows.hpp"
#include "cli/usage_error.hpp"

namespace gaussgen::cli {

int completion(const Options& options) {
  if (options.word.empty()) throw UsageError("completion: a shell is needed: bash, zsh or fish");
  const std::string refusal = refusal_of_choice(options.word, shells());
  if (!refusal.empty()) throw UsageError("completion: " + refusal);
  write_standard_output(completion_script(options.word, "gauss-gen", command_rows()));
  return k_ok;
}

}  // namespace gaussgen::cli
