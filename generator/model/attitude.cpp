#include "model/attitude.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/ast_build.hpp"
#include "model/fields.hpp"
#include "model/format.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

bool is_euler_sequence(const std::string& text) {
  if (text.size() != 3 || text.find_first_not_of("xyz") != std::string::npos) return false;
  return text[0] != text[1] && text[1] != text[2];
}

Turns turns_of(const std::string& sequence, std::array<Ast, 3> angles) {
  Turns turns;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    turns.push_back({i < sequence.size() ? sequence[i] : 'z', std::move(angles[i])});
  }
  return turns;
}

Turns read_euler(const Node& map, support::Span owner, Reading& reading) {
  const std::string where = "an orientation by Euler angles";
  std::string letters = "zxz";
  std::array<Ast, 3> values;
  values.fill(broken_expression());
  check_keys(map, where, format::keys_of(format::euler_angles()), reading);
  const Node* sequence = required(map, "euler", owner, where, reading);
  bool is_faulty = false;
  if (sequence != nullptr && expect_scalar(*sequence, owner, "'euler'", reading)) {
    const std::string& text = sequence->scalar.text;
    is_faulty = !is_euler_sequence(text);
    if (is_faulty) {
      reading.diagnostics.error(
          code::k_unknown_word, sequence->span, fmt::format("'{}' is not a sequence of axes", text),
          "three letters of x, y, z without equal neighbours, such as zxz or zyx; an angle that is not "
          "needed is 0");
    } else {
      letters = text;
    }
  }
  const Node* angles = required(map, "angles", owner, where, reading);
  // As many angles as letters: that is one mistake.
  const bool is_reported = angles != nullptr && is_faulty && sequence->scalar.text.size() == angles->items.size();
  if (angles != nullptr && !is_reported) values = read_vector(*angles, owner, "'angles'", reading);
  return turns_of(letters, std::move(values));
}

bool is_zero(const Ast& ast) { return ast.kind == AstKind::number && cln::zerop(ast.number); }

Turns read_single_turn(const Node& map, support::Span owner, Reading& reading) {
  const std::string where = "an orientation by one angle";
  check_keys(map, where, format::keys_of(format::single_turn()), reading);
  Turn turn;
  turn.angle = broken_expression();
  const Node* axis = required(map, "axis", owner, where, reading);
  if (axis != nullptr) turn.axis = read_axis(*axis, owner, "'axis'", reading);
  const Node* angle = required(map, "angle", owner, where, reading);
  if (angle != nullptr) turn.angle = read_expression(*angle, owner, reading);
  return {turn};
}

}  // namespace

void refuse_zero_axis(support::Span span, Reading& reading) {
  reading.diagnostics.error(code::k_undefined_value, span, "this vector is zero, so it has no direction",
                            "write x, y or z, or a vector that is not zero, as in [1, 0, 1]");
}

namespace {

/// -x, -y, -z
std::array<Ast, 3> opposite(char axis, support::Span span) {
  std::array<Ast, 3> components;
  for (std::size_t i = 0; i < components.size(); ++i) {
    components[i] = node_of(AstKind::number, span);
    components[i].number = "xyz"[i] == axis ? -1 : 0;
  }
  return components;
}

}  // namespace

std::variant<char, std::array<Ast, 3>> read_axis(const Node& node, support::Span owner, const std::string& where,
                                                 Reading& reading) {
  if (node.kind == NodeKind::sequence) {
    auto axis = read_vector(node, owner, where, reading);
    if (!std::all_of(axis.begin(), axis.end(), is_zero)) return axis;
    refuse_zero_axis(node.span, reading);
    return 'z';
  }
  if (!expect_scalar(node, owner, where, reading)) return 'z';
  const std::string& text = node.scalar.text;
  const auto is_letter = [](char c) { return c == 'x' || c == 'y' || c == 'z'; };
  if (text.size() == 1 && is_letter(text[0])) return text[0];
  if (text.size() == 2 && text[0] == '-' && is_letter(text[1])) return opposite(text[1], node.span);
  reading.diagnostics.error(code::k_unknown_word, node.span, fmt::format("'{}' is not an axis", text),
                            "write x, y, z, -x, -y or -z, or the direction as a list, as in [1, 0, 1]");
  return 'z';
}

QuaternionOrientation find_orientation(const Node& scalar, Reading& reading) {
  const auto found = reading.orientations.find(scalar.scalar.text);
  if (found != reading.orientations.end()) return {found->second};
  if (!reading.unread.may_declare(scalar.scalar.text)) {
    const std::string near = did_you_mean_one_of(
        name_of(scalar.scalar), [&] { return names_of(reading.orientations); }, reading);
    reading.diagnostics.error(
        code::k_wrong_reference, scalar.span, fmt::format("there is no orientation '{}'", scalar.scalar.text),
        near.empty() ? "declare it under 'orientations', or write {euler: zxz, angles: [...]}" : near);
  }
  return {k_no_orientation};
}

Attitude read_attitude(const Entry& entry, Reading& reading) {
  const Node& node = entry.value;
  if (node.kind == NodeKind::map) {
    const bool has_slip = spec::find(node, "euler") != nullptr;  // {euler: zxz, angle: [a, b, c]}
    const bool is_single = spec::find(node, "axis") != nullptr || (spec::find(node, "angle") != nullptr && !has_slip);
    return is_single ? read_single_turn(node, entry.key.span, reading) : read_euler(node, entry.key.span, reading);
  }
  if (node.kind == NodeKind::sequence) {
    reading.diagnostics.error(code::k_wrong_kind, {node.span.begin, node.span.begin + 1},
                              "'orientation' must be a name or a map, and here is a list",
                              "write {euler: zxz, angles: [a, b, c]} or {axis: z, angle: a}; a quaternion is declared "
                              "under 'orientations', and its name stands here");
    return QuaternionOrientation{k_no_orientation};
  }
  if (expect_scalar(node, entry.key.span, "'orientation'", reading)) return find_orientation(node, reading);
  return QuaternionOrientation{k_no_orientation};
}

}  // namespace gaussgen::model
