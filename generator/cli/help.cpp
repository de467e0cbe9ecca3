#include "cli/help.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace gaussgen::cli {

const char* const k_about = "gauss-gen: equations of motion and constraint reactions as C++, by Gauss's principle\n";
const char* const k_about_evaluate =
    "Accelerations, multipliers, reactions, energy and residuals at the initial state, as numbers.\n";
const char* const k_about_derivation = "The paper's objects and the final equations of a model as formulas.\n";
const char* const k_about_status =
    "The status comes first, and numbers are to be trusted with ok only. Else it says why not:\n"
    "  singular_mass_matrix   a motion has no inertia here, or the coordinates are singular\n"
    "  dependent_constraints  multipliers are not unique\n"
    "  violated_constraints   the initial state does not satisfy a constraint\n"
    "  not_finite             a value is undefined\n"
    "  impossible_bodies      masses or inertias are such as no body has\n"
    "The exit code is 0 with each of them. In JSON numbers are strings, so that no digit is lost.";

namespace {

constexpr std::size_t k_column = 26;
constexpr std::size_t k_width = 100;

const char* const k_usage =
    "Usage:\n"
    "  gauss-gen [OPTIONS] MODEL              write <name>.hpp into this folder\n"
    "  gauss-gen evaluate [OPTIONS] MODEL     accelerations, reactions, energy at the initial state\n"
    "  gauss-gen derivation [OPTIONS] MODEL   Z, the metric, c, b and the final equations as formulas\n"
    "MODEL is a YAML file; - stands for standard input.\n";

const char* const k_exit_codes =
    "evaluate and derivation have options of their own: see gauss-gen evaluate --help.\n"
    "Exit codes: 0 ok, 1 error in the model, 2 usage, 3 input or output, 4 too large, 70 internal error.";

/// CLI11's page, with a usage that says what each command is for.
class Help : public CLI::Formatter {
 public:
  Help() { column_width(k_column); }

  std::string make_usage(const CLI::App* app, std::string name) const override {
    if (app->get_parent() == nullptr) return k_usage;
    return fmt::format("Usage: gauss-gen {} [OPTIONS] MODEL\n", name.substr(name.find_last_of(' ') + 1));
  }

  // Both are in the usage.
  std::string make_positionals(const CLI::App* /*app*/) const override { return ""; }
  std::string make_subcommands(const CLI::App* /*app*/, CLI::AppFormatMode /*mode*/) const override { return ""; }
};

}  // namespace

void write_help_by(CLI::App& app) {
  app.formatter(std::make_shared<Help>());
  app.footer(k_exit_codes);
}

std::string wrapped(const std::string& text) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (column > 0 && column + 1 + end - begin > k_width - k_column) {
      result += '\n';
      column = 0;
    }
    if (column > 0) result += ' ';
    result += text.substr(begin, end - begin);
    column += (column > 0 ? 1 : 0) + end - begin;
    begin = end + 1;
  }
  return result;
}

}  // namespace gaussgen::cli
