// joints: a frame carried by another, with the coordinates of the motion between them. A coordinate that the model does not
// declare is declared here.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/ast_build.hpp"
#include "model/attitude.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/frames.hpp"
#include "model/names.hpp"
#include "model/orientation_fields.hpp"
#include "model/sections.hpp"
#include "model/unit_names.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

struct Freedom {
  const char* suffix;  ///< of the coordinate's name after that of the joint
  bool is_turn;
};

struct Kind {
  const char* name;
  JointType type;
  std::vector<Freedom> freedoms;
  bool has_quaternion = false;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> k_kinds{
      {"revolute", JointType::revolute, {{"", true}}},
      {"prismatic", JointType::prismatic, {{"", false}}},
      {"cylindrical", JointType::cylindrical, {{"_shift", false}, {"_angle", true}}},
      {"universal", JointType::universal, {{"_1", true}, {"_2", true}}},
      {"spherical", JointType::spherical, {}, true},
      {"planar", JointType::planar, {{"_1", false}, {"_2", false}, {"_angle", true}}},
      {"free", JointType::free, {{"_x", false}, {"_y", false}, {"_z", false}}, true},
      {"fixed", JointType::fixed, {}}};
  return k_kinds;
}

constexpr const char* k_attitude_starts =
    "an attitude has its 'initial' under 'orientations', and 'orientation' names it here";

using Axis = std::variant<char, std::array<Ast, 3>>;

std::size_t index_of(char letter) { return static_cast<std::size_t>(letter - 'x'); }

class JointReader {
 public:
  JointReader(const Entry& entry, Reading& reading)
      : entry_(entry), map_(entry.value), name_(name_of(entry.key)), reading_(reading) {}

  void run() {
    check_name(name_, reading_);
    check_unique();
    where_ = fmt::format("joint '{}'", name_.text);
    if (!expect_map(map_, name_.span, where_, reading_)) {
      reading_.unread.add(entry_);
      note_unknown_child();
      return;
    }
    if (!find_kind()) return add_unknown_kind();
    check_joint_keys();
    frame_.position = vector_field(map_, "at", reading_);
    read_axes();
    read_coordinates();
    read_attitude_of_child();
    finish();
  }

 private:
  void check_unique() {
    for (const Joint& other : reading_.model.joints) {
      if (other.name.text != name_.text) continue;
      reading_.diagnostics.error(
          code::k_name_clash, name_.span,
          fmt::format("'{}' already names the joint in {}", name_.text, reading_.line_text(other.name.span)),
          "rename one of them");
    }
  }

  bool find_kind() {
    const Node* given = spec::find(map_, "type");
    for (const Kind& kind : kinds()) {
      if (given != nullptr && given->kind == NodeKind::scalar && given->scalar.text == kind.name) kind_ = &kind;
    }
    if (kind_ != nullptr) return true;
    check_keys(map_, where_, format::keys_of(format::joint()), reading_);
    const Node* node = required(map_, "type", name_.span, where_, reading_);
    if (node == nullptr || !expect_scalar(*node, name_.span, "'type'", reading_)) return false;
    const std::string near = support::did_you_mean(node->scalar.text, format::joint_types());
    reading_.diagnostics.error(code::k_unknown_word, node->span,
                               fmt::format("there is no joint of type '{}'", node->scalar.text),
                               near.empty() ? "the types are " + support::joined(format::joint_types()) : near);
    return false;
  }

  /// The child is there, with coordinates of which nothing is known but how their names begin.
  void add_unknown_kind() {
    reading_.unread.add(entry_);
    frame_.position = vector_field(map_, "at", reading_);
    finish();
  }

  void read_axes() {
    axes_ = {Axis{'z'}, Axis{'z'}, Axis{'z'}};
    if (kind_->type == JointType::universal) axes_ = {Axis{'x'}, Axis{'y'}};
    for (const Entry& field : map_.entries) {
      if (field.key.text == "axis") axes_.assign(3, read_axis(field.value, field.key.span, "'axis'", reading_));
      if (field.key.text != "axes" || !expect_list(field.value, field.key.span, "'axes'", reading_) ||
          !expect_length(field.value, 2, "'axes'", reading_, "write two axes, as in [x, y]")) {
        continue;
      }
      for (std::size_t i = 0; i < 2; ++i)
        axes_[i] = read_axis(field.value.items[i], field.key.span, "an axis", reading_);
    }
    if (kind_->type == JointType::planar && !std::holds_alternative<char>(axes_[0])) {
      reading_.diagnostics.error(code::k_unknown_word, spec::find(map_, "axis")->span,
                                 "the axis of a planar joint is x, y or z", "turn a frame, and make it the parent");
      axes_.assign(3, Axis{'z'});
    }
  }

  struct Value {
    const Node* node = nullptr;
    support::Span list;  ///< in which it stands
  };

  /// The entries of a list, or the one value that may stand without brackets; as many as coordinates, null if absent.
  std::vector<Value> values_at(const std::string& key, std::size_t count) {
    std::vector<Value> values(count);
    for (const Entry& field : map_.entries) {
      if (field.key.text != key || count == 0) continue;
      const Node& node = field.value;
      if (count == 1 && node.kind == NodeKind::scalar) {
        values[0] = {&node, node.span};
      } else if (expect_list(node, field.key.span, "'" + key + "'", reading_) &&
                 expect_length(node, count, "'" + key + "'", reading_, hint_for_entries())) {
        for (std::size_t i = 0; i < count; ++i) values[i] = {&node.items[i], node.span};
      } else {
        reading_.unread.add(node);
      }
    }
    return values;
  }

  std::string default_name(const Freedom& freedom) const { return name_.text + freedom.suffix; }

  std::string hint_for_entries() const {
    std::vector<std::string> names;
    for (const Freedom& freedom : kind_->freedoms) names.push_back(default_name(freedom));
    return fmt::format("one for each coordinate, by default called {}{}", support::joined(names),
                       kind_->has_quaternion ? fmt::format("; {}", k_attitude_starts) : "");
  }

  /// What people write for a spherical joint, which has no coordinates.
  void check_joint_keys() {
    std::vector<std::string> allowed = format::keys_beside(format::joint(), "type", kind_->name);
    if (kind_->type == JointType::spherical) {
      for (const char* key : {"coordinates", "initial", "initial_guess", "initial_rate"}) {
        for (const Entry& field : map_.entries) {
          if (field.key.text == key) refuse_of_spherical(field.key);
        }
        allowed.push_back(key);
      }
    }
    check_keys(map_, where_, allowed, reading_);
    if (kind_->type != JointType::spherical && spec::find(map_, "initial") != nullptr) refuse_needless_guess();
  }

  /// Both have an entry for each coordinate.
  void refuse_needless_guess() {
    for (const Entry& field : map_.entries) {
      if (field.key.text != "initial_guess") continue;
      reading_.diagnostics.error(
          code::k_conflicting_keys, field.key.span, "'initial_guess' beside 'initial', which determines every value",
          kind_->freedoms.size() == 1 ? "remove one of the two keys"
                                      : "remove one of the two keys; some of each are written under 'coordinates'");
    }
  }

  void refuse_of_spherical(const spec::LocatedText& key) {
    reading_.diagnostics.error(code::k_unknown_key, key.span,
                               fmt::format("{} is spherical and has no key '{}'", where_, key.text),
                               std::string("it has a quaternion in place of coordinates; ") + k_attitude_starts);
  }

  void read_coordinates() {
    const std::size_t count = kind_->freedoms.size();
    const auto names = values_at("coordinates", count);
    const auto initial = values_at("initial", count);
    const auto guesses = values_at("initial_guess", count);
    const auto rates = values_at("initial_rate", count);
    const std::size_t declared = reading_.model.coordinates.size();
    for (std::size_t i = 0; i < count; ++i) {
      Name name{default_name(kind_->freedoms[i]), name_.span};
      if (names[i].node != nullptr && expect_scalar(*names[i].node, names[i].list, "a coordinate", reading_)) {
        name = name_of(names[i].node->scalar);
        if (is_named_before(i, names)) continue;
      }
      add_coordinate(name, i, {initial[i], guesses[i], rates[i]});
      move_along(name, i);
    }
    // Lists of initial values have an entry for each of its coordinates, and none for one that has its own elsewhere.
    if (reading_.model.coordinates.size() != declared + count) return;
    for (std::size_t i = 0; i < count; ++i) reading_.model.coordinates[declared + i].starts_at = name_.text;
  }

  /// One coordinate for two motions of a joint: as of a screw, but with a pitch of a metre for each radian.
  bool is_named_before(std::size_t i, const std::vector<Value>& names) {
    const std::string& text = names[i].node->scalar.text;
    const auto is_same = [&](const Value& other) {
      return other.node != nullptr && other.node->kind == NodeKind::scalar && other.node->scalar.text == text;
    };
    if (std::none_of(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), is_same)) return false;
    reading_.diagnostics.error(code::k_name_clash, names[i].node->span,
                               fmt::format("'{}' names two coordinates of {}", text, where_),
                               "name another one; motions that depend on each other are related by a constraint");
    return true;
  }

  struct Start {
    Value value;
    Value guess;
    Value rate;
  };

  void add_coordinate(const Name& name, std::size_t freedom, const Start& start) {
    const auto known = reading_.model.symbols.find(name.text);
    if (known != reading_.model.symbols.end() && known->second.kind == SymbolKind::coordinate) {
      if (reading_.model.coordinates[known->second.index].is_of_joint)
        return refuse_of_other(name, known->second.index);
      reading_.along_joints.insert(name.span.begin);
      for (const Value& value : {start.value, start.guess, start.rate}) {
        if (value.node == nullptr) continue;
        const Coordinate& coordinate = reading_.model.coordinates[known->second.index];
        reading_.diagnostics.error(
            code::k_conflicting_keys, value.node->span,
            fmt::format("the coordinate '{}' is declared in {}", name.text, reading_.line_text(coordinate.name.span)),
            coordinate.held_at
                ? "what is held takes none: declare the others under 'coordinates', with theirs"
                : "write its initial values there, and declare those of this joint there that have some");
      }
      return;
    }
    Coordinate coordinate;
    coordinate.name = name;
    coordinate.unit = kind_->freedoms[freedom].is_turn ? "rad" : "m";
    coordinate.dimension = find_unit(coordinate.unit)->dimension;
    coordinate.is_of_joint = true;
    coordinate.about = "of joint " + name_.text;
    const auto value = [&](const Value& given) {
      return given.node == nullptr ? std::optional<Ast>() : read_expression(*given.node, given.list, reading_);
    };
    coordinate.initial = value(start.value);
    coordinate.guess = value(start.guess);
    coordinate.initial_rate = value(start.rate);
    declare(name, SymbolKind::coordinate, reading_.model.coordinates.size(), "the coordinate", reading_);
    reading_.model.coordinates.push_back(std::move(coordinate));
  }

  /// Two joints that move as one, without a word about it.
  void refuse_of_other(const Name& name, std::size_t coordinate) {
    const Coordinate& other = reading_.model.coordinates[coordinate];
    reading_.refused.insert(name.text);
    reading_.diagnostics.error(
        code::k_name_clash, name.span,
        fmt::format("'{}' is a coordinate of the joint in {}", name.text, reading_.line_text(other.name.span)),
        "give this joint another name, or other 'coordinates'; what several joints share is "
        "declared under 'coordinates'");
  }

  void move_along(const Name& name, std::size_t freedom) {
    const Ast value = symbol_of(name.text, name.span);
    if (kind_->freedoms[freedom].is_turn) {
      turns_.push_back({axes_[std::min(freedom, axes_.size() - 1)], value});
    } else if (kind_->type == JointType::free) {
      shift(freedom, value);
    } else if (kind_->type == JointType::planar) {
      // The two axes in the plane follow its normal in cyclic order.
      shift((index_of(std::get<char>(axes_[0])) + 1 + freedom) % 3, value);
    } else if (const char* letter = std::get_if<char>(&axes_[0])) {
      shift(index_of(*letter), value);
    } else {
      shift_along(std::get<std::array<Ast, 3>>(axes_[0]), value);
    }
  }

  void shift(std::size_t axis, const Ast& value) {
    Ast& at = frame_.position[axis];
    const bool starts_at_origin = at.kind == AstKind::number && cln::zerop(at.number);
    at = starts_at_origin ? value : sum_of(at, value);
  }

  /// value n/|n|
  void shift_along(const std::array<Ast, 3>& direction, const Ast& value) {
    const Ast square = sum_of(sum_of(square_of(direction[0]), square_of(direction[1])), square_of(direction[2]));
    const Ast size = call_of("sqrt", square);
    for (std::size_t i = 0; i < 3; ++i) {
      shift(i, product_of(product_of(value, direction[i]), node_of(AstKind::reciprocal, size.span, {size})));
    }
  }

  void read_attitude_of_child() {
    if (!turns_.empty()) frame_.attitude = std::move(turns_);
    for (const Entry& field : map_.entries) {
      if (field.key.text != "orientation") continue;
      if (kind_->type == JointType::fixed) {
        frame_.attitude = read_attitude(field, reading_);
      } else if (kind_->has_quaternion && expect_scalar(field.value, field.key.span, "'orientation'", reading_)) {
        frame_.attitude = find_orientation(field.value, reading_);
        refuse_second_start(field.value.scalar.text);
      }
    }
    if (kind_->has_quaternion && std::holds_alternative<std::monostate>(frame_.attitude)) {
      frame_.attitude = QuaternionOrientation{add_orientation(name_, map_, reading_)};
    }
  }

  void refuse_second_start(const std::string& orientation) {
    for (const Entry& field : map_.entries) {
      if (field.key.text != "initial_angular_velocity") continue;
      reading_.diagnostics.error(code::k_conflicting_keys, field.key.span,
                                 fmt::format("the orientation '{}' has initial values of its own", orientation),
                                 "write it under 'orientations'");
    }
  }

  void finish() {
    Joint joint{name_, text_field(map_, "about", reading_), kind_ == nullptr ? JointType::fixed : kind_->type, 0};
    const Node* child = required(map_, "child", name_.span, where_, reading_);
    if (child == nullptr || !expect_scalar(*child, name_.span, "'child'", reading_)) {
      note_unknown_child();
      return;
    }
    frame_.name = name_of(child->scalar);
    frame_.about = "carried by joint " + name_.text;
    joint.frame = add_frame(std::move(frame_), parent_field(map_, "parent", reading_), k_child, reading_);
    reading_.model.joints.push_back(std::move(joint));
  }

  /// It may have any name, in the file of the joint.
  void note_unknown_child() {
    reading_.unread.add_any_frame(reading_.copies.prefix_of(name_.text, name_.span.begin, reading_.source));
  }

  const Entry& entry_;
  const Node& map_;
  Name name_;
  Reading& reading_;
  std::string where_;
  const Kind* kind_ = nullptr;
  Frame frame_;
  std::vector<Axis> axes_;
  Turns turns_;
};

}  // namespace

void read_joints(const Node& root, Reading& reading) {
  read_section(root, "joints", reading, [&](const Entry& entry) { JointReader(entry, reading).run(); });
}

}  // namespace gaussgen::model
