#include "strategy/held_reactions.hpp"

#include "ir/contract.hpp"
#include "strategy/cut_wrenches.hpp"
#include "strategy/link_choice.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using kinematics::ConstraintIndex;
using kinematics::Cut;
using kinematics::FreeIndex;
using kinematics::FullIndex;
using kinematics::HeldFrame;
using kinematics::HeldIndex;

namespace {

void begin(const std::string& name, const std::string& formula, Steps& steps) {
  steps.begin("reaction of " + name + ": " + formula + " (theory.md, section 4)", name);
}

}  // namespace

Vector held_reactions_by_metric(const Dynamics& dynamics, const Solution& solution, Steps& steps) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  const kinematics::Symbols& symbols = kinematics.symbols;
  Vector reactions;
  if (symbols.held.values().empty()) return reactions;
  const kinematics::Covariant& covariant = **dynamics.covariant;
  for (const HeldIndex j : symbols.held.indices()) {
    const std::string& name = symbols.held[j].name;
    begin(name, "R_j = A_j - Q_j - lambda_m beta_m_j", steps);
    const FullIndex row = symbols.full(j);
    Expr R = covariant.bias[row] - covariant.Q[row];
    for (const FreeIndex a : symbols.speeds.indices()) {
      R += covariant.G[row][symbols.full(a)] * solution.accelerations[a.value];
    }
    for (const HeldIndex k : symbols.held.indices()) {
      R += covariant.G[row][symbols.full(k)] * kinematics.held_acceleration[k];
    }
    for (const ConstraintIndex mu : kinematics.constraints.indices()) {
      R -= solution.multipliers[mu.value] * kinematics.constraints[mu].beta[row];
    }
    reactions.push_back(steps.name(R, "R_" + name));
  }
  return reactions;
}

std::optional<Vector> held_reactions_by_links(const model::Model& model, const Dynamics& dynamics,
                                              const Solution& solution, Steps& steps) {
  const kinematics::Kinematics& kinematics = *dynamics.kinematics;
  const kinematics::Symbols& symbols = kinematics.symbols;
  const std::vector<HeldFrame>& frames = *kinematics.held_frames;
  std::vector<Cut> cuts;
  for (const HeldFrame& frame : frames) cuts.push_back(frame.cut);
  CutTree tree = cut_tree(model, std::move(cuts));
  if (!links_tell_apart(model, tree, solution)) return std::nullopt;
  const std::vector<Wrench> wrenches = cut_wrenches(model, std::move(tree), dynamics, solution, steps);
  Vector reactions;
  for (const HeldIndex j : symbols.held.indices()) {
    const std::string& name = symbols.held[j].name;
    begin(name, "R_j = F dv/dx_j + M domega/dx_j where x_j moves a frame, less what else acts along x_j", steps);
    const FullIndex row = symbols.full(j);
    // What acts where no body feels it is among the forces at places, which the wrenches have.
    Expr R = kinematics.carried_force[row] - kinematics.other_force[row];
    for (std::size_t i = 0; i < frames.size(); ++i) {
      R += dot(wrenches[i].force, frames[i].velocity[j]) + dot(wrenches[i].moment, frames[i].omega[j]);
    }
    for (const ConstraintIndex mu : kinematics.constraints.indices()) {
      R -= solution.multipliers[mu.value] * kinematics.constraints[mu].beside[row];
    }
    reactions.push_back(steps.name(R, "R_" + name));
  }
  return reactions;
}

Vector held_reactions(const model::Model& model, const Dynamics& dynamics, const Solution& solution, Steps& steps) {
  if (dynamics.kinematics->symbols.held.values().empty()) return {};
  return by_links_or_speeds<Vector>(
      solution, [&](Steps& own) { return held_reactions_by_links(model, dynamics, solution, own); },
      [&](Steps& own) { return held_reactions_by_metric(dynamics, solution, own); },
      [](const Vector& reactions) { return reactions; }, steps);
}

}  // namespace gaussgen::strategy
