#include "kinematics/held_frames.hpp"

#include <algorithm>

#include "ir/contract.hpp"

namespace gaussgen::kinematics {

using ir::Vector3;
using Columns = support::Indexed<HeldIndex, Vector3>;

namespace {

bool has_any(const Columns& columns) {
  return std::any_of(columns.begin(), columns.end(), [](const Vector3& column) { return !is_zero(column); });
}

}  // namespace

std::vector<HeldFrame> held_frames(const model::Model& model, const Symbols& symbols, Expressions& expressions,
                                   Partials& partials) {
  Frames& frames = expressions.frames();
  // ∂v/∂ẋ^j in space, of v along the axes of a frame
  const auto by_held_rates = [&](const Vector3& v, std::size_t axes) {
    Columns columns;
    for (const HeldIndex j : symbols.held.indices()) {
      const FullIndex i = symbols.full(j);
      const Vector3 column{partials(v[0], i), partials(v[1], i), partials(v[2], i)};
      columns.push_back(is_zero(column) ? column : ir::multiply(frames.axes(axes), column));
    }
    return columns;
  };
  std::vector<HeldFrame> result;
  if (symbols.held.values().empty()) return result;
  for (std::size_t i = 0; i < model.frames.size(); ++i) {
    const model::Frame& frame = model.frames[i];
    const Columns velocity = by_held_rates(expressions.rate(expressions(frame.position)), frame.parent);
    const Columns omega = by_held_rates(frames.turning(i), frame.parent);
    if (has_any(velocity) || has_any(omega))
      result.push_back({{frame.name.text, i, frames.origin(i), false}, velocity, omega});
  }
  return result;
}

}  // namespace gaussgen::kinematics
