#include <algorithm>

#include "artefact_builder.hpp"
#include "artefacts.hpp"
#include "ir/substitute.hpp"
#include "reactions_in_forces.hpp"

namespace gaussgen {

using emit::Artefact;
using ir::Expr;
using strategy::Vector;

namespace {

/// What a limit is without reactions of constraints, and how it grows with each of them.
struct LimitParts {
  Expr without;
  Vector per_row;
};

LimitParts parts_of(Expr limit, const Mechanics& mechanics, ir::Graph& graph) {
  const std::vector<model::NamedReaction>& reactions = mechanics.model.reactions;
  const auto is_open = [](const model::NamedReaction& one) { return !one.is_held && !one.is_absent; };
  const Expr none = mechanics.expressions.number(0);
  ir::Substitution without(graph);
  for (std::size_t r = 0; r < reactions.size(); ++r)
    without.replace(mechanics.symbols.reactions[r],
                    is_open(reactions[r]) ? none : reaction_of(mechanics, reactions[r]));
  LimitParts parts{without(limit), {}};
  for (const kinematics::ConstraintRow& row : mechanics.kinematics.constraints) {
    parts.per_row.push_back(none);
    for (std::size_t r = 0; r < reactions.size(); ++r)
      if (is_open(reactions[r]) && reactions[r].of == row.name)
        parts.per_row.back() = without(ir::partial(limit, mechanics.symbols.reactions[r]));
  }
  return parts;
}

Artefact load_system(Mechanics& mechanics) {
  const kinematics::Kinematics& kinematics = mechanics.kinematics;
  strategy::Matrix rows, per_reaction;
  Vector limits;
  for (const kinematics::ConstraintRow& row : kinematics.constraints) rows.push_back(gradient_of(mechanics, row));
  for (std::size_t i = 0; i < mechanics.model.guards.size(); ++i) {
    if (mechanics.model.guards[i].rows.empty()) continue;
    LimitParts parts = parts_of(kinematics.guard_limits[i], mechanics, mechanics.graph);
    limits.push_back(parts.without);
    per_reaction.push_back(std::move(parts.per_row));
  }
  ArtefactBuilder builder("load_system",
                          "What is left open of the reactions that guards judge, where more holds than is needed\n"
                          "(theory.md, section 11).",
                          mechanics);
  builder.result_type("LoadSystem");
  const int n = static_cast<int>(mechanics.dynamics.n()), l = static_cast<int>(rows.size());
  const int k = static_cast<int>(limits.size());
  builder.fields("", "", "",
                 {{"g", "the metric of the free speeds (1.10)", {n, n}, ids(mechanics.dynamics.g)},
                  {"rows", "dphi/du of each constraint", {l, n}, ids(rows)},
                  {"reactions", "multipliers, one choice of them", {l}, ids(mechanics.solution.multipliers)},
                  {"limits", "of guards that judge reactions: what they are without any", {k}, ids(limits)},
                  {"per_reaction", "how much more they are per multiplier", {k, l}, ids(per_reaction)}});
  builder.with_solution_status();
  return builder.finish({});
}

}  // namespace

std::vector<Artefact> load_system_artefact(Mechanics& mechanics) {
  std::vector<Artefact> result;
  result.push_back(load_system(mechanics));
  return result;
}

}  // namespace gaussgen
