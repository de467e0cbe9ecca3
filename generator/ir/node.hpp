#pragma once
// What a node of the expression graph is.

// It copies its places also where nothing is in them, which g++ 12 takes for a mistake.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <absl/container/inlined_vector.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "support/rational.hpp"

namespace gaussgen::ir {

using support::Rational;

/// Index of a node in its Graph. Equal ids mean equal expressions (hash-consing).
struct NodeId {
  std::uint32_t index = 0;
  friend bool operator==(NodeId a, NodeId b) { return a.index == b.index; }
  friend bool operator!=(NodeId a, NodeId b) { return a.index != b.index; }
};

/// Index of a declared symbol in its Graph.
struct SymbolId {
  std::uint32_t index = 0;
  friend bool operator==(SymbolId a, SymbolId b) { return a.index == b.index; }
};

/// Index of a declared table in its Graph.
struct TableId {
  std::uint32_t index = 0;
  friend bool operator==(TableId a, TableId b) { return a.index == b.index; }
};

/// Index of a name in its Graph; 0 is none.
struct NameId {
  std::uint32_t index = 0;
  friend bool operator==(NameId a, NameId b) { return a.index == b.index; }
  friend bool operator!=(NameId a, NameId b) { return a.index != b.index; }
};

/// What a symbol stands for. The order of this list is the order of factors in printed products.
enum class SymbolClass : std::uint8_t {
  pi,
  epsilon,    ///< rounding unit of the scalar type of the run
  parameter,  ///< plain run-time constant
  time,
  configuration,  ///< q: free coordinates and quaternion components
  held,           ///< x^i, replaced by c^i(t) before anything is emitted
  speed,          ///< u: rates of free coordinates and angular velocity components
  held_rate,      ///< dx^i/dt, likewise replaced
  acceleration,   ///< du/dt where a caller supplies it (compulsion, residuals)
  held_acceleration,
  input,
  opaque,  ///< a value bound later, such as an entry of an inverse on the paper's route
};

struct Symbol {
  SymbolClass symbol_class;
  std::string name;
  bool is_of_unit_quaternion = false;
};

enum class Kind : std::uint8_t {
  constant,  ///< value
  symbol,
  sum,      ///< value + Σ coefficients[i] * children[i]
  product,  ///< Π children[i]
  power,    ///< children[0] ^ value, value rational, neither 0 nor 1
  function,
  named,  ///< children[0] under a name: opaque to simplification, so that shared parts stay shared
};

enum class Function : std::uint8_t {
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  exp,
  log,
  sinh,
  cosh,
  tanh,
  // Chosen by comparisons; whatever is not a number in them, or in the condition, stays so.
  abs,
  sign,
  min,
  max,        ///< of two; of equal ones, the first
  piecewise,  ///< condition ? a : b; the condition is `less` or `at_most`; what is not chosen may have no value
  table,      ///< a derivative of a table, see Node::table; `value` is its order
  // Boolean values; they reach only `any` and `select`.
  less,        ///< a < b
  at_most,     ///< a <= b
  not_finite,  ///< some argument is infinite or not a number
  any,         ///< logical or
  select,      ///< condition ? a : b
};

/// True for what changes between two evaluations with the same parameters.
inline bool varies(const Symbol& symbol) {
  return symbol.symbol_class != SymbolClass::pi && symbol.symbol_class != SymbolClass::epsilon &&
         symbol.symbol_class != SymbolClass::parameter;
}

std::string_view name_of(Function function);
bool is_boolean(Function function);
/// Chosen among its arguments by comparisons, without a computation: abs to piecewise, and select.
bool is_choice(Function function);

/// Of a function of one argument: f(-x) = -f(x), f(-x) = f(x), or neither.
enum class Parity { none, odd, even };
Parity parity(Function function);

// Most nodes have few: in the node, they take no memory of their own.
using Children = absl::InlinedVector<NodeId, 4>;
using Coefficients = absl::InlinedVector<Rational, 2>;

// There are many, and passes read them in an order that no processor guesses: one fills a line of the cache.
struct Node {
  Node() : symbol{} {}

  Kind kind = Kind::constant;
  Function function = Function::sin;
  // A node has one of them at most. Each is a number, and of each the number may be read whichever it is.
  union {
    SymbolId symbol;  ///< kind symbol
    TableId table;    ///< function table
    NameId name;      ///< kind named; see Graph::name
  };
  Rational value = 0;
  Children children;
  Coefficients coefficients;  ///< kind sum, parallel to children
};

static_assert(sizeof(Node) <= 64 || sizeof(void*) > 8, "a node is larger than a line of the cache");

/// As what the functions of Graph take.
inline std::vector<NodeId> listed(const Children& children) { return {children.begin(), children.end()}; }

}  // namespace gaussgen::ir
