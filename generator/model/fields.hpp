#pragma once
// Reading the values of one map of the file. Every function reports what is wrong and returns something
// with which reading can go on.

#include <array>
#include <string>
#include <vector>

#include "model/reading.hpp"

namespace gaussgen::model {

/// "a map", "a list", "a single value", "nothing".
std::string kind_text(const spec::Node& node);

/// `where` names the map in messages: "body 'ball'".
bool expect_map(const spec::Node& node, support::Span owner, const std::string& where, Reading& reading);

/// `hint` says what the list is of, where it is not plain.
bool expect_list(const spec::Node& node, support::Span owner, const std::string& where, Reading& reading,
                 const char* hint = nullptr);

/// `hint` says what the entries are, where it is not plain.
bool expect_length(const spec::Node& list, std::size_t length, const std::string& where, Reading& reading,
                   const std::string& hint = "");

void check_keys(const spec::Node& map, const std::string& where, const std::vector<std::string>& allowed,
                Reading& reading);

/// An unknown key near `key` is reported already, with `key` as the suggestion.
bool has_misspelt(const spec::Node& map, const std::string& key, const Reading& reading);

/// The value at `key`; a missing one is reported at `owner`, with `more` behind the hint to add it.
const spec::Node* required(const spec::Node& map, const std::string& key, support::Span owner, const std::string& where,
                           Reading& reading, const std::string& more = "");

/// The text at `key`; empty when the key is absent.
std::string text_field(const spec::Node& map, const std::string& key, Reading& reading);

/// Of the unit that text_field found at `key`; nothing when it is empty.
std::optional<Dimension> dimension_at(const spec::Node& map, const std::string& key, const std::string& unit,
                                      Reading& reading);

/// Fills `unit` and `dimension` of what the map describes.
template <class Owner>
void read_unit(const spec::Node& map, Owner& owner, Reading& reading) {
  owner.unit = text_field(map, "unit", reading);
  owner.dimension = dimension_at(map, "unit", owner.unit, reading);
}

/// A scalar that is a name or a word; `where` completes "… must be a single word".
bool expect_scalar(const spec::Node& node, support::Span owner, const std::string& where, Reading& reading);

Ast read_expression(const spec::Node& node, support::Span owner, Reading& reading);

/// The expression at `key`; nothing when the key is absent.
std::optional<Ast> expression_field(const spec::Node& map, const std::string& key, Reading& reading);

/// Three components.
std::array<Ast, 3> read_vector(const spec::Node& node, support::Span owner, const std::string& where, Reading& reading);

Name name_of(const spec::LocatedText& text);

/// "did you mean 'psi'?", or which submodel does without what declares it, or an empty text, also when many names were
/// searched before; in the file of a submodel, of the names of its own.
std::string did_you_mean(const Name& name, const std::vector<std::string>& candidates, Reading& reading);

/// The same for candidates that take time to list: `list()` is asked only when there is a search.
template <class List>
std::string did_you_mean_one_of(const Name& name, List list, Reading& reading) {
  return reading.searches.are_spent() ? std::string() : did_you_mean(name, list(), reading);
}

template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

/// Whether names refer to entries of the section, or to what they declare.
bool declares(const std::string& section);

/// Of a section that is no map, the names of its entries are missing.
void note_unread_section(const spec::Entry& section, Reading& reading);

/// A section of the file: each entry goes to `read(entry)`. An absent or empty section is fine.
template <class Read>
void read_section(const spec::Node& root, const std::string& key, Reading& reading, Read read) {
  for (const spec::Entry& entry : root.entries) {
    if (entry.key.text != key || entry.value.kind == spec::NodeKind::empty) continue;
    if (!expect_map(entry.value, entry.key.span, "'" + key + "'", reading)) {
      note_unread_section(entry, reading);
      continue;
    }
    for (const spec::Entry& item : entry.value.entries) read(item);
  }
}

}  // namespace gaussgen::model
