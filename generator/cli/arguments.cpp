#include "cli/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "emit/identifiers.hpp"
#include "model/emitted_names.hpp"
#include "support/suggest.hpp"

namespace gaussgen::cli {

namespace {

constexpr std::size_t k_longest_namespace = 200;

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find("::"); end != std::string::npos; end = text.find("::", begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 2;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

bool is_identifier(const std::string& text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && is_letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return is_letter(c) || is_digit(c); });
}

/// `gauss` is where headers live when nothing else is asked for; the other names of the emitter would hide its own.
bool is_free(const std::string& name) {
  return name == "gauss" || (emit::mangled(name) == name && !model::is_emitted_macro(name));
}

}  // namespace

std::string refusal_of_folder(const std::string& text) {
  static const std::vector<std::string> k_header_endings = {".h", ".hh", ".hpp", ".hxx"};
  const std::filesystem::path path(text);
  const std::string ending = path.extension().string();
  std::error_code error;
  if (std::find(k_header_endings.begin(), k_header_endings.end(), ending) == k_header_endings.end()) return "";
  if (std::filesystem::is_directory(path, error)) return "";
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  return fmt::format(
      "'{}' is the name of a file, and a folder is needed, as the model names the header: write -o {}, or -o - > {} "
      "for another name",
      text, folder, text);
}

std::string refusal_of_choice(const std::string& word, const std::vector<std::string>& choices) {
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return "";
  const std::string near = support::did_you_mean(word, choices);
  return fmt::format("there is no '{}'; {}", word, near.empty() ? "choose from " + support::joined(choices) : near);
}

std::optional<long long> whole_number(const std::string& text, long long least, long long most) {
  constexpr std::size_t k_most_digits = 18;
  const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number || text.size() > k_most_digits) return std::nullopt;
  const long long value = std::stoll(text);
  return value < least || value > most ? std::nullopt : std::optional(value);
}

std::string refusal_of_namespace(const std::string& text) {
  if (text.size() > k_longest_namespace)
    return fmt::format("a namespace of more than {} characters", k_longest_namespace);
  const std::vector<std::string> parts = parts_of(text);
  for (const std::string& part : parts) {
    if (!is_identifier(part)) return fmt::format("'{}' is not a C++ namespace; write it as in acme::models", text);
    if (!is_free(part)) return fmt::format("'{}' cannot be a namespace: the name is reserved", part);
  }
  if (parts.size() > 1 && parts[0] == "gauss" && model::is_taken_in_gauss(parts[1]))
    return fmt::format("'{}' is a name of emitted code in gauss", parts[1]);
  return "";
}

}  // namespace gaussgen::cli
