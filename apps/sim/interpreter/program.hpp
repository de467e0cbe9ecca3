#pragma once
// The functions of a header as instructions, for every scalar type.

#include <string>
#include <string_view>
#include <vector>

#include "emit/cpp_tree.hpp"
#include "sim/interpreter/instruction.hpp"
#include "sim/interpreter/layout.hpp"

namespace gausssim {

struct Parameter {
  std::string type;  ///< a struct, `S`: one scalar, or `StatusOf`: one scalar that is the number of a status
  std::string name;
  bool is_result = false;
};

struct Function {
  std::string name;
  std::vector<Parameter> parameters;  ///< in order; what is returned by value comes last
  std::size_t first_argument = 0;     ///< in the table of arguments of a frame
  std::size_t begin = 0;              ///< in Program::code
};

/// A number of the header; what it is in S is found out with the machine of S.
struct Constant {
  enum class Kind { number, pieces, quotient, pi, epsilon };
  Slot slot = 0;
  Kind kind = Kind::number;
  bool is_negative = false;
  double a = 0, b = 0, c = 0;
};

/// Of a call, one argument: scalars of the caller, or of what it was given itself.
struct Passed {
  bool is_argument = false;
  std::uint32_t place = 0;  ///< slot, or argument
  std::uint32_t offset = 0;
};

struct Call {
  std::size_t function = 0;
  std::vector<Passed> arguments;
};

enum class RankRuleKind { positions, velocities, steps };

/// Most speeds of a system that is solved, and most constraints: it lies on the stack then.
inline constexpr int k_most_of_system = 128;

/// A call of `solve`, or of `solve_each`.
struct Solve {
  int speeds = 0, rows = 0, sides = 0;
  // Where the members of the system begin.
  Slot g = 0, f = 0, b = 0, reach = 0, of_positions = 0, off = 0, drift = 0, drift_error = 0;
  RankRuleKind rule = RankRuleKind::velocities;
  int usual = 0;
  bool has_tolerance = false;
  Slot tolerance = 0;
  Slot solution = 0;  ///< as layout_of_solution; of solve_each: accelerations, one set after the other
  Slot forces = 0, drifts = 0;
};

/// Where the entries of a sparse result are: one of the header's pattern structs.
struct Pattern {
  std::string name;
  int rows = 0, columns = 0;
  std::vector<int> row_begin, column;
};

struct Program {
  std::vector<Instruction> code;
  std::vector<std::uint32_t> operands;
  std::vector<Constant> constants;
  std::vector<Call> calls;
  std::vector<Solve> solves;
  std::size_t slots = 0;      ///< scalars that a frame has
  std::size_t arguments = 0;  ///< pointers that it has

  std::vector<Function> functions;
  std::vector<Layout> structs;
  std::vector<Pattern> patterns;

  int find(std::string_view function) const;             ///< -1: there is none
  const Layout* struct_of(std::string_view type) const;  ///< null: there is none
};

/// All functions of the tree of a header but `dense`, which only spreads what a pattern says. A struct with default values, such as Parameters, is a function of
/// its own name that fills it. Throws NotRunnable.
Program compile(const gaussgen::emit::cpp::File& tree);

}  // namespace gausssim
