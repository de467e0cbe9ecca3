// A page for each code. The message of an example is the one that this program gives.

#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/explanations.hpp"
#include "cli/files.hpp"
#include "cli/texts.hpp"
#include "cli/usage_error.hpp"
#include "pipeline.hpp"
#include "support/assert.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

namespace {

Explanation explanation_of(const support::ErrorCode& code) {
  const auto is_meant = [&](const Page& page) { return std::string_view(page.code) == code.id; };
  const auto page = std::find_if(pages().begin(), pages().end(), is_meant);
  GAUSS_ASSERT(page != pages().end(), code.id);
  return explanation_of(*page);
}

std::string message_of(const Explanation& explanation) {
  // Beside it is what `gauss-gen init` writes.
  const auto read_other = [](const std::string& path, std::string& why) -> std::optional<std::string> {
    if (path == k_starter_name + std::string(".yaml")) return starter_called(k_starter_name);
    why = "No such file or directory";
    return std::nullopt;
  };
  support::Source source("example.yaml", explanation.wrong, read_other);
  support::Diagnostics diagnostics;
  PipelineOptions options;
  if (explanation.options == "--route paper") options.route = Route::paper;
  if (explanation.options == "--strategy tree") options.strategy = Strategy::tree;
  compile(source, options, diagnostics, {});
  return support::render(diagnostics, source);
}

std::string indented(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += (end == begin ? "" : "    ") + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return result;
}

std::string title_of(const support::ErrorCode& code) { return fmt::format("{}: {}", code.id, code.meaning); }

std::string command_of(const Explanation& explanation) {
  const std::string options = explanation.options.empty() ? "" : " " + explanation.options;
  return fmt::format("gauss-gen{} example.yaml", options);
}

std::string page_as_text(const support::ErrorCode& code) {
  const Explanation explanation = explanation_of(code);
  return fmt::format("{}\n\n{}\n\nAn example; what is marked - is wrong, and + puts it right:\n\n{}\n{} says\n\n{}",
                     title_of(code), explanation.about, indented(explanation.example), command_of(explanation),
                     indented(message_of(explanation)));
}

std::string page_as_markdown(const support::ErrorCode& code) {
  const Explanation explanation = explanation_of(code);
  return fmt::format("## {}\n\n{}\n\n```diff\n{}```\n\n`{}` says\n\n{}", title_of(code), explanation.about,
                     explanation.example, command_of(explanation), indented(message_of(explanation)));
}

std::string list() {
  std::string text;
  for (const support::ErrorCode& code : all_codes()) text += fmt::format("{}  {}\n", code.id, code.meaning);
  return text + "\ngauss-gen explain CODE says more about one of them.\n";
}

std::string document() {
  std::string text =
      "# Errors and warnings\n\n"
      "Written by `gauss-gen explain --format markdown` (`./run regen`); do not edit. The texts are in\n"
      "`generator/cli/explanations/`, the messages are those of the program. In each example, what is marked `-` is\n"
      "wrong, and `+` puts it right.\n\n";
  for (const support::ErrorCode& code : all_codes()) text += fmt::format("- {}\n", title_of(code));
  for (const support::ErrorCode& code : all_codes()) text += "\n" + page_as_markdown(code);
  return text;
}

std::string in_capitals(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

constexpr std::size_t k_digits = 3;

/// 31 and 031 are E031, if it is no warning, too.
std::vector<support::ErrorCode> codes_of_digits(const std::string& word) {
  std::vector<support::ErrorCode> meant;
  if (word.empty() || word.size() > k_digits || word.find_first_not_of("0123456789") != std::string::npos) return meant;
  const std::string digits = std::string(k_digits - word.size(), '0') + word;
  for (const support::ErrorCode& code : all_codes()) {
    if (std::string(code).substr(1) == digits) meant.push_back(code);
  }
  return meant;
}

support::ErrorCode find_code(const std::string& word) {
  const std::string wanted = in_capitals(word);
  std::vector<std::string> known;
  for (const support::ErrorCode& code : all_codes()) {
    if (wanted == code.id) return code;
    known.emplace_back(code.id);
  }
  const std::vector<support::ErrorCode> meant = codes_of_digits(word);
  if (meant.size() == 1) return meant.front();
  const std::string near = meant.empty() ? support::did_you_mean(wanted, known)
                                         : fmt::format("did you mean '{}' or '{}'?", meant[0].id, meant[1].id);
  throw UsageError(
      fmt::format("explain: there is no code '{}'; {}", word, near.empty() ? "gauss-gen explain lists them" : near));
}

}  // namespace

int explain(const Options& options) {
  const bool is_markdown = options.format == Format::markdown;
  if (options.word.empty()) {
    write_standard_output(is_markdown ? document() : list());
    return k_ok;
  }
  const support::ErrorCode code = find_code(options.word);
  write_standard_output(is_markdown ? page_as_markdown(code) : page_as_text(code));
  return k_ok;
}

}  // namespace gaussgen::cli
