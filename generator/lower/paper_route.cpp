#include "lower/paper_route.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lower/binding_lowering.hpp"

namespace gaussgen::lower {

using nonholonomic::PaperSystem;

namespace {

template <class Index>
std::vector<ir::NodeId> lowered(const symbolic::Row<Index>& row, PaperLowering& lower) {
  std::vector<ir::NodeId> nodes;
  for (const GiNaC::ex& entry : row) nodes.push_back(lower(entry));
  return nodes;
}

}  // namespace

std::string paper_route_obstacle(const model::Model& model) {
  if (model::has_reactions_in_forces(model))
    return "the paper's route takes active forces as given, and here they contain reactions";
  const auto is_friction = [](const model::Force& one) { return std::holds_alternative<model::Friction>(one.law); };
  if (std::any_of(model.forces.begin(), model.forces.end(), is_friction))
    return "the paper has no friction; write it as a force";
  const std::size_t full_count = model.coordinates.size() + 3 * model.orientations.size();
  if (full_count <= gauss::k_largest_full_count) return "";
  return fmt::format("the paper's route takes up to {} coordinates; this model has {}", gauss::k_largest_full_count,
                     full_count);
}

PaperRoute build_paper_route(const model::Model& model, ir::Graph& graph, const SymbolMap& symbols,
                             const Vanishes& vanishes) {
  PaperRoute route;
  route.obstacle = paper_route_obstacle(model);
  if (!route.obstacle.empty()) return route;
  const std::optional<PaperSystem> paper = nonholonomic::build_paper_system(model);
  if (!paper) {
    route.obstacle = k_dependent_constraints;
    return route;
  }
  const symbolic::Chart& chart = paper->chart();
  LoweringStyle style;
  style.vanishes = vanishes;
  PaperLowering lower(*paper, graph, symbols, style);
  for (const symbolic::FreeIndex a : chart.free()) {
    const std::optional<symbolic::ChartSpeed>& speed = chart.speed_instead(a);
    route.speeds.push_back(speed ? speed->name : chart[a].label);
    route.accelerations.push_back(lower(speed ? chart.at_attitude(chart.rate_of(speed->is)) : chart[a].acceleration));
  }
  for (const symbolic::HeldIndex i : chart.held()) route.held.push_back(chart[i].label);
  for (const symbolic::FreeIndex a : paper->partition.dependent) route.dependent.push_back(chart[a].label);
  route.constraints = paper->rows.names;
  route.lambda = lowered(paper->lambda, lower);
  route.R_x = lowered(paper->R_x, lower);
  route.R_x_up = lowered(paper->R_x_up, lower);
  const gauss::System& system = paper->system;
  route.Z_w = lower(at_motion(system.compulsion.Z_w, system.compulsion, system.invariant));
  route.partition_is_safe = paper->partition.is_safe;
  return route;
}

}  // namespace gaussgen::lower
