#include "model/turning.hpp"

#include "model/constant.hpp"

namespace gaussgen::model {

namespace {

/// x, y or z, with either sign.
std::optional<char> letter_of(const Turn& turn) {
  if (const char* const letter = std::get_if<char>(&turn.axis)) return *letter;
  std::optional<char> found;
  const auto& components = std::get<std::array<Ast, 3>>(turn.axis);
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto value = exact_value(components[i]);
    if (value && cln::zerop(*value)) continue;
    if (found) return std::nullopt;
    found = "xyz"[i];
  }
  return found;
}

}  // namespace

bool turns_about_one_own_axis(const Model& model, std::size_t frame) {
  std::optional<char> axis;
  for (std::size_t i = frame; i != k_space; i = model.frames[i].parent) {
    const Attitude& attitude = model.frames[i].attitude;
    if (std::holds_alternative<QuaternionOrientation>(attitude)) return false;
    const auto* const turns = std::get_if<Turns>(&attitude);
    if (turns == nullptr) continue;
    // A turn about the axis of the ones inside of it leaves that axis where it is.
    for (const Turn& turn : *turns) {
      const auto letter = letter_of(turn);
      if (!letter || (axis && *axis != *letter)) return false;
      axis = letter;
    }
  }
  return true;
}

std::string outer_frame(const Model& model, std::size_t orientation) {
  std::optional<std::size_t> parent;
  for (const Frame& frame : model.frames) {
    const auto* const quaternion = std::get_if<QuaternionOrientation>(&frame.attitude);
    if (quaternion == nullptr || quaternion->index != orientation) continue;
    if (parent && *parent != frame.parent) return "parent";
    parent = frame.parent;
  }
  return parent.value_or(k_space) == k_space ? "space" : model.frames[*parent].name.text;
}

}  // namespace gaussgen::model
