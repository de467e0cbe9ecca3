#pragma once
// Places as symbols of their own, with their rates.

#include <array>
#include <map>

#include "ir/expr.hpp"

namespace gaussgen::kinematics {

class PlaceSymbols {
 public:
  struct Component {
    ir::SymbolId place;
    ir::SymbolId rate;
  };

  explicit PlaceSymbols(ir::Graph& graph) : graph_(graph) {}

  /// Of the origin of a frame; declared on first use.
  const std::array<Component, 3>& of(std::size_t frame) {
    const auto known = all_.find(frame);
    if (known != all_.end()) return known->second;
    std::array<Component, 3> components{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name = "place" + std::to_string(frame) + "_" + "xyz"[i];
      components[i] = {graph_.declare(ir::SymbolClass::opaque, name),
                       graph_.declare(ir::SymbolClass::opaque, name + "_dot")};
    }
    return all_.emplace(frame, components).first->second;
  }

  const std::map<std::size_t, std::array<Component, 3>>& all() const { return all_; }

 private:
  ir::Graph& graph_;
  std::map<std::size_t, std::array<Component, 3>> all_;
};

}  // namespace gaussgen::kinematics
