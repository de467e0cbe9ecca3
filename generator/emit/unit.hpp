#pragma once
// What the emitter is given: names, tables and expressions, no mechanics. The pipeline fills it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ir/graph.hpp"
#include "support/rational.hpp"

namespace gaussgen::emit {

using ir::NodeId;
using ir::SymbolId;

/// A quantity that a user of the header sees by name.
struct Entry {
  SymbolId symbol;
  std::string name;   ///< as in the model; the emitter mangles keywords and macros
  std::string unit;   ///< may be empty
  std::string about;  ///< may be empty, free text
};

struct ParameterEntry {
  Entry entry;
  NodeId value;             ///< plain: a constant expression; formula: over other parameters
  bool is_formula = false;  ///< then not a member of Parameters but computed by `prepare` as a named value
};

struct InputEntry {
  Entry entry;
  NodeId value;  ///< default
};

/// x^i = c^i(t): documentation only, since it is substituted.
struct HeldEntry {
  std::string name;
  std::string unit;
  std::string about;
  std::string held_at;  ///< text of the model
};

/// φ_μ by name: for the table of constraints and n_constraints.
struct ConstraintEntry {
  std::string name;
  std::string about;
};

/// Where the entries of a sparse matrix are, row by row: those of row i are row_begin[i] to row_begin[i + 1] - 1.
struct Pattern {
  std::string type_name;  ///< PascalCase
  std::string about;
  int rows = 0;
  int columns = 0;
  std::vector<int> row_begin;  ///< rows + 1
  std::vector<int> column;     ///< of each entry
};

/// One member of a result struct. `shape` is {} for a scalar, {n} for S name[n], {n, m} for S name[n][m].
struct Field {
  std::string name;
  std::string about;  ///< meaning, unit, frame, sign
  std::vector<int> shape;
  std::vector<NodeId> values;           ///< row-major, as many as the shape says
  std::optional<Pattern> pattern = {};  ///< of a sparse matrix: values are its entries
};

/// A named group of fields, such as everything about one constraint; `name` empty: members of the result struct itself.
struct Group {
  std::string name;
  std::string type_name;  ///< of the nested struct, PascalCase
  std::string about;
  std::vector<Field> fields;
};

/// What is known of a result when code is generated: a static member of its struct.
struct Constant {
  std::string name;
  bool value = false;
  std::string about;
};

/// Temporaries that are printed together under one comment. Nodes that the function does not need are left out, and so
/// is a section without any.
struct Section {
  std::string comment;  ///< what it is, the equation, the model line; may have several lines
  std::string
      subject;  ///< element of the model that it is about, resolved into `comment` by the pipeline; may be empty
  std::vector<std::pair<NodeId, std::string>> nodes;  ///< in order of printing, with the physical name wanted
};

/// Conditions that make the result of a function untrustworthy: boolean nodes; absent ones are constant 0.
/// To the values of `not_finite`, the emitter adds the arguments of the function.
struct StatusNodes {
  NodeId singular_mass_matrix;
  NodeId dependent_constraints;
  NodeId not_finite;
  NodeId violated_constraints;
};

enum class Target {
  derivative,  ///< fills Derivative<S>: configuration rates, then accelerations
  state,       ///< fills State<S>: configuration, then speeds (initial_state, project)
  result,      ///< fills the struct `result_type`
};

/// A call of another function with target state, which takes the state that was reached to the next.
struct Call {
  std::string function;
  int times = 1;
  bool takes_state = true;   ///< false: it makes the first state out of nothing
  bool takes_start = false;  ///< with the state before the first call as well
};

/// What the status of a solution has to say.
enum class Shown {
  motion,     ///< accelerations
  reactions,  ///< and multipliers, which may not be unique
  step,       ///< a change of the state, of which the next one shows whether constraints agree
  rank,       ///< what the constraints leave, whatever forces are
};

/// Derivatives of the accelerations by many variables: the same linear system with other right sides. Row i of a member begins at entry `base` + i `columns`, and
/// its entry k is by variable `first` + k.
struct Rates {
  struct Block {
    std::string member;  ///< of the result
    int base = 0, columns = 0, first = 0;
  };
  std::string sides, type;  ///< function of the solution, and the struct that it fills: f[count][n_v], drift[count][l]
  int count = 0, speeds = 0;
  std::vector<Block> blocks;
};

/// A function that turns to the general solution of the constrained system where its own way is not to be trusted.
struct TwoWays {
  std::string regular;      ///< function of the own way; empty: there is none
  std::string system;       ///< function that fills the struct of the same name
  std::string of_solution;  ///< function that makes the results of accelerations and multipliers; of a rank, none
  int usual_rank = 0;       ///< of the constraints, where nothing singles a state out
  int rows = 0;             ///< of them; where they always follow from each other, the own way is always lost
  Shown shown = Shown::motion;
  bool is_agreement_known = false;                       ///< whether rows contradict each other is told by positions
  std::optional<support::Rational> rank_tolerance = {};  ///< the model's own
  std::optional<Rates> rates = {};                       ///< these entries of the result are left to them
};

/// One emitted function.
struct Artefact {
  std::string name;         ///< rhs, reactions, rhs_and_reactions, energy, …
  std::string output = {};  ///< to which it belongs: reactions, of the two
  std::string about;        ///< comment above the function, several lines allowed
  bool takes_time = true;
  bool takes_state = true;
  bool takes_inputs = true;
  bool extends_preparation = true;   ///< false (initial_state): parameter-only values stay inside the function
  bool takes_accelerations = false;  ///< an extra `const Derivative<S>&`: candidate accelerations
  bool takes_start = false;          ///< an extra `const State<S>&`: Unit::start
  bool takes_solution = false;       ///< an extra `const LinearSolution<S, n_v, n_constraints>&`
  Target target = Target::result;
  std::vector<NodeId> derivative;  ///< target derivative (also beside groups, for rhs_and_reactions): n_q + n_v values
  std::vector<NodeId> state;       ///< target state: n_q + n_v values
  std::vector<Call> calls;         ///< likewise, instead of values: of functions that come before this one
  /// Where calls are repeated until one moves nothing, for each component of the state: 1, it is measured by 1 besides its own size (angles); 0.
  std::vector<int> measured_by_one;
  std::optional<TwoWays> ways;  ///< instead of values: these functions come before this one
  std::string result_type;      ///< struct name, such as Reactions; several artefacts may fill the same struct
  std::vector<Group> groups;
  std::vector<Constant> constants;
  std::vector<Section> sections;
  StatusNodes status;
  bool is_part = false;    ///< of a function in two ways
  bool is_series = false;  ///< instead of a derivative, power series of the state are filled

  /// It has no values of its own.
  bool is_caller() const { return ways || !calls.empty(); }
};

struct Provenance {
  std::string tool_version;
  std::string model_file;  ///< base name
  std::string model_hash;
  std::string command;   ///< the options that matter, without paths
  std::string strategy;  ///< one sentence: how the accelerations are found, and why that is safe
  std::vector<std::string> notes;
};

/// Chosen by measurement: below, compilers are not faster, and above, they take more than twice the time for twice the operations.
inline constexpr int k_part_operations = 1500;

struct Unit {
  std::string model_name;
  std::string about;
  std::string name_space;  ///< such as gauss::sphere_in_cylinder
  Provenance provenance;
  std::vector<ParameterEntry> parameters;
  std::vector<InputEntry> inputs;
  std::vector<Entry> configuration;  ///< n_q
  std::vector<Entry> start;          ///< n_q or none; likewise named, of the state from which a search began
  std::vector<Entry> speeds;         ///< n_v; names as emitted: chi_dot, wx
  std::vector<Entry> accelerations;  ///< n_v; names as emitted: chi_ddot, wx_dot
  std::vector<Entry> multipliers;    ///< of a solution, or none
  std::vector<std::string> configuration_rates;  ///< n_q, names in Derivative: chi_dot, e0_dot
  std::vector<HeldEntry> held;
  std::vector<ConstraintEntry> constraints;
  std::vector<Artefact> artefacts;
  SymbolId time;
  SymbolId epsilon;                         ///< rounding unit of S
  int part_operations = k_part_operations;  ///< functions of more than twice as many are split
  std::vector<std::string> compiled_for;    ///< scalar types of a source file of its own; empty: there is none
  bool folded = false;                      ///< parameters are numbers already; Parameters<S> is empty
  std::vector<std::string> as_written;      ///< rules against cancellation that are left out
  bool optimised = true;                    ///< false: values are computed as they were derived, without rewriting them
};

}  // namespace gaussgen::emit
