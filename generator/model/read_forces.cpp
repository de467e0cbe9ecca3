// forces: fields, potentials, forces and torques at places, springs; exactly one law each.

#include <fmt/format.h>

#include "model/fields.hpp"
#include "model/format.hpp"
#include "model/frames.hpp"
#include "model/names.hpp"
#include "model/read_laws.hpp"
#include "model/regime.hpp"
#include "model/sections.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;
using spec::Entry;
using spec::Node;

namespace {

GeneralizedForce read_components(const Entry& entry, Reading& reading) {
  GeneralizedForce force;
  if (!expect_map(entry.value, entry.key.span, "'generalized'", reading)) return force;
  for (const Entry& component : entry.value.entries) {
    force.components.emplace_back(name_of(component.key),
                                  read_expression(component.value, component.key.span, reading));
  }
  return force;
}

std::size_t frame_field(const Node& map, const std::string& key, Reading& reading) {
  const Node* node = spec::find(map, key);
  return node == nullptr ? k_space : frame_at(*node, map.span, "'" + key + "'", reading);
}

/// What `on` names; it must be there.
std::size_t acted_on(const Entry& force, const std::string& where, Reading& reading) {
  required(force.value, "on", force.key.span, where, reading);
  return frame_field(force.value, "on", reading);
}

PointForce read_push(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  PointForce push;
  push.frame = acted_on(force, where, reading);
  push.at = vector_field(force.value, "at", reading);
  push.from = frame_field(force.value, "from", reading);
  push.axes = frame_field(force.value, "in", reading);
  push.components = read_vector(law.value, law.key.span, "'force'", reading);
  return push;
}

Torque read_torque(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  Torque torque;
  torque.frame = acted_on(force, where, reading);
  torque.from = frame_field(force.value, "from", reading);
  torque.axes = frame_field(force.value, "in", reading);
  torque.components = read_vector(law.value, law.key.span, "'torque'", reading);
  return torque;
}

Ast stiffness_of(const Entry& force) { return force.value.entries.empty() ? broken_expression() : number(0); }

Spring read_spring(const Entry& force, const Node& pair, Reading& reading) {
  Spring spring;
  spring.stiffness = expression_field(force.value, "stiffness", reading).value_or(stiffness_of(force));
  spring.length = expression_field(force.value, "length", reading);
  spring.damping = expression_field(force.value, "damping", reading);
  if (!expect_length(pair, 2, "'spring'", reading, k_hint_for_pair)) return spring;
  for (std::size_t i = 0; i < 2; ++i) {
    (i == 0 ? spring.first : spring.second) = frame_at(pair.items[i], pair.span, "a place", reading);
  }
  return spring;
}

CoordinateSpring read_coordinate_spring(const Entry& force, const Node& coordinate, Reading& reading) {
  return {name_of(coordinate.scalar), expression_field(force.value, "stiffness", reading).value_or(stiffness_of(force)),
          expression_field(force.value, "rest", reading), expression_field(force.value, "damping", reading)};
}

/// A list is two places, a word a coordinate.
void read_spring_law(const Entry& entry, const Entry& law, const std::string& where, Force& force, Reading& reading) {
  const bool is_pair = law.value.kind == spec::NodeKind::sequence;
  const bool is_open = !is_pair && law.value.kind != spec::NodeKind::scalar;
  const char* const misplaced = is_pair ? "rest" : "length";
  for (const Entry& field : entry.value.entries) {
    if (field.key.text != misplaced || is_open) continue;
    reading.diagnostics.error(code::k_conflicting_keys, field.key.span,
                              fmt::format("{} has '{}', which belongs to a spring {}", where, misplaced,
                                          is_pair ? "along a coordinate" : "between two places"),
                              is_pair ? "write 'length'" : "write 'rest'");
  }
  if (spec::find(entry.value, "stiffness") == nullptr && spec::find(entry.value, "damping") == nullptr) {
    required(entry.value, "stiffness", entry.key.span, where, reading);
  }
  if (is_pair) {
    force.law = read_spring(entry, law.value, reading);
  } else if (expect_scalar(law.value, law.key.span, "'spring'", reading)) {
    force.law = read_coordinate_spring(entry, law.value, reading);
  }
}

void read_law(const Entry& entry, const Entry& law, const std::string& where, Force& force, Reading& reading) {
  const std::string& key = law.key.text;
  if (key == "uniform") force.law = UniformField{read_vector(law.value, law.key.span, "'uniform'", reading)};
  if (key == "potential") force.law = Potential{read_expression(law.value, law.key.span, reading)};
  if (key == "generalized") force.law = read_components(law, reading);
  if (key == "force") force.law = read_push(entry, law, where, reading);
  if (key == "torque") force.law = read_torque(entry, law, where, reading);
  if (key == "drag") force.law = read_drag(entry, law, where, reading);
  if (key == "magnus") force.law = read_magnus(entry, law, where, reading);
  if (key == "buoyancy") force.law = read_buoyancy(entry, law, where, reading);
  if (key == "friction") force.law = read_friction(entry, law, where, reading);
  if (key == "slides") force.law = read_sliding(entry, law, where, reading);
  if (key == "spring") read_spring_law(entry, law, where, force, reading);
}

/// The one law of a force; none, a second or a misspelt one is reported.
const Entry* find_law(const Entry& entry, const std::string& where, Reading& reading) {
  const Entry* first = nullptr;
  for (const Entry& field : entry.value.entries) {
    if (!format::is_law(format::force(), field.key.text)) continue;
    if (first != nullptr) {
      reading.diagnostics.error(code::k_conflicting_keys, field.key.span,
                                fmt::format("{} has '{}' beside '{}'", where, field.key.text, first->key.text),
                                "write two forces with names of their own");
      return first;
    }
    first = &field;
  }
  const std::vector<std::string> keys =
      first == nullptr ? format::keys_of(format::force()) : format::keys_beside(format::force(), first->key.text);
  // A law with a slip in its name is reported already.
  const std::size_t findings = reading.diagnostics.all().size();
  check_keys(entry.value, where, keys, reading);
  if (first == nullptr && reading.diagnostics.all().size() == findings) {
    reading.diagnostics.error(
        code::k_missing_key, entry.key.span, fmt::format("{} has no law", where),
        "add one of uniform: [x, y, z], potential: V, generalized: {coordinate: Q}, force: [x, y, "
        "z], torque: [x, y, z], spring: [P, Q], drag: body, magnus: body, buoyancy: body, friction: dot(x), slides: "
        "body");
  }
  return first;
}

bool is_buoyancy(const Entry& entry) {
  return entry.value.kind == spec::NodeKind::map && spec::find(entry.value, "buoyancy") != nullptr;
}

void read_force(const Entry& entry, Reading& reading) {
  const std::string where = fmt::format("force '{}'", entry.key.text);
  Force force;
  force.name = name_of(entry.key);
  check_name(force.name, reading);
  if (entry.value.kind == spec::NodeKind::sequence) {
    reading.diagnostics.error(code::k_wrong_kind, entry.key.span, where + " is a list",
                              "a field that acts on every mass is written {uniform: [0, 0, -g]}, a force at a place "
                              "{force: [Fx, Fy, Fz], on: body}");
  } else if (expect_map(entry.value, entry.key.span, where, reading)) {
    if (const Entry* law = find_law(entry, where, reading)) read_law(entry, *law, where, force, reading);
    force.about = text_field(entry.value, "about", reading);
  }
  const auto* const friction = std::get_if<Friction>(&force.law);
  if (friction != nullptr && !friction->smooth) {
    DryFriction dry{force.name, force.about, *friction, expression_field(entry.value, "static_limit", reading)};
    return take_friction(std::move(dry), std::move(force), reading);
  }
  reading.model.forces.push_back(std::move(force));
}

}  // namespace

void read_forces(const spec::Node& root, Reading& reading) {
  std::vector<std::size_t> lifted;
  read_section(root, "forces", reading, [&](const Entry& entry) {
    if (is_buoyancy(entry)) lifted.push_back(reading.model.forces.size());
    read_force(entry, reading);
  });
  for (const std::size_t i : lifted) {
    if (auto* const push = std::get_if<PointForce>(&reading.model.forces[i].law))
      finish_buoyancy(*push, reading.model.forces);
  }
}

}  // namespace gaussgen::model
