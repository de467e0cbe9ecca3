#include "model/repetition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/indices.hpp"
#include "spec/reader.hpp"
#include "support/characters.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

constexpr const char* k_count = "count";
constexpr const char* k_counts = "counts";

using format::k_most_copies;
constexpr std::array k_index_names{"i", "j", "k"};

bool is_section(const std::string& key) {
  for (const format::Key& section : format::model_file().keys) {
    if (section.name == key) return section.value.shape == format::Shape::entries && key != k_counts;
  }
  return false;
}

bool is_known(const std::string& key) {
  const std::vector<std::string> keys = format::keys_of(format::model_file());
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// The entry of this name; else one with a slip in it, which is reported later: its value is the one that is meant.
const Entry* meant_by(const std::string& key, const Node& map) {
  const Entry* near = nullptr;
  for (const Entry& entry : map.entries) {
    if (entry.key.text == key) return &entry;
    if (!is_known(entry.key.text) && support::closest(entry.key.text, {key}) == key) near = &entry;
  }
  return near;
}

/// Of the entries of a section.
std::vector<std::string> keys_in(const std::string& section) {
  for (const format::Key& key : format::model_file().keys) {
    if (key.name != section) continue;
    const format::Value& entry = *key.value.item;
    for (const format::Value& other : entry.others) {
      if (other.map != nullptr) return format::keys_of(*other.map);
    }
    return entry.map == nullptr ? std::vector<std::string>{} : format::keys_of(*entry.map);
  }
  return {};
}

/// bodies: body
std::string one_of(const std::string& section) {
  constexpr std::string_view k_plural = "ies";
  const std::size_t stem = section.size() - std::min(section.size(), k_plural.size());
  return section.substr(stem) == k_plural ? section.substr(0, stem) + "y" : section.substr(0, section.size() - 1);
}

class Repetition {
 public:
  Repetition(const GivenCounts& given, Reading& reading) : given_(given), reading_(reading) {}

  Node run(Node root) {
    read_counts(root);
    for (Entry& entry : taken_from(root)) {
      if (entry.key.text == k_counts) continue;
      entry.value = written_out(entry.key.text, std::move(entry.value));
      root.entries.push_back(std::move(entry));
    }
    return root;
  }

 private:
  Node written_out(const std::string& key, Node value) {
    if (value.kind == NodeKind::map && key == format::k_effects) return effects(std::move(value));
    if (value.kind == NodeKind::map && is_section(key)) return section(key, std::move(value));
    return texts(key, std::move(value));
  }

  /// Each has sections as the file has them.
  Node effects(Node all) {
    for (Entry& effect : all.entries) {
      for (Entry& part : effect.value.entries) part.value = written_out(part.key.text, std::move(part.value));
    }
    return all;
  }

  /// Of what is no section. In a text, and in a name that is to be refused anyway, a `$` is no index.
  Node texts(const std::string& key, Node value) {
    if (!is_known(key)) return value;  // it is reported, and `$i` in it may have been right
    if ((key != "name" && key != "about") || value.kind != NodeKind::scalar)
      return with_indices(std::move(value), counts_, reading_.diagnostics);
    value.scalar = with_indices(value.scalar, counts_, UnknownIndex::keep, reading_.diagnostics);
    return value;
  }

  static std::vector<Entry> taken_from(Node& map) {
    std::vector<Entry> entries;
    entries.swap(map.entries);
    return entries;
  }

  void read_counts(const Node& root) {
    const Entry* const counts = meant_by(k_counts, root);
    check_given(counts);
    if (counts == nullptr) return;
    read_section(root, counts->key.text, reading_, [&](const Entry& entry) {
      const bool is_index =
          std::find(k_index_names.begin(), k_index_names.end(), entry.key.text) != k_index_names.end();
      if (is_index || !is_word(entry.key.text)) {
        reading_.diagnostics.error(code::k_invalid_name, entry.key.span,
                                   fmt::format("'{}' cannot be the name of a count", entry.key.text),
                                   is_index ? "$i, $j and $k count the copies of an entry"
                                            : "it has letters and digits only, and begins with a letter");
      }
      // One that is refused is known all the same: what uses it has no fault of its own.
      const auto given = given_.find(entry.key.text);
      const std::optional<std::int64_t> count =
          given == given_.end() ? read_count(entry.value, entry.key.span) : given->second;
      counts_[entry.key.text] = count.value_or(1);
      // How many names it makes is open.
      if (!count) reading_.unread.add_everything();
    });
  }

  void check_given(const Entry* counts) const {
    std::vector<std::string> known;
    if (counts != nullptr) {
      for (const Entry& entry : counts->value.entries) known.push_back(entry.key.text);
    }
    for (const auto& [name, count] : given_) {
      if (std::find(known.begin(), known.end(), name) == known.end()) throw UnknownCount(name, known);
    }
  }

  static bool is_word(const std::string& text) {
    const auto belongs = [](char c) { return support::is_letter(c) || support::is_digit(c); };
    return !text.empty() && support::is_letter(text.front()) && std::all_of(text.begin(), text.end(), belongs);
  }

  std::optional<std::int64_t> read_count(const Node& node, support::Span owner) {
    if (!expect_scalar(node, owner, "a count", reading_)) return std::nullopt;
    const std::size_t findings = reading_.diagnostics.all().size();
    const spec::LocatedText text = with_indices(node.scalar, counts_, UnknownIndex::error, reading_.diagnostics);
    if (reading_.diagnostics.all().size() != findings) return std::nullopt;
    const std::optional<std::int64_t> value = whole_number(text, counts_, reading_.diagnostics);
    if (value && *value >= 0 && *value <= k_most_copies) return value;
    if (value)
      reading_.diagnostics.error(code::k_index, node.span, fmt::format("a count of {}", *value),
                                 fmt::format("counts are whole numbers from 0 to {}", k_most_copies));
    return std::nullopt;
  }

  Node section(const std::string& name, Node section) {
    names_.clear();
    for (Entry& entry : taken_from(section)) {
      const Entry* count = entry.value.kind == NodeKind::map ? meant_by(k_count, entry.value) : nullptr;
      is_slip_ = count != nullptr && count->key.text != k_count;
      if (is_slip_) refuse_slip(name, entry, count->key);
      const bool is_whole = count == nullptr ? add(entry, counts_, section) : copy(entry, *count, section);
      if (!is_whole) reading_.unread.add(entry);
    }
    return section;
  }

  /// Here, where the name of the entry is as it is written; the copies go without the key.
  void refuse_slip(const std::string& section, const Entry& entry, const spec::LocatedText& key) {
    reading_.diagnostics.error(
        code::k_unknown_key, key.span,
        fmt::format("{} '{}' has no key '{}'", one_of(section), entry.key.text, key.text),
        fmt::format("did you mean '{}'? allowed here: {}", k_count, support::joined(keys_in(section))));
    reading_.unknown_keys.insert(key.span.begin);
  }

  /// One `count` gives $i, a list of them $i, $j, $k.
  bool copy(const Entry& entry, const Entry& given, Node& section) {
    const Node& count = given.value;
    std::vector<std::int64_t> limits;
    const std::vector<Node> counts = count.kind == NodeKind::sequence ? count.items : std::vector<Node>{count};
    if (counts.empty() || counts.size() > k_index_names.size()) {
      reading_.diagnostics.error(code::k_index, count.span, "an entry is repeated along one, two or three indices",
                                 "write 'count: 3', or 'count: [3, 4]' for $i and $j");
      return false;
    }
    std::int64_t copies = 1;
    for (const Node& item : counts) {
      const auto limit = read_count(item, count.span);
      if (!limit) return false;
      limits.push_back(*limit);
      copies *= *limit;
      if (copies > k_most_copies) return too_many(entry);
    }
    if (copies == 0) reading_.model.leaves_out = true;
    Entry pattern = entry;
    auto& fields = pattern.value.entries;
    for (auto field = fields.begin(); field != fields.end();)
      field = field->key.text == given.key.text ? fields.erase(field) : field + 1;
    for (std::int64_t copy = 0; copy < copies; ++copy) {
      Indices indices = counts_;
      std::int64_t rest = copy;
      for (std::size_t i = limits.size(); i-- > 0; rest /= limits[i]) indices[k_index_names[i]] = rest % limits[i] + 1;
      if (!add(pattern, indices, section)) return false;
    }
    return true;
  }

  bool too_many(const Entry& entry) {
    reading_.diagnostics.error(code::k_file_too_large, entry.key.span,
                               fmt::format("more than {} copies", k_most_copies), "no model needs so many");
    return false;
  }

  /// False when going on makes no sense.
  bool add(Entry entry, const Indices& indices, Node& section) {
    const support::Span place = entry.key.span;
    nodes_ += spec::size_of(entry.value);
    if (nodes_ > static_cast<std::size_t>(spec::k_most_nodes)) {
      reading_.diagnostics.error(code::k_file_too_large, place,
                                 fmt::format("written out, the model has more than {} values", spec::k_most_nodes),
                                 "make fewer copies");
      return false;
    }
    const std::size_t findings = reading_.diagnostics.all().size();
    entry.key = with_indices(entry.key, indices, UnknownIndex::error, reading_.diagnostics);
    entry.value = with_indices(std::move(entry.value), indices, reading_.diagnostics);
    bytes_ += entry.key.text.size() + spec::bytes_of(entry.value);
    if (bytes_ > spec::k_most_written_out) {
      reading_.diagnostics.error(
          code::k_file_too_large, place,
          fmt::format("written out, the model has more than {} bytes of text", spec::k_most_written_out),
          "make fewer copies");
      return false;
    }
    // What is wrong with one copy is wrong with all.
    if (reading_.diagnostics.all().size() != findings) return false;
    if (!names_.insert(entry.key.text).second) {
      if (!is_slip_) refuse_second(entry.key.text, place);
      return false;
    }
    section.entries.push_back(std::move(entry));
    return true;
  }

  void refuse_second(const std::string& name, support::Span place) {
    reading_.diagnostics.error(code::k_duplicate_key, place, fmt::format("'{}' is there already", name),
                               "what 'count' repeats has the index in its name, as in link_$i");
  }

  const GivenCounts& given_;
  Reading& reading_;
  Indices counts_;
  std::set<std::string> names_;  ///< in the section that is being written
  bool is_slip_ = false;         ///< a key that may be meant as 'count' repeats the entry that is being written
  std::size_t nodes_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace

spec::Node repeated(Node root, const GivenCounts& given, Reading& reading) {
  return Repetition(given, reading).run(std::move(root));
}

}  // namespace gaussgen::model
