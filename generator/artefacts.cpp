#include "artefacts.hpp"

#include <algorithm>

#include "artefact_builder.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

using emit::Artefact;

const std::vector<OutputKind>& output_kinds() {
  static const std::vector<OutputKind> k_kinds{
      {"rhs", "time derivative of the state"},
      {"reactions", "multiplier and generalized reaction of every constraint, alone and together with rhs"},
      {"reaction_forces", "reactions as Cartesian forces and moments on the bodies"},
      {"joint_reactions", "force and moment that each joint transmits"},
      {"energy", "kinetic, potential and total energy"},
      {"compulsion", "Gauss's function Z of candidate accelerations"},
      {"residuals", "constraint residuals of position, velocity and acceleration"},
      {"mobility", "rank of the constraints, the motions that they leave, and which of them follow from others"},
      {"mass_matrix", "the metric of the free speeds"},
      {"project", "nearest state that satisfies the constraints"},
      {"initial_state", "the model's initial state"},
      {"quantities", "what the model names under 'quantities'"},
      {"impact_system", "inertia and gradients that impulses of contacts and friction act on", false},
      {"guards", "what ends the regime of contacts and friction", false},
      {"load_system", "what guards judge where more holds than is needed", false},
      {"poses", "where bodies and joints are, and how bodies are turned", false},
      {"inverse_dynamics", "forces and inputs that make given accelerations", false},
      {"jacobian", "derivatives of rhs by state, inputs and time", false},
      {"sensitivities", "derivatives of rhs and of reactions by chosen parameters", false},
      {"taylor", "power series of the state along its motion", false}};
  return k_kinds;
}

namespace {

std::vector<Artefact> equations_of_motion(Mechanics& mechanics) {
  std::vector<Artefact> result;
  if (has_general_way(mechanics)) result.push_back(linear_system_artefact(mechanics));
  const auto rhs = [](Mechanics& of) { return std::vector<Artefact>{rhs_artefact(of)}; };
  for (Artefact& artefact : in_two_ways(rhs, false, mechanics)) result.push_back(std::move(artefact));
  return result;
}

}  // namespace

std::vector<Artefact> build_artefact(const std::string& name, Mechanics& mechanics) {
  const auto one = [](Artefact artefact) {
    std::vector<Artefact> list;
    list.push_back(std::move(artefact));
    return list;
  };
  // Without a free coordinate there is no state to look for; reactions of the held motion remain.
  const bool has_state = mechanics.dynamics.n() > 0;
  if (!has_state && (name == "rhs" || name == "mass_matrix" || name == "project" || name == "initial_state")) return {};
  if (name == "rhs") return equations_of_motion(mechanics);
  if (name == "reactions") return in_two_ways(reactions_artefacts, true, mechanics);
  if (name == "reaction_forces") return in_two_ways(reaction_forces_artefact, true, mechanics);
  if (name == "joint_reactions") return in_two_ways(joint_reactions_artefact, true, mechanics);
  if (name == "energy") return one(energy_artefact(mechanics));
  if (name == "compulsion") return compulsion_artefact(mechanics);
  if (name == "residuals") return residuals_artefact(mechanics);
  if (name == "mobility" && has_state) return mobility_artefact(mechanics);
  if (name == "mass_matrix") return one(mass_matrix_artefact(mechanics));
  if (name == "project") return project_artefacts(mechanics);
  if (name == "initial_state") return initial_state_artefacts(mechanics);
  if (name == "inverse_dynamics" && has_output(name, mechanics)) return inverse_dynamics_artefact(mechanics);
  if (name == "jacobian" && has_state) return jacobian_artefact(mechanics);
  if (name == "sensitivities") return sensitivities_artefact(mechanics);
  if (name == "quantities") return quantities_artefact(mechanics);
  if (name == "guards") return guards_artefact(mechanics);
  if (name == "impact_system" && has_output(name, mechanics)) return impact_system_artefact(mechanics);
  if (name == "load_system" && has_output(name, mechanics)) return in_two_ways(load_system_artefact, true, mechanics);
  if (name == "poses") return poses_artefact(mechanics);
  if (name == "taylor" && has_state) return taylor_artefact(mechanics);
  return {};
}

namespace {

/// What impulses act on is told of the regime in which none of it is a constraint or a force already.
bool has_impacts(const model::Model& model) {
  const auto is_open = [](const model::Contact& contact) { return contact.mode == model::Mode::open; };
  const auto is_free = [](const model::DryFriction& friction) { return friction.mode == model::Mode::free; };
  return model.is_ground && model.contacts.size() + model.frictions.size() > 0 &&
         std::all_of(model.contacts.begin(), model.contacts.end(), is_open) &&
         std::all_of(model.frictions.begin(), model.frictions.end(), is_free);
}

/// Reactions that guards judge are not unique.
bool shares_loads(Mechanics& mechanics) {
  const auto& guards = mechanics.model.guards;
  return std::any_of(guards.begin(), guards.end(), [](const model::Guard& guard) { return !guard.rows.empty(); }) &&
         has_general_way(mechanics) && usual_rank(mechanics) < mechanics.dynamics.l();
}

}  // namespace

bool has_output(const std::string& name, Mechanics& mechanics) {
  const model::Model& model = mechanics.model;
  const bool has_constraints = mechanics.dynamics.l() > 0;
  if (name == "reactions" || name == "reaction_forces") return has_constraints || mechanics.symbols.held.size() > 0;
  if (name == "joint_reactions") return !model.joints.empty();
  if (name == "residuals") return has_constraints || has_quaternions(mechanics);
  if (name == "quantities") return !model.quantities.empty();
  if (name == "guards") return !model.guards.empty();
  if (name == "impact_system") return mechanics.dynamics.n() > 0 && has_impacts(model);
  if (name == "load_system") return shares_loads(mechanics);
  // Accelerations that are given have reactions of their own, and so other forces.
  if (name == "inverse_dynamics" && model::has_reactions_in_forces(model)) return false;
  if (name == "sensitivities") return !model.sensitivities.empty() && !mechanics.options.fold;
  if (name == "mobility") return has_general_way(mechanics);
  if (name == "compulsion") return has_compulsion(mechanics);
  if (name == "taylor") return has_taylor(mechanics);
  if (name == "energy" || name == "poses") return true;
  return mechanics.dynamics.n() > 0;
}

}  // namespace gaussgen
