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

using Prefixes = Copies::Prefixes;

constexpr std::size_t k_most_named = 3;

std::string longest_prefix(const std::string& name, const Prefixes& prefixes) {
  for (std::size_t end = name.rfind('_'); end != std::string::npos && end > 0; end = name.rfind('_', end - 1)) {
    std::string beginning = name.substr(0, end + 1);
    if (prefixes.count(beginning) > 0) return beginning;
  }
  return {};
}

/// Values of parameters differ between copies; of all else, the first that is wrong stands for the others.
bool is_about_values(const std::string& code) {
  namespace known = support::code;
  for (const support::ErrorCode& of : {known::k_undefined_value, known::k_not_finite, known::k_negative_inertia,
                                       known::k_asymmetric_inertia, known::k_unreal_inertia, known::k_no_mass}) {
    if (code == of.id) return true;
  }
  return false;
}

struct OwnText {
  std::string text;
  std::string prefix;  ///< that was in it
};

/// Takes prefixes off the words of a text; names of files stay, in which a word may look like a name of a copy.
class Stripping {
 public:
  Stripping(const std::string& text, const Prefixes& prefixes, const std::vector<std::string>& files)
      : text_(text), prefixes_(prefixes), files_(files) {}

  OwnText run() {
    if (prefixes_.empty()) return {text_, ""};
    while (at_ < text_.size()) {
      if (const std::size_t size = size_of_file_name(); size > 0) {
        keep(size);
      } else if (is_name_character(text_[at_])) {
        word();
      } else {
        keep(1);
      }
    }
    return std::move(result_);
  }

 private:
  std::size_t size_of_file_name() const {
    const auto file = std::find_if(files_.begin(), files_.end(), [&](const std::string& name) {
      return !name.empty() && text_.compare(at_, name.size(), name) == 0;
    });
    return file == files_.end() ? 0 : file->size();
  }

  void word() {
    std::size_t size = 1;
    while (at_ + size < text_.size() && is_name_character(text_[at_ + size])) ++size;
    const std::string prefix = is_letter(text_[at_]) ? longest_prefix(text_.substr(at_, size), prefixes_) : "";
    if (!prefix.empty()) result_.prefix = prefix;
    at_ += prefix.size();
    keep(size - prefix.size());
  }

  void keep(std::size_t size) {
    result_.text.append(text_, at_, size);
    at_ += size;
  }

  const std::string& text_;
  const Prefixes& prefixes_;
  const std::vector<std::string>& files_;
  std::size_t at_ = 0;
  OwnText result_;
};

std::string words_for(const Prefixes& copies) {
  std::vector<std::string> names;
  for (const std::string& prefix : copies) {
    if (names.size() < k_most_named) names.push_back("'" + prefix.substr(0, prefix.size() - 1) + "'");
  }
  const std::size_t others = copies.size() - names.size();
  return fmt::format("; in submodel{} {}{}", copies.size() > 1 ? "s" : "", support::joined(names),
                     others == 0 ? "" : fmt::format(" and {} more", others));
}

using Place = std::tuple<std::uint32_t, std::uint32_t, std::string, std::string>;

struct OwnFinding {
  Diagnostic finding;
  Prefixes copies;  ///< of which it is said
};

}  // namespace

const Prefixes& Copies::prefixes_at(std::uint32_t at, const support::Source& source) const {
  static const Prefixes k_none;
  const auto file = prefixes_.find(at - source.offset_in_file(at));
  return file == prefixes_.end() ? k_none : file->second;
}

void Copies::add(const Copies& inside, const std::string& prefix) {
  for (const auto& [file, prefixes] : inside.prefixes_) {
    for (const std::string& inner : prefixes) add(file, prefix + inner);
  }
}

std::size_t Copies::count() const {
  std::size_t count = 0;
  for (const auto& [file, prefixes] : prefixes_) count += prefixes.size();
  return count;
}

std::string Copies::prefix_of(const std::string& name, std::uint32_t at, const support::Source& source) const {
  return longest_prefix(name, prefixes_at(at, source));
}

support::Diagnostics Copies::in_own_names(const support::Diagnostics& found, const support::Source& source) const {
  const std::vector<std::string> files = source.names();
  std::vector<OwnFinding> own;
  std::map<Place, std::size_t> known;  // index into `own`
  for (const Diagnostic& finding : found.all()) {
    const Prefixes& prefixes = prefixes_at(finding.span.begin, source);
    const OwnText message = Stripping(finding.message, prefixes, files).run();
    const Place place{finding.span.begin, finding.span.end, finding.code, message.text};
    const auto [first, is_new] = known.emplace(place, own.size());
    if (is_new) {
      own.push_back({finding, {}});
      own.back().finding.message = message.text;
      own.back().finding.hint = Stripping(finding.hint, prefixes, files).run().text;
    }
    if (!message.prefix.empty()) own[first->second].copies.insert(message.prefix);
  }
  support::Diagnostics result;
  for (OwnFinding& of : own) {
    const bool is_of_some = !of.copies.empty() && of.copies.size() < prefixes_at(of.finding.span.begin, source).size();
    if (is_of_some && is_about_values(of.finding.code)) of.finding.message += words_for(of.copies);
    result.add(std::move(of.finding));
  }
  return result;
}

}  // namespace gaussgen::model
