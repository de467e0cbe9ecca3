#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/files.hpp"
#include "cli/guard.hpp"
#include "cli/replacement.hpp"
#include "paper.hpp"
#include "read_model.hpp"

namespace gaussgen::cli {

int derive(const Options& options) {
  std::optional<ReadingGuard> guard(options.messages);
  support::Source source = read_source(options.model);
  support::Diagnostics diagnostics;
  const auto model = read_model(source, diagnostics, options.pipeline.choices);
  guard.reset();
  std::optional<DerivationGuard> derivation(std::in_place, std::vector<std::string>{"derivation"}, options.most_seconds,
                                            options.messages);
  std::string text;
  if (model) text = derivation_text(*model, options.format == Format::latex, diagnostics);
  derivation.reset();  // before anything is written
  const int code = report(diagnostics, source, options.messages);
  if (code != k_ok) return code;
  if (options.output.empty() || options.output == "-") {
    write_standard_output(text);
  } else {
    keep_what_was_read(options.output, source);
    Replacement(options.output, text).commit();
  }
  return k_ok;
}

}  // namespace gaussgen::cli
