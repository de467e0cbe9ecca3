#pragma once
// Everything that is decided before anything is printed: what `prepare` computes, what each function computes, and names.

#include <vector>

#include "emit/names.hpp"
#include "emit/result_types.hpp"
#include "emit/unit.hpp"
#include "passes/optimise.hpp"
#include "passes/program.hpp"

namespace gaussgen::emit {

/// One artefact over prepared values; those that only call others have none. `outputs` holds derivative, state, the fields of all groups, then the status.
struct Task {
  const Artefact* artefact;
  passes::Request request;
  std::vector<passes::PassEffect> effects;  ///< of the passes, in their order
};

struct PreparedMember {
  SymbolId symbol;
  std::vector<SymbolId> others;  ///< which stand for the same value
  std::string name;
  std::string about;
  NodeId value;             ///< over parameters and formulas
  bool is_plain = false;    ///< a copy of the parameter
  bool is_formula = false;  ///< a parameter that follows from others
};

struct Plan {
  Plan(ir::Graph own, const Unit& described);

  ir::Graph graph;  ///< printing adds powers and prepared symbols
  const Unit& unit;
  UnitNames names;
  ResultTypes result_types;
  std::vector<Task> tasks;
  std::vector<PreparedMember> prepared;  ///< plain parameters, formulas in the order of computation, then the rest
};

}  // namespace gaussgen::emit
