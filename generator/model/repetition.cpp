#include "model/repetition.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <utility>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/indices.hpp"
#include "spec/reader.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

constexpr const char* k_count = "count";
constexpr const char* k_counts = "counts";
constexpr std::int64_t k_most_copies = 10'000;
constexpr std::array k_index_names{"i", "j", "k"};

std::size_t size_of(const Node& node) {
  std::size_t size = 1;
  for (const Node& item : node.items) size += size_of(item);
  for (const Entry& entry : node.entries) size += size_of(entry.value);
  return size;
}

bool is_section(const std::string& key) {
  for (const format::Key& section : format::model_file().keys) {
    if (section.name == key) return section.value.shape == format::Shape::entries && key != k_counts;
  }
  return false;
}

class Repetition {
 public:
  explicit Repetition(Reading& reading) : reading_(reading) {}

  Node run(const Node& root) {
    read_counts(root);
    Node result = root;
    result.entries.clear();
    for (const Entry& entry : root.entries) {
      if (entry.key.text == k_counts) continue;
      if (is_section(entry.key.text) && entry.value.kind == NodeKind::map) {
        result.entries.push_back({entry.key, section(entry.value)});
      } else {
        result.entries.push_back({entry.key, texts(entry)});
      }
    }
    return result;
  }

 private:
  /// Of what is no section. In a name that is to be refused anyway, a `$` is no index.
  Node texts(const Entry& entry) {
    if (entry.key.text != "name" || entry.value.kind != NodeKind::scalar)
      return with_indices(entry.value, counts_, reading_.diagnostics);
    Node name = entry.value;
    name.scalar = with_indices(name.scalar, counts_, UnknownIndex::keep, reading_.diagnostics);
    return name;
  }

  void read_counts(const Node& root) {
    read_section(root, k_counts, reading_, [&](const Entry& entry) {
      const bool is_index = entry.key.text == "i" || entry.key.text == "j" || entry.key.text == "k";
      if (is_index || !is_word(entry.key.text)) {
        reading_.diagnostics.error(code::k_invalid_name, entry.key.span,
                                   fmt::format("'{}' cannot be the name of a count", entry.key.text),
                                   is_index ? "$i, $j and $k count the copies of an entry"
                                            : "it has letters and digits only, and begins with a letter");
        return;
      }
      if (const auto count = read_count(entry.value, entry.key.span)) counts_[entry.key.text] = *count;
    });
  }

  static bool is_word(const std::string& text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    for (const char c : text) {
      if (!is_letter(c) && (c < '0' || c > '9')) return false;
    }
    return !text.empty() && is_letter(text.front());
  }

  std::optional<std::int64_t> read_count(const Node& node, support::Span owner) {
    if (!expect_scalar(node, owner, "a count", reading_)) return std::nullopt;
    const std::optional<std::int64_t> value = whole_number(
        with_indices(node.scalar, counts_, UnknownIndex::error, reading_.diagnostics), counts_, reading_.diagnostics);
    if (value && *value >= 0 && *value <= k_most_copies) return value;
    if (value)
      reading_.diagnostics.error(code::k_index, node.span, fmt::format("a count of {}", *value),
                                 fmt::format("counts are whole numbers from 0 to {}", k_most_copies));
    return std::nullopt;
  }

  Node section(const Node& section) {
    Node result = section;
    result.entries.clear();
    names_.clear();
    for (const Entry& entry : section.entries) {
      const Node* count = entry.value.kind == NodeKind::map ? spec::find(entry.value, k_count) : nullptr;
      const bool is_whole = count == nullptr ? add(entry, counts_, result) : copy(entry, *count, result);
      // What other parts of the model miss may be an entry that is left out here.
      if (!is_whole) reading_.incomplete = true;
    }
    return result;
  }

  /// One `count` gives $i, a list of them $i, $j, $k.
  bool copy(const Entry& entry, const Node& count, Node& section) {
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
    Entry pattern = entry;
    auto& fields = pattern.value.entries;
    for (auto field = fields.begin(); field != fields.end();)
      field = field->key.text == k_count ? fields.erase(field) : field + 1;
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
  bool add(const Entry& pattern, const Indices& indices, Node& section) {
    nodes_ += size_of(pattern.value);
    if (nodes_ > static_cast<std::size_t>(spec::k_most_nodes)) {
      reading_.diagnostics.error(code::k_file_too_large, pattern.key.span,
                                 fmt::format("written out, the model has more than {} values", spec::k_most_nodes),
                                 "make fewer copies");
      return false;
    }
    const std::size_t findings = reading_.diagnostics.all().size();
    Entry entry{with_indices(pattern.key, indices, UnknownIndex::error, reading_.diagnostics),
                with_indices(pattern.value, indices, reading_.diagnostics)};
    // What is wrong with one copy is wrong with all.
    if (reading_.diagnostics.all().size() != findings) return false;
    if (!names_.insert(entry.key.text).second) {
      reading_.diagnostics.error(code::k_duplicate_key, pattern.key.span,
                                 fmt::format("'{}' is there already", entry.key.text),
                                 "what 'count' repeats has the index in its name, as in link_$i");
      return false;
    }
    section.entries.push_back(std::move(entry));
    return true;
  }

  Reading& reading_;
  Indices counts_;
  std::set<std::string> names_;  ///< in the section that is being written
  std::size_t nodes_ = 0;
};

}  // namespace

spec::Node repeated(const Node& root, Reading& reading) { return Repetition(reading).run(root); }

}  // namespace gaussgen::model
