#pragma once
// The paper's route as nodes of the graph: what the emitted route is compared with.

#include <string>
#include <vector>

#include "lower/factorise.hpp"
#include "lower/symbol_map.hpp"
#include "model/model.hpp"

namespace gaussgen::lower {

struct PaperRoute {
  std::string obstacle;  ///< why this route does not take the model; then everything else is empty

  std::vector<std::string>
      speeds;  ///< labels: free coordinates (or speeds of their own) as declared, then angular velocities
  std::vector<ir::NodeId> accelerations;  ///< q̈^α and du/dt, in this order
  std::vector<std::string> constraints;   ///< as declared
  std::vector<ir::NodeId> lambda;         ///< λ_μ (3.4)
  std::vector<std::string> held;          ///< as declared
  std::vector<ir::NodeId> R_x;            ///< R_j = A_j - Q_j - λ_μ β_μj (3.5)
  std::vector<ir::NodeId> R_x_up;         ///< R^i = э^ij R_j, from (3.8)
  ir::NodeId Z_w;                         ///< (1.13) without R: Gauss's function up to a term free of accelerations
  std::vector<std::string>
      dependent;                  ///< the rates eliminated (3.6); this route never eliminates speeds of the model's own
  bool partition_is_safe = true;  ///< det b_μρ is shown never to vanish
};

/// Why this route does not take a model of this size; empty when it does.
std::string paper_route_obstacle(const model::Model& model);

inline constexpr const char* k_dependent_constraints =
    "the nonholonomic constraints do not determine the dependent speeds at the initial state";

PaperRoute build_paper_route(const model::Model& model, ir::Graph& graph, const SymbolMap& symbols,
                             const Vanishes& vanishes = nullptr);

}  // namespace gaussgen::lower
