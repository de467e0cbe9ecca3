#include "given_solution.hpp"

#include "artefact_builder.hpp"

namespace gaussgen {

using ir::Expr;

namespace {

strategy::Vector given_multipliers(Mechanics& mechanics) {
  if (mechanics.multipliers.empty()) {
    for (const std::string& name : mechanics.dynamics.constraints)
      mechanics.multipliers.push_back(mechanics.graph.declare(ir::SymbolClass::opaque, "lambda_" + name));
  }
  strategy::Vector given;
  for (const ir::SymbolId symbol : mechanics.multipliers) given.push_back(mechanics.expressions.symbol(symbol));
  return given;
}

}  // namespace

GivenSolution::GivenSolution(Mechanics& mechanics)
    : mechanics_(mechanics), solution_(mechanics.solution), held_reactions_(mechanics.held_reactions) {
  const Expr never = mechanics.expressions.number(0);
  strategy::Solution given{candidate_accelerations(mechanics),
                           given_multipliers(mechanics),
                           never,
                           never,
                           solution_.description,
                           {},
                           {},
                           {}};
  mechanics.solution = std::move(given);
  mechanics.held_reactions =
      strategy::held_reactions(mechanics.model, mechanics.dynamics, mechanics.solution, mechanics.steps);
}

GivenSolution::~GivenSolution() {
  mechanics_.solution = std::move(solution_);
  mechanics_.held_reactions = std::move(held_reactions_);
}

}  // namespace gaussgen
