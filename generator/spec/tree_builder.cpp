#include "spec/tree_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "spec/foreign_space.hpp"
#include "spec/reader.hpp"
#include "spec/rejoin.hpp"
#include "spec/syntax_error.hpp"
#include "spec/text_check.hpp"
#include "support/error_codes.hpp"
#include "support/utf8.hpp"

namespace gaussgen::spec {

namespace code = support::code;
using support::Span;

namespace {

// What yaml-cpp reports as the tag of a scalar that has none: plain, and quoted or block.
const char* const k_plain_tag = "?";
const char* const k_quoted_tag = "!";

bool is_explicit_tag(const std::string& tag, bool quoted) {
  return !tag.empty() && tag != k_plain_tag && !(tag == k_quoted_tag && quoted);
}

/// The '%' of LaTeX or MATLAB at the beginning of a line: to YAML a directive for the next document.
std::optional<std::uint32_t> percent_before(const support::Source& source, std::uint32_t document) {
  std::uint32_t at = document;
  while (at > 0) {
    const std::string_view line = source.line_at(at - 1);
    at = static_cast<std::uint32_t>(line.data() - source.text().data());
    if (!line.empty() && line.front() == '%') return at;
    const std::size_t first = line.find_first_not_of(" \r");
    if (first != std::string_view::npos && line[first] != '#') return std::nullopt;
  }
  return std::nullopt;
}

/// What YAML takes for nothing, as `null` is, although a word stands there.
std::string word_for_nothing(std::string_view text, std::uint32_t at) {
  for (const char* word : {"null", "Null", "NULL"}) {
    if (text.substr(at, 4) == word) return word;
  }
  return {};
}

}  // namespace

TreeBuilder::TreeBuilder(const support::Source& source, support::Diagnostics& diagnostics)
    : source_(source),
      diagnostics_(diagnostics),
      skipped_(static_cast<std::uint32_t>(byte_order_mark(source.text()))) {}

std::uint32_t TreeBuilder::offset(const YAML::Mark& mark) const {
  const std::uint32_t at = static_cast<std::uint32_t>(mark.pos < 0 ? 0 : mark.pos) + skipped_;
  // The parser may see one line's end more.
  return std::min(at, static_cast<std::uint32_t>(source_.text().size()));
}

bool TreeBuilder::expects_key() const {
  return !open_.empty() && open_.back().node.kind == NodeKind::map && !open_.back().key && !open_.back().bad_key;
}

void TreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
  if (++documents_ == 1) return;
  const std::uint32_t at = offset(mark);
  if (const auto comment = percent_before(source_, at)) {
    diagnostics_.error(code::k_several_documents, {*comment, *comment + 1},
                       "a line that begins with '%' ends the document", "comments begin with #");
    throw Stop{};
  }
  // "- gauss: 1" ends with its list; what follows begins another document to YAML.
  if (root_ && root_->kind == NodeKind::sequence && !root_->flow) {
    diagnostics_.error(code::k_wrong_kind, {root_->span.begin, root_->span.begin + 1},
                       "a model file must be a map of 'key: value', and this begins a list",
                       "remove the '- ' in front of the first key");
    throw Stop{};
  }
  diagnostics_.error(code::k_several_documents, {at, at + 3}, "a second document begins here; a file holds one model",
                     "put each model in a file of its own");
  throw Stop{};
}

void TreeBuilder::count_node(Span span) {
  if (++nodes_ <= k_most_nodes) return;
  diagnostics_.error(code::k_file_too_large, span, fmt::format("the file has more than {} values", k_most_nodes),
                     "a model file describes one mechanism; split it");
  throw Stop{};
}

void TreeBuilder::refuse_extras(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
  const std::uint32_t at = offset(mark);
  const std::string_view text = source_.text();
  const bool quoted = style_at(text, at, true) != ScalarStyle::plain;
  // The mark is at the first of both.
  const auto report = [&](char sign, const char* message) {
    const std::size_t found = text.find(sign, at);
    const std::size_t begin = found == std::string_view::npos ? at : found;
    const std::size_t end = std::min(text.find_first_of(" ,]}\r\n", begin), text.size());
    const Span span{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::max(begin + 1, end))};
    diagnostics_.error(code::k_yaml_feature, span, message,
                       fmt::format("write the value itself; a text that begins with '{}' needs quotes", sign));
  };
  if (anchor != 0) report('&', "anchors (&name) are not part of the model format");
  if (is_explicit_tag(tag, quoted)) report('!', "tags (!name) are not part of the model format");
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  refuse_extras(mark, {}, anchor);
  Node node;
  node.span = {offset(mark), offset(mark)};
  count_node(node.span);
  if (expects_key()) return take_empty_key(node.span);
  add(std::move(node));
}

/// A word that is nothing to YAML is a name here, which is refused where names are, and known to what uses it.
void TreeBuilder::take_empty_key(Span span) {
  const std::string word = word_for_nothing(source_.text(), span.begin);
  if (word.empty()) return refuse_key(span);
  open_.back().key = align(word, source_.text(), span.begin, ScalarStyle::plain);
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t) {
  const std::uint32_t at = offset(mark);
  has_holes_ = true;
  // <<: *name is reported at the key.
  const bool is_of_bad_key = !open_.empty() && open_.back().bad_key;
  if (!is_of_bad_key)
    diagnostics_.error(code::k_yaml_feature, {at, at + 1}, "aliases (*name) are not part of the model format",
                       "write the value itself; a text that begins with '*' needs quotes");
  Node node;
  node.span = {at, at};
  if (expects_key()) return refuse_key(node.span);
  add(std::move(node));
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           const std::string& value) {
  refuse_extras(mark, tag, anchor);
  const std::uint32_t at = offset(mark);
  const ScalarStyle style = style_at(source_.text(), at, tag == k_quoted_tag);
  if (refuse_foreign_space(source_, at, diagnostics_)) throw Stop{};
  if ((style == ScalarStyle::single_quoted || style == ScalarStyle::double_quoted) &&
      !quote_is_closed(source_.text(), at, style)) {
    diagnostics_.error(code::k_yaml_syntax, {at, at + 1}, "this quote is never closed",
                       "end the text with the same quote");
    throw Stop{};
  }
  Node node;
  node.kind = NodeKind::scalar;
  node.plain = style == ScalarStyle::plain;
  node.flow = !open_.empty() && open_.back().node.flow;
  node.scalar = align(value, source_.text(), at, style);
  node.span = node.scalar.span;
  count_node(node.span);
  node.is_cut = refuse_escaped_characters(node.scalar);
  if (!expects_key()) return add(std::move(node));
  check_key_length(node.scalar);
  if (node.plain) refuse_slip_of_key(node.scalar);
  if (!open_.back().bad_key) open_.back().key = std::move(node.scalar);
}

void TreeBuilder::refuse_slip_of_key(const LocatedText& key) {
  if (key.text == "<<") {
    diagnostics_.error(code::k_yaml_feature, key.span, "merge keys (<<) are not part of the model format",
                       "write the entries themselves");
  } else if (!refuse_space_behind_key(source_, key.span.begin, diagnostics_)) {
    return;
  }
  open_.back().bad_key = true;
  has_holes_ = true;
}

/// They are taken out of the text, so that nothing else is said of them; whether there are some.
bool TreeBuilder::refuse_escaped_characters(LocatedText& scalar) {
  LocatedText kept;
  kept.span = scalar.span;
  for (std::size_t i = 0; i < scalar.text.size();) {
    const support::CodePoint point = support::code_point_at(scalar.text, i);
    if (support::is_control(point.value) || support::is_invisible(point.value)) {
      diagnostics_.error(code::k_forbidden_character, scalar.span_of(i, i + 1),
                         fmt::format("an escape for U+{:04X}, which may not appear in a model file",
                                     static_cast<std::uint32_t>(point.value)),
                         "delete it; it is not visible in most editors");
    } else {
      kept.text.append(scalar.text, i, point.size);
      for (std::size_t j = i; j < i + point.size; ++j) kept.origin.push_back(scalar.origin[j]);
    }
    i += point.size;
  }
  const bool is_cut = kept.text.size() < scalar.text.size();
  scalar = std::move(kept);
  return is_cut;
}

void TreeBuilder::check_key_length(const LocatedText& key) {
  if (key.text.size() <= k_longest_key) return;
  diagnostics_.error(code::k_file_too_large, {key.span.begin, key.span.begin + 1},
                     fmt::format("a key of {} bytes; the limit is {}", key.text.size(), k_longest_key),
                     "a key is one of the words of the format, or a name");
  throw Stop{};
}

void TreeBuilder::OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                                  YAML::EmitterStyle::value style) {
  refuse_extras(mark, tag, anchor);
  open(mark, NodeKind::sequence, style);
}

void TreeBuilder::OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                             YAML::EmitterStyle::value style) {
  refuse_extras(mark, tag, anchor);
  open(mark, NodeKind::map, style);
}

void TreeBuilder::open(const YAML::Mark& mark, NodeKind kind, YAML::EmitterStyle::value style) {
  const std::uint32_t at = offset(mark);
  count_node({at, at + 1});
  if (open_.size() >= static_cast<std::size_t>(k_deepest_nesting)) {
    diagnostics_.error(code::k_file_too_large, {at, at + 1},
                       fmt::format("lists and maps are nested more than {} deep", k_deepest_nesting),
                       "a model needs five levels at most; check the brackets");
    throw Stop{};
  }
  if (expects_key()) {
    if (report_open_bracket(source_, at, diagnostics_)) throw Stop{};
    diagnostics_.error(code::k_yaml_syntax, {at, at + 1}, "a key must be a single word, not a list or a map",
                       "quote a text that begins with '[' or '{'");
    throw Stop{};
  }
  Open level;
  level.node.kind = kind;
  level.node.span = {at, at + 1};
  level.node.flow = style == YAML::EmitterStyle::Flow;
  open_.push_back(std::move(level));
}

void TreeBuilder::refuse_key(Span span) {
  diagnostics_.error(code::k_yaml_syntax, span, "a key is missing here", "each line of a map reads 'key: value'");
  open_.back().bad_key = true;
}

void TreeBuilder::OnSequenceEnd() {
  if (open_.back().node.flow) rejoin_items(open_.back().node.items);
  close();
}

void TreeBuilder::OnMapEnd() {
  if (open_.back().node.flow) rejoin_entries(open_.back().node.entries);
  drop_repeated_keys(open_.back().node.entries);
  close();
}

namespace {

void add_missing(std::vector<Entry>& sections, Entry repeated) {
  const auto first = std::find_if(sections.begin(), sections.end(),
                                  [&](const Entry& section) { return section.key.text == repeated.key.text; });
  if (first->value.kind != NodeKind::map || repeated.value.kind != NodeKind::map) return;
  for (Entry& entry : repeated.value.entries) {
    if (find(first->value, entry.key.text) == nullptr) first->value.entries.push_back(std::move(entry));
  }
}

}  // namespace

void TreeBuilder::drop_repeated_keys(std::vector<Entry>& entries) {
  std::map<std::string, Span> first;
  std::vector<Entry> kept;
  for (Entry& entry : entries) {
    const auto [place, is_new] = first.emplace(entry.key.text, entry.key.span);
    if (is_new) {
      kept.push_back(std::move(entry));
    } else {
      diagnostics_.error(
          code::k_duplicate_key, entry.key.span,
          fmt::format("the key '{}' is already in line {}", entry.key.text, source_.line(place->second.begin)),
          "remove one of the two or rename it");
      // What a second section declares is there: it is not unknown in what follows.
      if (open_.size() == 1) add_missing(kept, std::move(entry));
    }
  }
  entries = std::move(kept);
}

void TreeBuilder::close() {
  Node node = std::move(open_.back().node);
  open_.pop_back();
  if (!node.items.empty()) node.span.end = node.items.back().span.end;
  if (!node.entries.empty())
    node.span.end = std::max(node.entries.back().value.span.end, node.entries.back().key.span.end);
  add(std::move(node));
}

void TreeBuilder::add(Node node) {
  if (open_.empty()) {
    root_ = std::move(node);
    return;
  }
  Open& parent = open_.back();
  if (parent.node.kind == NodeKind::sequence) {
    parent.node.items.push_back(std::move(node));
  } else if (parent.bad_key) {
    parent.bad_key = false;
  } else {
    // YAML reports an empty value where it goes on, which may be another line.
    if (node.kind == NodeKind::empty) node.span = parent.key->span;
    parent.node.entries.push_back({std::move(*parent.key), std::move(node)});
    parent.key.reset();
  }
}

}  // namespace gaussgen::spec
