#pragma once
// What --help says, apart from the options themselves.

#include <string>

namespace CLI {
class App;
}

namespace gaussgen::cli {

extern const char* const k_about;
extern const char* const k_summary;
extern const char* const k_description;
extern const char* const k_about_evaluate;
extern const char* const k_about_linearize;
extern const char* const k_about_derivation;
extern const char* const k_about_explain;
extern const char* const k_about_init;
extern const char* const k_about_schema;
extern const char* const k_about_completion;

/// Below the options of evaluate.
extern const char* const k_about_status;

/// Our page in place of CLI11's, for `app` and the commands that are added to it afterwards.
void write_help_by(CLI::App& app);

/// `text` on lines that fit beside the column of options.
std::string wrapped(const std::string& text);

}  // namespace gaussgen::cli
