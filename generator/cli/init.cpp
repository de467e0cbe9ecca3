// A model to begin with.

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/replacement.hpp"
#include "cli/texts.hpp"
#include "cli/usage_error.hpp"
#include "model/build.hpp"
#include "support/characters.hpp"

namespace gaussgen::cli {

namespace {

constexpr std::string_view k_ending = ".yaml";

std::string without_ending(const std::string& name) {
  const bool has_ending =
      name.size() > k_ending.size() && name.compare(name.size() - k_ending.size(), k_ending.size(), k_ending) == 0;
  return has_ending ? name.substr(0, name.size() - k_ending.size()) : name;
}

/// What the model would say of it, and it goes into a text that has a syntax.
void check_name(const std::string& name) {
  const bool is_word = std::all_of(name.begin(), name.end(), support::is_name_character);
  if (name.empty() || !is_word) {
    throw UsageError("init: '" + name +
                     "' is not a name for a model: write letters, digits and _, as in double_pendulum");
  }
  support::Diagnostics diagnostics;
  support::Source source(name, starter_called(name));
  model::build_model(source, diagnostics);
  if (!diagnostics.has_errors()) return;
  const support::Diagnostic& first = diagnostics.all().front();
  throw UsageError("init: " + first.message + "; " + first.hint);
}

}  // namespace

int init(const Options& options) {
  const std::string name = options.word.empty() ? k_starter_name : without_ending(options.word);
  check_name(name);
  const std::string path = name + std::string(k_ending);
  write_new_file(path, starter_called(name));
  write_standard_output("wrote " + path + "; look at it with: gauss-gen evaluate " + path + "\n");
  return k_ok;
}

}  // namespace gaussgen::cli
