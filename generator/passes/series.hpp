#pragma once
// Power series of all values of a function along a motion: the coefficient of order k of each by those of its operands. Every recurrence
// that is not linear is a sum  Σ_{j=1}^{k-1} left_j right_{k-j}  over lower orders, one for each column below, and a few terms
// with coefficients of orders 0 and k (Griewank and Walther, Evaluating Derivatives, 2nd ed., 13.2; Knuth, TAOCP 2, 4.7).

#include <functional>
#include <vector>

#include "ir/graph.hpp"

namespace gaussgen::passes {

using ir::Graph;
using ir::NodeId;
using ir::Rational;

/// Values stand by their nodes, without names around them.
struct SeriesValue {
  enum class Kind {
    time,
    state,        ///< a component of it
    sum,          ///< Σ coefficients[i] operands[i], of those that vary
    scaled,       ///< operands[0] operands[1], of which the first is constant over a step
    product,      ///< operands[0] operands[1]
    square,       ///< operands[0]^2
    quotient,     ///< operands[0] / operands[1]
    square_root,  ///< of operands[0]
    rates,        ///< divisor y' = Σ coefficient factor of': of every function that solves such an equation
    choice,  ///< select(condition, operands[0], operands[1]), of a condition that is constant over a step, or tells whether a pivot is lost
  };
  /// coefficient factor of', in y'
  struct Term {
    Rational coefficient;
    NodeId factor;
    NodeId of;
    bool has_column = false;  ///< neither is constant
    std::size_t column = 0;   ///< of (of', factor)
  };

  NodeId id;
  Kind kind;
  ir::Children operands = {};
  ir::Coefficients coefficients = {};
  std::vector<Term> terms = {};
  std::vector<NodeId> divisor = {};  ///< none or one
  NodeId inverse = {};               ///< of what is divided by, at order 0
  NodeId condition = {};
  std::size_t column = 0;  ///< of products; of squares; of (y', divisor)
};

/// Two values whose coefficients are multiplied crosswise.
struct SeriesColumn {
  NodeId left;
  bool is_rate;  ///< of the left one, coefficient j is taken j times: those of its rate
  NodeId right;
};

struct Series {
  std::vector<SeriesValue>
      values;  ///< what varies, operands first; a value and the factors of its rates may need each other
  std::vector<SeriesColumn> products;
  std::vector<NodeId> squares;
  std::vector<NodeId> at_start;  ///< values and conditions of order 0 that the recurrences take
  std::vector<NodeId>
      edges;  ///< functions with a jump or a kink in what varies: a series does not see it, so there is none
};

/// Of all that `roots` depend on. `varies` is true for the symbols that change within a step; others are constants. Nodes that the recurrences need
/// besides (the cosine of a sine) are added to the graph.
Series series_of(Graph& graph, const std::vector<NodeId>& roots, const std::function<bool(ir::SymbolId)>& varies,
                 ir::SymbolId time);

}  // namespace gaussgen::passes
