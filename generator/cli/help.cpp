#include "cli/help.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/exit_codes.hpp"

namespace gaussgen::cli {

const char* const k_about = "gauss-gen: equations of motion and constraint reactions as C++, by Gauss's principle\n";
const char* const k_summary = "equations of motion and constraint reactions as C++";
const char* const k_description =
    "From a model in YAML, gauss-gen derives equations of motion and the forces in constraints by Gauss's principle of "
    "least constraint, and writes them as one C++ header that needs nothing but the standard library. MODEL is a YAML "
    "file; - stands for standard input. What is wrong with a model is said with its place and a code, which explain "
    "explains.";
const char* const k_about_evaluate =
    "Accelerations, multipliers, reactions, energy and residuals at the initial state, as numbers.\n";
const char* const k_about_linearize =
    "A and B of x' = A x + B u near a motion, over independent coordinates and speeds,\n"
    "with eigenvalues and modes.\n";
const char* const k_about_derivation = "The paper's objects and the final equations of a model as formulas.\n";
const char* const k_about_explain =
    "What the code of a message means: an example, the message, and how to put it right.\n"
    "Without a code, all of them in one line each.\n";
const char* const k_about_init =
    "Writes NAME.yaml, a commented model to begin with; an existing file stays as it is.\n";
const char* const k_about_schema =
    "The JSON Schema (draft-07) of model files, with which editors check and complete.\n";
const char* const k_about_completion = "A script that completes command lines of gauss-gen, for bash, zsh or fish.\n";
const char* const k_about_status =
    "The status comes first, and numbers are to be trusted with ok only. Else it says why not:\n"
    "  singular_mass_matrix   a motion has no inertia here, or the coordinates are singular\n"
    "  dependent_constraints  multipliers are not unique\n"
    "  violated_constraints   the initial state does not satisfy a constraint\n"
    "  not_finite             a value is undefined; evaluate says in which groups\n"
    "  impossible_bodies      masses or inertias are such as no body has\n"
    "The exit code is 0 with each of them. In JSON numbers are strings, so that no digit is lost.";

namespace {

constexpr std::size_t k_column = 26;
constexpr std::size_t k_width = 100;

const char* const k_usage =
    "Usage:\n"
    "  gauss-gen [OPTIONS] MODEL              write <name>.hpp into this folder\n"
    "  gauss-gen evaluate [OPTIONS] MODEL     accelerations, reactions, energy at the initial state\n"
    "  gauss-gen linearize [OPTIONS] MODEL    A, B, eigenvalues and modes near a motion\n"
    "  gauss-gen derivation [OPTIONS] MODEL   Z, the metric, c, b and the final equations as formulas\n"
    "  gauss-gen explain [CODE]               what the code of a message means, such as E012\n"
    "  gauss-gen init [NAME]                  write NAME.yaml, a commented model to begin with\n"
    "  gauss-gen schema                       the JSON Schema of models, for editors\n"
    "  gauss-gen completion SHELL             completions for bash, zsh or fish\n"
    "MODEL is a YAML file; - stands for standard input.\n";

std::string footer() {
  std::string text = "Commands have options of their own: see gauss-gen evaluate --help.\nExit codes: ";
  for (const ExitMeaning& exit : k_exit_meanings) {
    text += fmt::format("{}{} {}", exit.code == k_ok ? "" : ", ", static_cast<int>(exit.code), exit.meaning);
  }
  return text + ".";
}

/// CLI11's page, with a usage that says what each command is for.
class Help : public CLI::Formatter {
 public:
  Help() { column_width(k_column); }

  std::string make_usage(const CLI::App* app, std::string name) const override {
    if (app->get_parent() == nullptr) return k_usage;
    std::string usage = fmt::format("Usage: gauss-gen {} [OPTIONS]", name.substr(name.find_last_of(' ') + 1));
    for (const CLI::Option* option : app->get_options()) {
      if (!option->nonpositional()) usage += " " + option->get_type_name();
    }
    return usage + "\n";
  }

  // Both are in the usage.
  std::string make_positionals(const CLI::App* /*app*/) const override { return ""; }
  std::string make_subcommands(const CLI::App* /*app*/, CLI::AppFormatMode /*mode*/) const override { return ""; }
};

}  // namespace

void write_help_by(CLI::App& app) {
  app.formatter(std::make_shared<Help>());
  app.footer(footer());
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
