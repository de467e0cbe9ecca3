#include "cli/messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.hpp"
#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::cli {

namespace {

using Json = nlohmann::ordered_json;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// https://no-color.org; a terminal that does not say what it is, or that it can nothing, gets plain text.
support::Colour colour_of(const MessageOptions& options) {
  const bool is_able = isatty(STDERR_FILENO) != 0 && variable("NO_COLOR").empty() && !variable("TERM").empty() &&
                       variable("TERM") != "dumb";
  const bool is_wanted =
      options.colour == UseOfColour::always || (options.colour == UseOfColour::on_terminals && is_able);
  return is_wanted ? support::Colour::ansi : support::Colour::none;
}

/// ASCII only, and what is not UTF-8 in the name of a file does not break the line.
void print(const Json& object) { std::cerr << object.dump(-1, ' ', true, Json::error_handler_t::replace) << "\n"; }

Json located(const support::Diagnostic& finding, const support::Source& source) {
  const std::uint32_t last = std::max(finding.span.begin, finding.span.end);
  const support::Position begin = source.position(finding.span.begin);
  const support::Position end = source.position(last);
  Json object;
  object["severity"] = finding.severity == support::Severity::error ? "error" : "warning";
  object["code"] = finding.code;
  object["message"] = finding.message;
  object["hint"] = finding.hint;
  object["file"] = source.name_at(finding.span.begin);
  object["line"] = begin.line;
  object["column"] = begin.column;
  object["end_line"] = end.line;
  object["end_column"] = end.column;
  object["begin"] = source.offset_in_file(finding.span.begin);
  object["end"] = source.offset_in_file(finding.span.begin) + (last - finding.span.begin);
  return object;
}

void print_lines(const support::Diagnostics& diagnostics, const support::Source& source) {
  std::size_t left_out = 0;
  for (const support::Diagnostic& finding : support::in_order(diagnostics, left_out)) print(located(finding, source));
  if (left_out > 0) print({{"severity", "note"}, {"message", fmt::format("{} more findings", left_out)}});
}

struct Remark {
  const char* severity;
  std::string mark;  ///< before the text, for people
  std::string text;
  std::string hint = {};
  Facts facts = {};
};

void say(const Remark& remark, const MessageOptions& options) {
  if (options.is_silent) return;
  const std::string line = remark.text.substr(0, remark.text.find_last_not_of('\n') + 1);
  if (options.format == MessageFormat::text) {
    std::cerr << remark.mark << support::without_controls(line) << "\n"
              << remark.hint << (remark.hint.empty() ? "" : "\n");
    return;
  }
  Json object{{"severity", remark.severity}, {"message", line}};
  if (!remark.hint.empty()) object["hint"] = remark.hint;
  for (const auto& [name, fact] : remark.facts) {
    std::visit([&, &key = name](const auto& value) { object[key] = value; }, fact);
  }
  print(object);
}

}  // namespace

MessageOptions messages_of(int argc, const char* const* argv, const std::string& program) {
  MessageOptions options;
  options.program = program;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool is_next = word == "json" && std::string(argv[i - 1]) == "--diagnostics";
    if (is_next || word == "--diagnostics=json") options.format = MessageFormat::json;
  }
  return options;
}

int report(const support::Diagnostics& diagnostics, const support::Source& source, const MessageOptions& options) {
  if (options.is_silent) {
    // The exit code is all that is wanted.
  } else if (options.format == MessageFormat::json) {
    print_lines(diagnostics, source);
  } else {
    std::cerr << support::render(diagnostics, source, colour_of(options));
  }
  if (!diagnostics.has_errors()) return k_ok;
  for (const support::Diagnostic& diagnostic : diagnostics.all()) {
    const bool is_limit = diagnostic.code == support::code::k_file_too_large.id ||
                          diagnostic.code == support::code::k_expression_limit.id;
    if (diagnostic.severity == support::Severity::error && !is_limit) return k_model_error;
  }
  return k_too_large;
}

void warn(const std::string& text, const MessageOptions& options) { say({"warning", "warning: ", text}, options); }

void remark(const std::string& text, const MessageOptions& options) { remark(text, {}, options); }

void remark(const std::string& text, const Facts& facts, const MessageOptions& options) {
  say({"note", "", text, {}, facts}, options);
}

int fail(const std::string& what, int code, const MessageOptions& options, const std::string& hint) {
  say({"error", options.program + ": ", what, hint}, options);
  return code;
}

int fail(const UsageError& error, const MessageOptions& options) {
  if (options.format == MessageFormat::text || error.findings().empty())
    return fail(error.what(), k_usage_error, options);
  for (const support::Diagnostic& finding : error.findings()) {
    print({{"severity", "error"},
           {"code", finding.code},
           {"message", error.option() + ": " + finding.message},
           {"hint", finding.hint}});
  }
  return k_usage_error;
}

}  // namespace gaussgen::cli
