#pragma once
// The graph's symbols for a model: who is q, u, x, t, and which formula parameters expand to.

#include <map>
#include <string>
#include <vector>

#include "ir/graph.hpp"
#include "kinematics/indices.hpp"
#include "model/model.hpp"

namespace gaussgen::kinematics {

/// q: a coordinate or one quaternion component.
struct ConfigurationVariable {
  ir::SymbolId symbol;
  std::string name;
  std::string unit;
  std::string about;
};

/// u^α with the symbol of du^α/dt for callers that supply accelerations.
struct Speed {
  ir::SymbolId symbol;
  ir::SymbolId acceleration;
  std::string name;               ///< chi_dot, wx
  std::string acceleration_name;  ///< chi_ddot, wx_dot
  std::string label;              ///< what indices are called: chi, wx
  std::string unit;
  std::string about;

  bool replaces_rate = false;  ///< of the coordinate with its index

  bool is_of_length() const { return unit == "m/s"; }
};

/// x^i, with dx^i/dt and d²x^i/dt² as symbols until c^i(t) is put in.
struct HeldCoordinate {
  ir::SymbolId symbol;
  ir::SymbolId rate;
  ir::SymbolId acceleration;
  std::size_t model_index = 0;  ///< into Model::coordinates
  std::string name;
};

struct Symbols {
  ir::SymbolId time;
  ir::SymbolId pi;
  ir::SymbolId epsilon;
  std::vector<ir::SymbolId> parameters;       ///< parallel to Model::parameters
  std::vector<ir::SymbolId> inputs;           ///< parallel to Model::inputs
  std::vector<ir::SymbolId> reactions;        ///< parallel to Model::reactions: until they are found
  std::map<std::string, ir::TableId> tables;  ///< by name; as numbered in Model::tables
  support::Indexed<ConfigurationIndex, ConfigurationVariable> configuration;
  support::Indexed<FreeIndex, Speed> speeds;
  support::Indexed<HeldIndex, HeldCoordinate> held;

  /// Parallel to Model::coordinates: position among the free (also among q and u) or the held ones.
  struct Place {
    bool is_held = false;
    std::size_t index = 0;
  };
  std::vector<Place> coordinates;
  std::vector<ConfigurationIndex> first_quaternion_component;  ///< parallel to Model::orientations
  std::vector<FreeIndex> first_angular_velocity;               ///< likewise

  std::size_t free_count() const { return speeds.size(); }
  std::size_t full_count() const { return speeds.size() + held.size(); }
  /// Free coordinates; the speeds of the same index are their rates, or take their place. Quaternions follow.
  std::size_t plain_count() const {
    return first_angular_velocity.empty() ? speeds.size() : first_angular_velocity.front().value;
  }
  FullIndex full(FreeIndex i) const { return FullIndex{i.value}; }
  FullIndex full(HeldIndex i) const { return FullIndex{speeds.size() + i.value}; }

  /// Symbol of the rate along A: a speed, or dx^i/dt.
  ir::SymbolId rate(FullIndex i) const;
  /// What A is called in names such as G_chi_rho.
  const std::string& label(FullIndex i) const;
};

/// Declares everything in the order of the model, which is the canonical order of the graph.
Symbols declare_symbols(const model::Model& model, ir::Graph& graph);

}  // namespace gaussgen::kinematics
