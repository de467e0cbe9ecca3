#include "model/unread.hpp"

#include "support/characters.hpp"

namespace gaussgen::model {

using support::is_letter;
using support::is_name_character;

namespace {

bool begins_with_one_of(const std::set<std::string>& beginnings, const std::string& name) {
  for (std::size_t size = 0; size <= name.size() && !beginnings.empty(); ++size) {
    if (beginnings.count(name.substr(0, size)) > 0) return true;
  }
  return false;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_letter(text[at])) continue;
    const std::size_t begin = at;
    while (at < text.size() && is_name_character(text[at])) ++at;
    const bool has_index = at < text.size() && text[at] == '$';
    words.push_back(text.substr(begin, at - begin + (has_index ? 1 : 0)));
  }
  return words;
}

}  // namespace

std::vector<std::string> words_in(const spec::Node& part) {
  std::vector<std::string> words = words_of(part.scalar.text);
  const auto add = [&](const spec::Node& inner) {
    for (std::string& word : words_in(inner)) words.push_back(std::move(word));
  };
  for (const spec::Node& item : part.items) add(item);
  for (const spec::Entry& entry : part.entries) add(entry.value);
  return words;
}

void Unread::add(const spec::Entry& part) {
  for (const std::string& word : words_of(part.key.text)) add_owner(word);
  add(part.value);
}

void Unread::add(const spec::Node& part) {
  for (const std::string& word : words_of(part.scalar.text)) add_owner(word);
  for (const spec::Node& item : part.items) add(item);
  for (const spec::Entry& entry : part.entries) add(entry);
}

void Unread::add_owner(const std::string& name) {
  const std::size_t index = name.find('$');
  if (index != std::string::npos) {
    beginnings_.insert(name.substr(0, index));
    return;
  }
  names_.insert(name);
  beginnings_.insert(name + "_");
}

void Unread::add_everything(const std::string& prefix) {
  frames_.insert(prefix);
  beginnings_.insert(prefix);
}

void Unread::add(const Unread& inside, const std::string& prefix) {
  for (const std::string& name : inside.names_) names_.insert(prefix + name);
  for (const std::string& beginning : inside.beginnings_) beginnings_.insert(prefix + beginning);
  for (const std::string& beginning : inside.frames_) frames_.insert(prefix + beginning);
}

bool Unread::may_declare(const std::string& name) const {
  const std::string owner = name.substr(0, name.find('.'));
  if (owner.size() < name.size() && begins_with_one_of(frames_, owner)) return true;
  return names_.count(owner) > 0 || begins_with_one_of(beginnings_, owner);
}

bool Unread::may_declare_frame(const std::string& name) const {
  return begins_with_one_of(frames_, name) || may_declare(name);
}

}  // namespace gaussgen::model
