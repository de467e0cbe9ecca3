// drag, magnus, buoyancy: what a medium does to a place or a body that moves in it. Written out as forces at that place.

#include <fmt/format.h>

#include "model/ast_build.hpp"
#include "model/fields.hpp"
#include "model/frames.hpp"
#include "model/read_laws.hpp"

namespace gaussgen::model {

using spec::Entry;
using spec::Node;

namespace {

/// Of the place against the medium; its sums are checked as those of the user.
std::array<Ast, 3> velocity_of(const Name& place, const Node* wind, Reading& reading) {
  std::array<Ast, 3> velocity;
  for (std::size_t i = 0; i < 3; ++i) velocity[i] = call_of("dot", component_of(place, i));
  if (wind == nullptr) return velocity;
  std::array<Ast, 3> of_wind = read_vector(*wind, wind->span, "'wind'", reading);
  for (std::size_t i = 0; i < 3; ++i) {
    velocity[i] = difference_of(std::move(velocity[i]), std::move(of_wind[i]));
    velocity[i].is_derived = false;
  }
  return velocity;
}

Ast size_of(const std::array<Ast, 3>& vector, support::Span span) {
  std::vector<Ast> squares;
  for (const Ast& component : vector) squares.push_back(square_of(component));
  return call_of("sqrt", node_of(AstKind::sum, span, std::move(squares)));
}

struct InMedium {
  Name place;
  std::size_t frame = k_space;
  std::array<Ast, 3> velocity;
};

InMedium in_medium(const Entry& force, const Entry& law, Reading& reading) {
  InMedium result;
  result.frame = frame_at(law.value, law.key.span, fmt::format("'{}'", law.key.text), reading);
  // What is not known is reported, and stands nowhere.
  result.place = result.frame == k_space ? Name{"space", law.key.span} : name_of(law.value.scalar);
  result.velocity = velocity_of(result.place, spec::find(force.value, "wind"), reading);
  return result;
}

PointForce at_place(std::size_t frame, std::array<Ast, 3> at) {
  PointForce push;
  push.frame = frame;
  push.at = std::move(at);
  return push;
}

std::array<Ast, 3> no_shift() { return {number(0), number(0), number(0)}; }

}  // namespace

// F = -(b + c |v|) v
PointForce read_drag(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  const InMedium medium = in_medium(force, law, reading);
  const std::optional<Ast> linear = expression_field(force.value, "linear", reading);
  const std::optional<Ast> quadratic = expression_field(force.value, "quadratic", reading);
  if (!linear && !quadratic) required(force.value, "quadratic", force.key.span, where, reading);
  PointForce push = at_place(medium.frame, no_shift());
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Ast> terms;
    if (linear) terms.push_back(negative_of(product_of(*linear, medium.velocity[i])));
    if (quadratic) {
      Ast speed = product_of(size_of(medium.velocity, law.value.span), medium.velocity[i]);
      terms.push_back(negative_of(product_of(*quadratic, std::move(speed))));
    }
    push.components[i] =
        terms.size() == 1 ? std::move(terms[0]) : node_of(AstKind::sum, law.value.span, std::move(terms));
  }
  return push;
}

// F = k ω × v
PointForce read_magnus(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  const InMedium medium = in_medium(force, law, reading);
  PointForce push = at_place(medium.frame, no_shift());
  const bool has_coefficient = required(force.value, "coefficient", force.key.span, where, reading) != nullptr;
  const Ast k = has_coefficient ? *expression_field(force.value, "coefficient", reading) : broken_expression();
  const auto spin = [&](std::size_t i) {
    if (medium.frame == k_space) return number(0);
    return symbol_of(medium.place.text + ".w" + "xyz"[i], medium.place.span);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    push.components[i] =
        product_of(k, difference_of(product_of(spin(j), medium.velocity[l]), product_of(spin(l), medium.velocity[j])));
  }
  return push;
}

// What the displaced medium weighs, against the fields: these are all known behind the last force.
PointForce read_buoyancy(const Entry& force, const Entry& law, const std::string& where, Reading& reading) {
  PointForce push =
      at_place(frame_at(law.value, law.key.span, "'buoyancy'", reading), vector_field(force.value, "at", reading));
  const bool is_there = required(force.value, "displaced", force.key.span, where, reading) != nullptr;
  const Ast mass = is_there ? *expression_field(force.value, "displaced", reading) : broken_expression();
  push.components = {mass, mass, mass};
  return push;
}

void finish_buoyancy(PointForce& push, const std::vector<Force>& forces) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Ast> terms;
    for (const Force& force : forces) {
      const auto* const field = std::get_if<UniformField>(&force.law);
      // A written 0 has no unit.
      const bool acts = field != nullptr && !(field->field[i].kind == AstKind::number && field->field[i].number == 0);
      if (acts) terms.push_back(negative_of(product_of(push.components[i], field->field[i])));
    }
    if (terms.empty()) {
      push.components[i] = number(0);
    } else {
      const support::Span span = push.components[i].span;
      push.components[i] = terms.size() == 1 ? std::move(terms[0]) : node_of(AstKind::sum, span, std::move(terms));
    }
  }
}

}  // namespace gaussgen::model
