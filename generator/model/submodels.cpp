#include "model/submodels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "model/effects.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/names.hpp"
#include "model/renaming.hpp"
#include "model/repetition.hpp"
#include "model/sections.hpp"
#include "spec/reader.hpp"
#include "spec/text_check.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

constexpr const char* k_submodels = "submodels";
constexpr std::size_t k_most_files = 64;
constexpr std::size_t k_deepest = 8;
constexpr std::size_t k_most_nodes = spec::k_most_nodes;
constexpr std::size_t k_most_bytes = spec::k_most_written_out;

std::vector<std::string> names_in(const Node* section) {
  std::vector<std::string> names;
  if (section == nullptr) return names;
  for (const Entry& entry : section->entries) names.push_back(entry.key.text);
  return names;
}

/// A path in a file is relative to that file.
std::string beside(const std::string& file, const std::string& path) {
  const std::size_t slash = file.find_last_of('/');
  return path.empty() || path.front() == '/' || slash == std::string::npos ? path : file.substr(0, slash + 1) + path;
}

Node scalar_of(const spec::LocatedText& text) {
  Node node;
  node.kind = NodeKind::scalar;
  node.span = text.span;
  node.scalar = text;
  return node;
}

/// What a file brings.
struct Part {
  Node root;
  Unread unread = {};                   ///< what could not be read
  Copies copies = {};                   ///< of its files
  std::vector<LeftOut> left_out = {};   ///< of its parts
  std::set<std::uint32_t> fields = {};  ///< where the names of fields in its parts stand that are reported
};

class Submodels {
 public:
  Submodels(support::Source& source, Reading& reading) : source_(source), reading_(reading) {}

  /// `file` is the name of the file in which `root` stands.
  Node assembled(Node root, const std::string& file, const ChoiceOfEffects& effects) {
    // Counts are given for the model itself, and its parts have their own.
    static const GivenCounts k_none;
    std::vector<Effect> of_part;
    root = with_chosen_effects(std::move(root), effects, open_.empty() ? reading_.model.effects : of_part, reading_);
    root = repeated(std::move(root), open_.empty() ? reading_.choices.counts : k_none, reading_);
    Whole result{with_entries_of_effects(std::move(root), reading_), {}};
    auto& entries = result.root.entries;
    const auto section =
        std::find_if(entries.begin(), entries.end(), [](const Entry& e) { return e.key.text == k_submodels; });
    if (section == entries.end()) return std::move(result.root);
    const Node parts = std::move(section->value);
    entries.erase(section);
    if (parts.kind == NodeKind::empty) return std::move(result.root);
    if (!expect_map(parts, parts.span, "'submodels'", reading_)) {
      reading_.unread.add_everything();
      return std::move(result.root);
    }
    for (const Entry& part : parts.entries) take(part, file, result);
    return std::move(result.root);
  }

 private:
  /// Entries of a section by name, as far as it was looked at.
  using Known = std::map<std::string, std::size_t>;

  /// A model to which its submodels come. Each entry of many copies is looked up, and not compared with all others.
  struct Whole {
    Node root;
    std::map<std::string, Known> known;  ///< by section
  };

  void take(const Entry& part, const std::string& file, Whole& model) {
    if (is_full()) return reading_.unread.add_owner(part.key.text);
    const std::string where = fmt::format("submodel '{}'", part.key.text);
    if (check_name(name_of(part.key), reading_) && expect_map(part.value, part.key.span, where, reading_)) {
      check_keys(part.value, where, format::keys_of(format::submodel()), reading_);
      text_field(part.value, "about", reading_);  // for readers of the file
      const Node* path = required(part.value, "file", part.key.span, where, reading_);
      if (path != nullptr && expect_scalar(*path, part.key.span, "'file'", reading_) && has_name(*path)) {
        const std::optional<Part>& content = read(beside(file, path->scalar.text), path->span, effects_of(part, where));
        if (content && has_room(part, content->root, content->copies.count())) {
          reading_.unread.add(content->unread, part.key.text + "_");
          reading_.copies.add(content->copies, part.key.text + "_");
          for (const LeftOut& entry : content->left_out) note_left_out(entry, part.key.text + "_");
          fields_.insert(content->fields.begin(), content->fields.end());
          Node root = content->root;
          fit(part, *content, root);
          if (has_room_for_text(part, root)) return merge(std::move(root), model);
        }
      }
    }
    // What other parts of the model miss may stand in it.
    reading_.unread.add_owner(part.key.text);
  }

  void note_left_out(LeftOut entry, const std::string& prefix) {
    Unread names;
    names.add(entry.names, prefix);
    entry.names = std::move(names);
    reading_.left_out.push_back(std::move(entry));
  }

  bool has_name(const Node& path) {
    if (!path.scalar.text.empty()) return true;
    refuse(path.span, "the name of the file is empty", "write it, as in 'file: leg.yaml'");
    return false;
  }

  bool is_full() const { return nodes_ > k_most_nodes || bytes_ > k_most_bytes; }

  /// Copies of copies are many with a few lines, also where there is next to nothing in them.
  bool has_room(const Entry& part, const Node& content, std::size_t copies) {
    nodes_ += spec::size_of(content) + copies;
    return nodes_ <= k_most_nodes || too_large(part, fmt::format("{} values", k_most_nodes));
  }

  /// Names have grown.
  bool has_room_for_text(const Entry& part, const Node& content) {
    bytes_ += spec::bytes_of(content);
    return bytes_ <= k_most_bytes || too_large(part, fmt::format("{} bytes of text", k_most_bytes));
  }

  bool too_large(const Entry& part, const std::string& limit) {
    reading_.diagnostics.error(code::k_file_too_large, part.key.span,
                               fmt::format("with its submodels, the model has more than {}", limit),
                               "take fewer of them");
    return false;
  }

  const std::optional<Part>& refuse(support::Span at, std::string message, std::string hint) {
    reading_.diagnostics.error(code::k_submodel_file, at, std::move(message), std::move(hint));
    return nothing_;
  }

  /// Of those that its file has.
  ChoiceOfEffects effects_of(const Entry& part, const std::string& where) {
    ChoiceOfEffects choice;
    const Node* const words = spec::find(part.value, "effects");
    if (words == nullptr) return choice;
    const std::vector<Node> all = words->kind == NodeKind::scalar ? std::vector<Node>{*words} : words->items;
    if (words->kind != NodeKind::scalar) expect_list(*words, part.key.span, "'effects' of " + where, reading_);
    for (const Node& word : all) {
      if (!expect_scalar(word, words->span, "an effect", reading_)) continue;
      choice.words.push_back(word.scalar.text);
      choice.places.push_back(word.span);
    }
    return choice;
  }

  /// The file with its own repetitions and submodels written out; made once for each choice of its effects, however often it is
  /// taken.
  const std::optional<Part>& read(const std::string& path, support::Span at, const ChoiceOfEffects& effects) {
    if (std::find(open_.begin(), open_.end(), path) != open_.end() || path == source_.name())
      return refuse(at, fmt::format("'{}' is a submodel of itself", path),
                    "take the common part into a file of its own");
    const std::pair key{path, effects.words};
    if (const auto known = parts_.find(key); known != parts_.end()) return known->second;
    if (open_.size() >= k_deepest || files_.size() >= k_most_files || parts_.size() >= k_most_files)
      return refuse(at, "too many files", fmt::format("{} files, {} deep, are the limit", k_most_files, k_deepest));
    open_.push_back(path);
    std::optional<Part> content = read_new(path, at, effects);
    open_.pop_back();
    return parts_[key] = std::move(content);
  }

  /// As it stands there.
  const std::optional<Node>& text_of(const std::string& path, support::Span at) {
    if (const auto known = files_.find(path); known != files_.end()) return known->second;
    return files_[path] = read_text(path, at);
  }

  std::optional<Node> read_text(const std::string& path, support::Span at) {
    std::string why;
    const std::optional<std::string> text = source_.read(path, why);
    if (!text) {
      refuse(at, fmt::format("'{}': {}", path, why), "the path is relative to the file that names it");
      return std::nullopt;
    }
    bytes_read_ += text->size();
    if (bytes_read_ > spec::k_largest_file && text->size() < bytes_read_) {
      refuse(at,
             fmt::format("with '{}', the files of submodels have more than {} MiB", path, spec::k_largest_file >> 20U),
             "a mechanism has less text");
      return std::nullopt;
    }
    std::optional<Node> root = spec::read_yaml_behind(source_, path, *text, reading_.diagnostics);
    if (!root || !expect_map(*root, root->span, "a model file", reading_)) return std::nullopt;
    return root;
  }

  std::optional<Part> read_new(const std::string& path, support::Span at, const ChoiceOfEffects& effects) {
    const std::optional<Node>& root = text_of(path, at);
    if (!root) return std::nullopt;
    const support::Span top{root->span.begin, root->span.begin};
    // Its names, and those that it lacks, get the name of the submodel in front.
    Unread unread_around;
    Copies copies_around;
    std::vector<LeftOut> left_out_around;
    std::set<std::uint32_t> fields_around;
    std::swap(left_out_around, reading_.left_out);
    std::swap(unread_around, reading_.unread);
    std::swap(copies_around, reading_.copies);
    std::swap(fields_around, fields_);
    Part part;
    part.root = assembled(*root, path, effects);
    check_keys(part.root, "a model file", format::keys_of(format::model_file()), reading_);
    read_version(part.root, top, reading_);
    drop_unreadable_sections(part.root);
    part.copies.add(top.begin - source_.offset_in_file(top.begin), "");
    part.copies.add(reading_.copies, "");
    std::swap(left_out_around, reading_.left_out);
    std::swap(unread_around, reading_.unread);
    std::swap(copies_around, reading_.copies);
    std::swap(fields_around, fields_);
    part.unread = std::move(unread_around);
    part.left_out = std::move(left_out_around);
    part.fields = std::move(fields_around);
    return part;
  }

  /// Names, parameters and place of the part as the model around it wants them; as far as it fits, after a report.
  void fit(const Entry& part, const Part& of, Node& content) {
    drop_header(content);
    const bool is_left_out = leave_out(part, content);
    // Before values of the model around come in, whose names stay.
    const Node* on = spec::find(part.value, "on");
    if (on != nullptr && !expect_scalar(*on, part.key.span, "'on'", reading_)) on = nullptr;
    if (on != nullptr) check_place(part, content);
    check_fields(part, content, of.fields, is_left_out);
    check_parameters(part, content);
    prefix_names(content, part.key.text + "_");
    set_parameters(part, content);
    if (on != nullptr) mount(content, on->scalar);
  }

  /// Sections that are no maps, after a report: nothing of them can be added to those of the model around.
  void drop_unreadable_sections(Node& content) {
    const auto is_unreadable = [this](const Entry& entry) {
      if (is_header(entry) || entry.value.kind == NodeKind::empty) return false;
      if (expect_map(entry.value, entry.key.span, "'" + entry.key.text + "'", reading_)) return false;
      note_unread_section(entry, reading_);
      return true;
    };
    std::vector<Entry> kept;
    for (Entry& entry : content.entries) {
      if (!is_unreadable(entry)) kept.push_back(std::move(entry));
    }
    content.entries = std::move(kept);
  }

  bool is_header(const Entry& entry) const {
    static const std::vector<std::string> k_header{"gauss", "name",           "about",   "elimination",
                                                   "exact", "rank_tolerance", "outputs", "sensitivities"};
    return std::find(k_header.begin(), k_header.end(), entry.key.text) != k_header.end() ||
           reading_.unknown_keys.count(entry.key.span.begin) > 0;
  }

  /// With the keys that are unknown, which are reported.
  void drop_header(Node& content) const {
    auto& entries = content.entries;
    entries.erase(
        std::remove_if(entries.begin(), entries.end(), [this](const Entry& entry) { return is_header(entry); }),
        entries.end());
  }

  /// False where it is not known what is meant, after a report.
  bool leave_out(const Entry& part, Node& content) {
    const Node* names = spec::find(part.value, "without");
    if (names == nullptr) return !has_misspelt(part.value, "without", reading_);
    if (!expect_list(*names, part.key.span, "'without'", reading_)) return false;
    bool is_known = true;
    std::set<std::string> seen;
    for (const Node& name : names->items) {
      const bool is_word = expect_scalar(name, names->span, "what is left out", reading_);
      if (is_word && !seen.insert(name.scalar.text).second) {
        refuse_twice(name);
        continue;
      }
      const bool is_found = is_word && leave_out(name.scalar.text, part.key.text, content);
      const bool is_slip = is_word && !is_found && refuse_left_out(part, name, content);
      is_known = is_known && is_word && !is_slip;
    }
    return is_known;
  }

  void refuse_twice(const Node& name) {
    reading_.diagnostics.error(code::k_submodel_fit, name.span, fmt::format("'{}' is left out twice", name.scalar.text),
                               "remove one of the two");
  }

  /// Whether it looks like an entry that is there.
  bool refuse_left_out(const Entry& part, const Node& name, const Node& content) {
    const std::string near = near_entry(name.scalar.text, content);
    reading_.diagnostics.error(code::k_submodel_fit, name.span,
                               fmt::format("submodel '{}' has no entry '{}'", part.key.text, name.scalar.text),
                               near.empty() ? "'without' names entries of its sections, such as a force" : near);
    return !near.empty();
  }

  std::string near_entry(const std::string& name, const Node& content) {
    if (reading_.searches.are_spent()) return "";
    std::vector<std::string> entries;
    for (const Entry& section : content.entries) {
      for (const std::string& entry : names_in(&section.value)) entries.push_back(entry);
    }
    if (!reading_.searches.begin(entries.size())) return "";
    const std::string near = support::closest_or_begun(name, entries);
    return near.empty() ? near : fmt::format("did you mean '{}'?", near);
  }

  bool leave_out(const std::string& name, const std::string& submodel, Node& content) {
    bool is_found = false;
    for (Entry& section : content.entries) {
      auto& entries = section.value.entries;
      const auto found =
          std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key.text == name; });
      if (found == entries.end()) continue;
      is_found = true;
      LeftOut left{section.key.text, name, submodel, {}, {}};
      left.names.add(*found);
      if (declares(section.key.text)) note_left_out(std::move(left), submodel + "_");
      entries.erase(found);
    }
    return is_found;
  }

  /// A field acts on every mass of the model, and the model around has its own gravity. That of a part of the part is
  /// left out there, and after a slip in what is left out it is not known whether this one is.
  void check_fields(const Entry& part, const Node& content, const std::set<std::uint32_t>& reported, bool is_meant) {
    const Node* forces = spec::find(content, "forces");
    if (forces == nullptr) return;
    for (const Entry& force : forces->entries) {
      if (force.value.kind != NodeKind::map || spec::find(force.value, "uniform") == nullptr) continue;
      if (reported.count(force.key.span.begin) > 0) continue;
      fields_.insert(force.key.span.begin);
      if (!is_meant) continue;
      reading_.diagnostics.error(
          code::k_submodel_fit, part.key.span,
          fmt::format("'{}' of submodel '{}' would act on every mass of the model", force.key.text, part.key.text),
          fmt::format("add 'without: [{}]', and let the model have its own", force.key.text));
    }
  }

  /// Bodies with a position of their own cannot be put on a frame.
  void check_place(const Entry& part, const Node& content) {
    for (const char* section : {"bodies", "particles"}) {
      const Node* bodies = spec::find(content, section);
      if (bodies == nullptr) continue;
      for (const Entry& body : bodies->entries) {
        if (body.value.kind != NodeKind::map || spec::find(body.value, "position") == nullptr) continue;
        reading_.diagnostics.error(
            code::k_submodel_fit, part.key.span,
            fmt::format("'{}' of submodel '{}' has its position in space, so nothing can carry it", body.key.text,
                        part.key.text),
            "place it on a frame or a joint there, or leave 'on' out");
      }
    }
  }

  void check_parameters(const Entry& part, const Node& content) {
    const Node* values = spec::find(part.value, "parameters");
    if (values == nullptr || !expect_map(*values, part.key.span, "'parameters'", reading_)) return;
    const std::vector<std::string> known = names_in(spec::find(content, "parameters"));
    for (const Entry& value : values->entries) {
      if (std::find(known.begin(), known.end(), value.key.text) != known.end()) continue;
      const std::string near =
          reading_.searches.begin(known.size()) ? support::did_you_mean(value.key.text, known) : "";
      reading_.diagnostics.error(code::k_submodel_fit, value.key.span,
                                 fmt::format("submodel '{}' has no parameter '{}'", part.key.text, value.key.text),
                                 !near.empty()   ? near
                                 : known.empty() ? "it has none"
                                                 : "it has " + support::joined(known));
    }
  }

  void set_parameters(const Entry& part, Node& content) {
    const Node* values = spec::find(part.value, "parameters");
    Node* parameters = spec::find(content, "parameters");
    if (values == nullptr || parameters == nullptr) return;
    for (const Entry& value : values->entries) {
      Node* parameter = spec::find(*parameters, part.key.text + "_" + value.key.text);
      if (parameter == nullptr) continue;
      Node* inner = parameter->kind == NodeKind::map ? spec::find(*parameter, "value") : parameter;
      if (inner != nullptr) *inner = value.value;
    }
  }

  /// What stands in space stands on the frame now.
  static void mount(Node& content, const spec::LocatedText& frame) {
    const std::pair<const char*, const char*> k_sections[] = {
        {"frames", "parent"}, {"joints", "parent"}, {"points", "on"}};
    for (const auto& [section, key] : k_sections) {
      Node* entries = spec::find(content, section);
      if (entries == nullptr) continue;
      for (Entry& entry : entries->entries) {
        if (entry.value.kind == NodeKind::empty) entry.value.kind = NodeKind::map;
        if (entry.value.kind != NodeKind::map) continue;
        Node* parent = spec::find(entry.value, key);
        if (parent == nullptr) {
          spec::LocatedText name = frame;
          name.text = key;
          name.origin.assign(name.text.size(), frame.span.begin);
          entry.value.entries.push_back({std::move(name), scalar_of(frame)});
        } else if (parent->kind == NodeKind::scalar && parent->scalar.text == "space") {
          *parent = scalar_of(frame);
        }
      }
    }
  }

  void merge(Node content, Whole& model) {
    for (Entry& section : content.entries) {
      if (section.value.kind == NodeKind::empty) continue;
      Node* own = spec::find(model.root, section.key.text);
      if (own != nullptr && own->kind == NodeKind::map && section.value.kind == NodeKind::map) {
        Known& known = model.known[section.key.text];
        for (Entry& entry : section.value.entries) add(std::move(entry), *own, known);
      } else if (own == nullptr || own->kind == NodeKind::empty) {
        if (own != nullptr) {
          *own = std::move(section.value);
        } else {
          model.root.entries.push_back(std::move(section));
        }
      }
    }
  }

  void add(Entry entry, Node& section, Known& known) {
    for (std::size_t i = known.size(); i < section.entries.size(); ++i) known.emplace(section.entries[i].key.text, i);
    const auto [place, is_new] = known.emplace(entry.key.text, section.entries.size());
    if (is_new) return section.entries.push_back(std::move(entry));
    const Entry* const same = &section.entries[place->second];
    reading_.diagnostics.error(code::k_name_clash, same->key.span,
                               fmt::format("'{}' is also a name that a submodel brings, of {}", entry.key.text,
                                           reading_.line_text(entry.key.span)),
                               "rename one of the two");
    reading_.unread.add(entry);
  }

  support::Source& source_;
  Reading& reading_;
  std::map<std::string, std::optional<Node>> files_;
  std::map<std::pair<std::string, GivenEffects>, std::optional<Part>> parts_;
  const std::optional<Part> nothing_;
  std::size_t bytes_read_ = 0;      ///< of all files of submodels, each once
  std::size_t nodes_ = 0;           ///< of all that was merged
  std::size_t bytes_ = 0;           ///< likewise
  std::set<std::uint32_t> fields_;  ///< as Part::fields, of the file that is read
  std::vector<std::string> open_;   ///< files that are being read, the outermost first
};

}  // namespace

Node with_submodels(Node root, support::Source& source, Reading& reading) {
  // A copy: the names of a source move when it takes another file.
  const std::string file = source.name();
  return Submodels(source, reading).assembled(std::move(root), file, {reading.choices.effects, {}});
}

}  // namespace gaussgen::model
