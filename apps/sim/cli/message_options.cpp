#include "sim/cli/message_options.hpp"

#include "sim/cli/validators.hpp"

#include <CLI/CLI.hpp>

namespace gausssim {

void add_messages(CLI::App& command, gaussgen::cli::MessageOptions& options) {
  using gaussgen::cli::MessageFormat;
  using gaussgen::cli::UseOfColour;
  command
      .add_option_function<std::string>(
          "--diagnostics",
          [&options](const std::string& word) {
            options.format = word == "json" ? MessageFormat::json : MessageFormat::text;
          },
          "messages on standard error: text (default), or json, an object in each line")
      ->check(one_of({"text", "json"}))
      ->type_name("FORMAT");
  command
      .add_option_function<std::string>(
          "--color",
          [&options](const std::string& word) {
            options.colour = word == "always"  ? UseOfColour::always
                             : word == "never" ? UseOfColour::never
                                               : UseOfColour::on_terminals;
          },
          "auto (default: on a terminal, unless NO_COLOR is set), always or never")
      ->check(one_of({"auto", "always", "never"}))
      ->type_name("WHEN");
}

}  // namespace gausssim
