// friction, slides: what opposes slip, along given velocities or between two bodies.

#include <fmt/format.h>

#include "model/ast_build.hpp"
#include "model/attitude.hpp"
#include "model/fields.hpp"
#include "model/frames.hpp"
#include "model/read_laws.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

using spec::Entry;
using spec::Node;
using spec::NodeKind;

namespace {

constexpr std::size_t k_most_directions = 2;

void read_sizes(const Entry& force, const std::string& where, Friction& friction, Reading& reading) {
  const bool has_limit = required(force.value, "limit", force.key.span, where, reading) != nullptr;
  friction.limit = has_limit ? *expression_field(force.value, "limit", reading) : broken_expression();
  friction.smooth = expression_field(force.value, "smooth", reading);
  const Node* const at_rest = spec::find(force.value, "static_limit");
  if (friction.smooth && at_rest != nullptr)
    reading.diagnostics.error(support::code::k_conflicting_keys, at_rest->span,
                              fmt::format("{} has 'static_limit' beside 'smooth', which never sticks", where),
                              "leave one of the two out");
}

/// One, or a list of one or two.
std::vector<Node> one_or_two(const Node& node, support::Span owner, const std::string& what, Reading& reading) {
  if (node.kind != NodeKind::sequence) return {node};
  if (!node.items.empty() && node.items.size() <= k_most_directions) return node.items;
  reading.diagnostics.error(support::code::k_wrong_count, node.items.empty() ? owner : node.span,
                            fmt::format("{} has one entry or two, and here are {}", what, node.items.size()),
                            "write those in which it may slip; along the normal nothing slips");
  return {};
}

std::array<Ast, 3> direction_of(const Node& node, support::Span owner, Reading& reading) {
  const auto axis = read_axis(node, owner, "'directions'", reading);
  if (const auto* const vector = std::get_if<std::array<Ast, 3>>(&axis)) return *vector;
  std::array<Ast, 3> unit{number(0), number(0), number(0)};
  unit[static_cast<std::size_t>(std::get<char>(axis) - 'x')] = number(1);
  return unit;
}

}  // namespace

Friction read_friction(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  Friction friction;
  for (const Node& phi : one_or_two(law.value, law.key.span, "'friction'", reading))
    friction.slips.emplace_back(VelocityLaw{read_expression(phi, law.key.span, reading)});
  read_sizes(force, where, friction, reading);
  return friction;
}

Friction read_sliding(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  Friction friction;
  SlipLaw contact = read_contact_of(force.value, force.key.span, law, where, reading);
  if (const Node* in = spec::find(force.value, "in"))
    contact.axes = frame_at(*in, force.key.span, "'in'", reading);
  else
    contact.axes = contact.surface;
  const Node* const directions = required(force.value, "directions", force.key.span, where, reading);
  if (directions != nullptr) {
    for (const Node& one : one_or_two(*directions, force.key.span, "'directions'", reading)) {
      contact.direction = direction_of(one, force.key.span, reading);
      friction.slips.emplace_back(contact);
    }
  }
  read_sizes(force, where, friction, reading);
  return friction;
}

}  // namespace gaussgen::model
