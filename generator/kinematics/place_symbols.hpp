#pragma once
// Places as symbols of their own, with their rates; where it is asked for, the axes of frames, too.

#include <array>
#include <map>
#include <string>

#include "ir/expr.hpp"

namespace gaussgen::kinematics {

class PlaceSymbols {
 public:
  struct Component {
    ir::SymbolId place;
    ir::SymbolId rate;
  };
  using Vector = std::array<Component, 3>;

  explicit PlaceSymbols(ir::Graph& graph, bool has_axes = false) : graph_(graph), has_axes_(has_axes) {}

  bool has_axes() const { return has_axes_; }

  /// Of the origin of a frame; declared on first use.
  const Vector& of(std::size_t frame) { return declared(places_, frame, "place" + std::to_string(frame)); }

  /// Of an axis of a frame, 3 frame + axis: its components in space.
  const Vector& of_axis(std::size_t index) { return declared(axes_, index, "axis" + std::to_string(index)); }

  const std::map<std::size_t, Vector>& all() const { return places_; }
  const std::map<std::size_t, Vector>& all_axes() const { return axes_; }

 private:
  const Vector& declared(std::map<std::size_t, Vector>& all, std::size_t index, const std::string& name) {
    const auto known = all.find(index);
    if (known != all.end()) return known->second;
    Vector components{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string label = name + "_" + "xyz"[i];
      components[i] = {graph_.declare(ir::SymbolClass::opaque, label),
                       graph_.declare(ir::SymbolClass::opaque, label + "_dot")};
    }
    return all.emplace(index, components).first->second;
  }

  ir::Graph& graph_;
  bool has_axes_;
  std::map<std::size_t, Vector> places_, axes_;
};

}  // namespace gaussgen::kinematics
