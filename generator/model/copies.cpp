#include "model/copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

using support::Diagnostic;
using support::is_letter;
using support::is_name_character;

namespace {

using Prefixes = std::set<std::string>;

constexpr std::size_t k_most_named = 3;

std::string longest_prefix(const std::string& name, const Prefixes& prefixes) {
  for (std::size_t end = name.rfind('_'); end != std::string::npos && end > 0; end = name.rfind('_', end - 1)) {
    std::string beginning = name.substr(0, end + 1);
    if (prefixes.count(beginning) > 0) return beginning;
  }
  return {};
}

struct OwnText {
  std::string text;
  std::string prefix;  ///< that was in it
};

/// Values of parameters differ between copies; of all else, the first that is wrong stands for the others.
bool is_about_values(const std::string& code) {
  namespace known = support::code;
  for (const support::ErrorCode& of : {known::k_undefined_value, known::k_not_finite, known::k_negative_inertia,
                                       known::k_asymmetric_inertia, known::k_unreal_inertia, known::k_no_mass}) {
    if (code == of.id) return true;
  }
  return false;
}

/// `kept` are names of files, in which a word may look like a name of a copy.
OwnText without_prefixes(const std::string& text, const Prefixes& prefixes, const std::vector<std::string>& kept) {
  OwnText result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t size = 1;
    const auto file = std::find_if(kept.begin(), kept.end(), [&](const std::string& name) {
      return !name.empty() && text.compare(at, name.size(), name) == 0;
    });
    if (file != kept.end()) {
      size = file->size();
    } else if (is_name_character(text[at])) {
      while (is_name_character(text[std::min(at + size, text.size() - 1)]) && at + size < text.size()) ++size;
      const std::string prefix = is_letter(text[at]) ? longest_prefix(text.substr(at, size), prefixes) : std::string();
      if (!prefix.empty()) result.prefix = prefix;
      at += prefix.size();
      size -= prefix.size();
    }
    result.text.append(text, at, size);
    at += size;
  }
  return result;
}

std::string words_for(const Prefixes& copies) {
  std::vector<std::string> names;
  for (const std::string& prefix : copies) {
    if (names.size() < k_most_named) names.push_back("'" + prefix.substr(0, prefix.size() - 1) + "'");
  }
  const std::size_t others = copies.size() - names.size();
  return fmt::format("; in submodel{} {}{}", copies.size() > 1 ? "s" : "", support::joined(names),
                     others == 0 ? "" : fmt::format(" and {} more", others));
}

}  // namespace

void Copies::add(const Copies& inside, const std::string& prefix) {
  for (const auto& [file, prefixes] : inside.prefixes_) {
    for (const std::string& inner : prefixes) add(file, prefix + inner);
  }
}

std::string Copies::prefix_of(const std::string& name, std::uint32_t at, const support::Source& source) const {
  const auto file = prefixes_.find(at - source.offset_in_file(at));
  return file == prefixes_.end() ? std::string() : longest_prefix(name, file->second);
}

support::Diagnostics Copies::in_own_names(const support::Diagnostics& found, const support::Source& source) const {
  const std::vector<std::string> files = source.names();
  using Place = std::tuple<std::uint32_t, std::uint32_t, std::string, std::string>;
  std::map<Place, Prefixes> copies_at;  // copies of which something is said
  std::vector<std::pair<Diagnostic, Place>> own;
  for (Diagnostic finding : found.all()) {
    const auto file = prefixes_.find(finding.span.begin - source.offset_in_file(finding.span.begin));
    Place place;
    if (file != prefixes_.end()) {
      const OwnText message = without_prefixes(finding.message, file->second, files);
      finding.message = message.text;
      finding.hint = without_prefixes(finding.hint, file->second, files).text;
      place = {finding.span.begin, finding.span.end, finding.code, finding.message};
      const bool is_new = copies_at.count(place) == 0;
      if (!message.prefix.empty()) copies_at[place].insert(message.prefix);
      if (!is_new) continue;
    }
    own.emplace_back(std::move(finding), std::move(place));
  }
  support::Diagnostics result;
  for (auto& [finding, place] : own) {
    const auto copies = copies_at.find(place);
    if (copies != copies_at.end()) {
      const auto& all = prefixes_.at(finding.span.begin - source.offset_in_file(finding.span.begin));
      if (is_about_values(finding.code) && copies->second.size() < all.size())
        finding.message += words_for(copies->second);
    }
    result.add(std::move(finding));
  }
  return result;
}

}  // namespace gaussgen::model
