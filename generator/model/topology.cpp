// What moves what: bodies exist, every free speed moves one, every constraint limits a speed.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>

#include "model/checks.hpp"
#include "model/functions.hpp"
#include "support/error_codes.hpp"

namespace gaussgen::model {

namespace code = support::code;

namespace {

constexpr support::Span k_top{0, 0};

/// Of coordinates and of constraint rows: matrices have the square of that, and deriving a thousand takes minutes.
constexpr std::size_t k_most_rows = 1000;

/// Which coordinates and orientations the attitudes and positions of bodies depend on.
struct Uses {
  std::set<std::size_t> coordinates;
  std::set<std::size_t> orientations;
  std::set<std::size_t> frames;  ///< looked at
  bool unsure = false;           ///< something in a body was reported already, so nothing can be called unused
};

void collect_placement(std::size_t frame, const Model& model, Uses& uses);

void collect(const Ast& ast, const Model& model, Uses& uses) {
  for (const Ast& child : ast.children) collect(child, model, uses);
  if (ast.kind != AstKind::symbol) return;
  const auto symbol = model.symbols.find(ast.name);
  if (symbol == model.symbols.end()) {
    uses.unsure = true;
  } else if (symbol->second.kind == SymbolKind::coordinate) {
    uses.coordinates.insert(symbol->second.index);
  } else if (symbol->second.kind == SymbolKind::quaternion_component) {
    uses.orientations.insert(symbol->second.index / 4);
  } else if (symbol->second.kind == SymbolKind::place || symbol->second.kind == SymbolKind::spin) {
    collect_placement(symbol->second.index / 3, model, uses);
  } else if (symbol->second.kind == SymbolKind::axis) {
    collect_placement(symbol->second.index / 9, model, uses);
  }
}

/// What places a frame: its own motion, and that of all that carry it.
void collect_placement(std::size_t frame, const Model& model, Uses& uses) {
  for (std::size_t at = frame; at != k_space; at = model.frames[at].parent) {
    if (!uses.frames.insert(at).second) return;
    for (const Ast& component : model.frames[at].position) collect(component, model, uses);
    if (const auto* turns = std::get_if<Turns>(&model.frames[at].attitude)) {
      for (const Turn& turn : *turns) collect(turn.angle, model, uses);
    } else if (const auto* quaternion = std::get_if<QuaternionOrientation>(&model.frames[at].attitude)) {
      if (quaternion->index == k_no_orientation) uses.unsure = true;
      uses.orientations.insert(quaternion->index);
    }
  }
}

Uses uses_of(const Model& model) {
  Uses uses;
  for (const Body& body : model.bodies) collect_placement(body.frame, model, uses);
  return uses;
}

// A coordinate that no body depends on may still be determined, as the angle of a wheel without inertia that rolls, or move
// others, as a turntable does.
bool is_constrained(const Model& model, std::size_t coordinate) {
  Uses uses;
  for (const Constraint& constraint : model.constraints) {
    if (const auto* law = std::get_if<VelocityLaw>(&constraint.law)) collect(law->phi, model, uses);
    if (const auto* law = std::get_if<PositionLaw>(&constraint.law)) collect(law->f, model, uses);
    if (const auto* law = std::get_if<SlipLaw>(&constraint.law)) {
      collect_placement(law->frame, model, uses);
      collect_placement(law->surface, model, uses);
    }
  }
  return uses.unsure || uses.coordinates.count(coordinate) > 0;
}

/// What a force reads, and where it acts.
struct UsesOfForce {
  const Model& model;
  Uses& uses;

  void frame(std::size_t of) { collect_placement(of, model, uses); }
  template <class Asts>
  void all(const Asts& asts) {
    for (const Ast& ast : asts) collect(ast, model, uses);
  }

  void operator()(const UniformField&) {}
  void operator()(const Potential& law) { collect(law.energy, model, uses); }
  void operator()(const GeneralizedForce& law) {
    for (const auto& [name, value] : law.components) collect(value, model, uses);
  }
  void operator()(const PointForce& law) {
    for (const std::size_t one : {law.frame, law.from, law.axes}) frame(one);
    all(law.components);
  }
  void operator()(const Torque& law) {
    for (const std::size_t one : {law.frame, law.from, law.axes}) frame(one);
    all(law.components);
  }
  void operator()(const Spring& law) {
    for (const std::size_t one : {law.first, law.second}) frame(one);
  }
  void operator()(const Friction& law) {
    collect(law.limit, model, uses);
    for (const auto& slip : law.slips) {
      if (const auto* one = std::get_if<VelocityLaw>(&slip)) collect(one->phi, model, uses);
      if (const auto* one = std::get_if<SlipLaw>(&slip)) {
        for (const std::size_t of : {one->frame, one->surface, one->axes}) frame(of);
      }
    }
  }
  void operator()(const CoordinateSpring&) {}  // of the coordinate itself: it moves nothing else
};

/// Of the force of a spring whose end a held coordinate shakes, say, or of a contact with what it moves.
bool has_force_by(const Model& model, std::size_t coordinate) {
  Uses uses;
  for (const Force& force : model.forces) std::visit(UsesOfForce{model, uses}, force.law);
  for (const DryFriction& friction : model.frictions) UsesOfForce{model, uses}(friction.law);
  for (const Contact& contact : model.contacts) collect(contact.gap, model, uses);
  return uses.unsure || uses.coordinates.count(coordinate) > 0;
}

/// False for a name that was refused because it clashes: its uses mean the other owner of the name.
bool owns_name(const Model& model, std::size_t coordinate) {
  const auto symbol = model.symbols.find(model.coordinates[coordinate].name.text);
  return symbol != model.symbols.end() && symbol->second.kind == SymbolKind::coordinate &&
         symbol->second.index == coordinate;
}

/// 'S' beside 's'
std::string other_case_of(const std::string& name, const Model& model) {
  const auto lower = [](std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
  };
  for (const Coordinate& other : model.coordinates) {
    const bool is_same = lower(other.name.text) == lower(name);
    if (is_same && other.name.text != name) return fmt::format("'{}' is another coordinate; ", other.name.text);
  }
  return "";
}

void check_used(Reading& reading) {
  const Model& model = reading.model;
  const Uses uses = uses_of(model);
  if (uses.unsure || reading.has_unknown_carrier) return;
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    const Coordinate& coordinate = model.coordinates[i];
    if (uses.coordinates.count(i) > 0 || !owns_name(model, i) || is_constrained(model, i)) continue;
    if (coordinate.held_at) {
      if (has_force_by(model, i)) continue;
      reading.diagnostics.warning(code::k_idle_held_coordinate, coordinate.name.span,
                                  fmt::format("no body depends on the held coordinate '{}'", coordinate.name.text),
                                  "write positions, constraints or forces with it, or remove it");
    } else {
      reading.diagnostics.error(
          code::k_no_inertia, coordinate.name.span,
          fmt::format("nothing gives the coordinate '{}' inertia: no body depends on it", coordinate.name.text),
          other_case_of(coordinate.name.text, model) +
              "use it in a position or in an angle, give its rate by a constraint, or remove it");
    }
  }
  for (std::size_t i = 0; i < model.orientations.size(); ++i) {
    if (uses.orientations.count(i) > 0) continue;
    const Name& name = model.orientations[i].name;
    reading.diagnostics.error(code::k_no_inertia, name.span,
                              fmt::format("nothing gives the orientation '{}' inertia: no body has it", name.text),
                              "name it as the orientation of a body, or remove it");
  }
}

/// Whether the axes of the frame move against space.
bool turns(std::size_t frame, const Model& model) {
  Uses uses;
  for (std::size_t at = frame; at != k_space; at = model.frames[at].parent) {
    if (std::holds_alternative<QuaternionOrientation>(model.frames[at].attitude)) return true;
    const auto* turns = std::get_if<Turns>(&model.frames[at].attitude);
    for (std::size_t i = 0; turns != nullptr && i < turns->size(); ++i) collect((*turns)[i].angle, model, uses);
  }
  return !uses.coordinates.empty() || !uses.orientations.empty();
}

/// On a frame, inertia may be left out, and then is 0: with what turns, that is forgotten more often than meant.
void check_inertia_stated(Reading& reading) {
  if (reading.unread.any() || reading.diagnostics.has_errors()) return;
  for (const Body& body : reading.model.bodies) {
    if (body.inertia || body.is_particle || !turns(body.frame, reading.model)) continue;
    reading.diagnostics.warning(
        code::k_forgotten_inertia, body.name.span,
        fmt::format("'{}' turns with its frame and states no inertia: 0 is taken", body.name.text),
        "add 'inertia' about the mass centre, as 0 if it has none, or list it under 'particles'");
  }
}

/// Whether a free speed, or a name that is reported already, is in the expression.
bool has_free_speed(const Ast& ast, bool inside_dot, const Model& model) {
  if (ast.kind == AstKind::symbol) {
    const auto symbol = model.symbols.find(ast.name);
    if (symbol == model.symbols.end() || symbol->second.kind == SymbolKind::angular_velocity ||
        symbol->second.kind == SymbolKind::speed || symbol->second.kind == SymbolKind::spin ||
        symbol->second.kind == SymbolKind::slip) {
      return true;
    }
    if (!inside_dot) return false;
    if (symbol->second.kind == SymbolKind::quaternion_component || symbol->second.kind == SymbolKind::place)
      return true;
    return symbol->second.kind == SymbolKind::coordinate && !model.coordinates[symbol->second.index].held_at;
  }
  const bool inside = inside_dot || (ast.kind == AstKind::call && ast.name == k_dot);
  for (const Ast& child : ast.children) {
    if (has_free_speed(child, inside, model)) return true;
  }
  return false;
}

void check_constraints(Reading& reading) {
  for (const Constraint& constraint : reading.model.constraints) {
    const auto* velocity = std::get_if<VelocityLaw>(&constraint.law);
    if (velocity != nullptr && !has_free_speed(velocity->phi, false, reading.model)) {
      reading.diagnostics.error(code::k_no_velocity, constraint.span,
                                fmt::format("no free speed appears in the constraint '{}'", constraint.name.text),
                                "write rates as dot(x); a coordinate with a given value is declared with 'held_at'");
    }
    const auto* position = std::get_if<PositionLaw>(&constraint.law);
    if (position != nullptr && !has_free_speed(position->f, true, reading.model)) {
      reading.diagnostics.error(
          code::k_no_velocity, constraint.span,
          fmt::format("no free coordinate appears in the constraint '{}'", constraint.name.text),
          "an equation relates coordinates; a coordinate with a given value is declared with 'held_at'");
    }
  }
}

/// A closed one is a constraint, which is looked at as such.
void check_gaps(Reading& reading) {
  for (const Contact& contact : reading.model.contacts) {
    if (contact.mode == Mode::closed || has_free_speed(contact.gap, true, reading.model)) continue;
    reading.diagnostics.error(
        code::k_no_velocity, contact.gap.span,
        fmt::format("no free coordinate appears in the gap of the contact '{}'", contact.name.text),
        "a gap changes as the model moves: write it with coordinates, or places such as tip.z");
  }
}

bool moves(const Ast& ast, const Model& model) {
  if (ast.kind == AstKind::symbol) {
    const auto symbol = model.symbols.find(ast.name);
    return symbol != model.symbols.end() && symbol->second.kind != SymbolKind::parameter &&
           symbol->second.kind != SymbolKind::pi;
  }
  return std::any_of(ast.children.begin(), ast.children.end(), [&](const Ast& child) { return moves(child, model); });
}

/// A point that moves on what carries it: what touches there is not the point.
bool wanders(std::size_t frame, const Model& model) {
  if (frame == k_space || pushed_by_force_on(model, frame) == frame) return false;
  const auto& position = model.frames[frame].position;
  return std::any_of(position.begin(), position.end(), [&](const Ast& component) { return moves(component, model); });
}

bool moves_freely(const SlipLaw& law, const Model& model) {
  Uses uses;
  collect_placement(law.frame, model, uses);
  collect_placement(law.surface, model, uses);
  return uses.unsure || !uses.orientations.empty() ||
         std::any_of(uses.coordinates.begin(), uses.coordinates.end(),
                     [&](std::size_t coordinate) { return !model.coordinates[coordinate].held_at; });
}

/// `rolls` is three rows, of which one is looked at.
void check_contacts(Reading& reading) {
  const Model& model = reading.model;
  std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
  for (const Constraint& constraint : model.constraints) {
    const auto* law = std::get_if<SlipLaw>(&constraint.law);
    if (law == nullptr || constraint.span.begin == last) continue;
    last = constraint.span.begin;
    if (!reading.has_unknown_carrier && !reading.unread.any() && !moves_freely(*law, model)) {
      reading.diagnostics.error(
          code::k_no_velocity, constraint.span,
          fmt::format("no free coordinate moves what touches in the constraint '{}'", name_in_file(constraint)),
          "a coordinate with a given value is declared with 'held_at'");
    }
    for (const std::size_t frame : {law->frame, law->surface}) {
      if (!wanders(frame, model)) continue;
      const std::size_t carrier = pushed_by_force_on(model, frame);
      const std::string on = carrier == k_space ? "space" : model.frames[carrier].name.text;
      reading.diagnostics.error(
          code::k_wrong_reference, constraint.span,
          fmt::format("'{}' is a point that moves on '{}', and what touches there is not the point",
                      model.frames[frame].name.text, on),
          fmt::format(
              "for what is there on '{0}' name '{0}', with the point as 'at'; for something that moves along make "
              "it one of the 'frames'",
              on));
    }
  }
}

void refuse_many(const char* what, const Name& first_beyond, Reading& reading) {
  reading.diagnostics.error(code::k_file_too_large, first_beyond.span,
                            fmt::format("the model has more than {} {}", k_most_rows, what),
                            "no more than that can be derived in reasonable time; make fewer copies");
}

/// A `count` makes many with a few letters.
bool has_reasonable_size(Reading& reading) {
  const Model& model = reading.model;
  const bool has_many_coordinates = model.coordinates.size() > k_most_rows;
  const bool has_many_orientations = 3 * model.orientations.size() > k_most_rows;
  const bool has_many_constraints = model.constraints.size() > k_most_rows;
  if (has_many_coordinates) refuse_many("coordinates", model.coordinates[k_most_rows].name, reading);
  if (has_many_orientations) refuse_many("angular velocities", model.orientations[k_most_rows / 3].name, reading);
  if (has_many_constraints) refuse_many("constraints", model.constraints[k_most_rows].name, reading);
  return !has_many_coordinates && !has_many_orientations && !has_many_constraints;
}

}  // namespace

namespace {

std::string hint_for_motion(const Reading& reading) {
  for (const LeftOut& entry : reading.left_out) {
    if (entry.section != "coordinates" && entry.section != "joints" && entry.section != "orientations") continue;
    if (!entry.effect.empty())
      return fmt::format("'{}' of the effect '{}', which does not act, would move", entry.entry, entry.effect);
    return fmt::format("'without' of submodel '{}' leaves out '{}', which would move", entry.submodel, entry.entry);
  }
  return "add 'coordinates:', 'orientations:', or 'joints:' that move";
}

}  // namespace

void check_topology(Reading& reading) {
  if (!reading.unread.any() && !has_reasonable_size(reading)) return;
  const Model& model = reading.model;
  const bool nothing_moves = model.coordinates.empty() && model.orientations.empty();
  if (model.bodies.empty() && !reading.unread.any()) {
    reading.diagnostics.error(code::k_no_bodies, k_top, "the model has no bodies", "add 'bodies:' or 'particles:'");
  }
  if (nothing_moves && !reading.unread.any()) {
    reading.diagnostics.error(code::k_nothing_moves, k_top, "the model has no coordinates, so nothing can move",
                              hint_for_motion(reading));
  }
  if (!model.bodies.empty() && !reading.unread.any()) check_used(reading);
  check_constraints(reading);
  check_gaps(reading);
  check_contacts(reading);
  check_inertia_stated(reading);
}

}  // namespace gaussgen::model
