#pragma once
// How large an expression can be in any configuration.

#include <functional>
#include <optional>

#include "ir/node_table.hpp"
#include "strategy/ldl.hpp"

namespace gaussgen::strategy {

/// Of parameters and numbers alone, not less than |e| whatever coordinates are: a sum by its terms, a product by its factors, a sine or cosine
/// by 1. Nothing where e has no such bound, as with a length that changes.
class Bounds {
 public:
  explicit Bounds(ir::Graph& graph) : graph_(graph) {}

  std::optional<ir::Expr> operator()(ir::NodeId id);

 private:
  std::optional<ir::Expr> of(ir::NodeId id);
  std::optional<ir::Expr> of_sum(const ir::Node& node);
  std::optional<ir::Expr> of_product(const ir::Node& node);
  std::optional<ir::Expr> of_power(const ir::Node& node);
  ir::Expr number(const ir::Rational& value) const { return {graph_, graph_.constant(value)}; }

  ir::Graph& graph_;
  ir::NodeTable<std::optional<ir::Expr>> found_;
};

/// The same, of one expression.
std::optional<ir::Expr> bound_of(ir::Expr e);

/// Of each entry; its own size where it has no bound.
Matrix bounds_of(const Matrix& entries);

/// Whether it is a number, whatever its form.
bool is_number(ir::Expr e);

/// What inertia an acceleration that is put in brings beside that of another, at most, and what that was (docs/decisions/0010).
struct Addition {
  ir::Expr added, before;

  /// Rounding leaves nothing of `before` beside it, by the numbers of `estimate`.
  bool drowns(const std::function<double(ir::Expr)>& estimate) const;
  /// No parameter changes how many times the one is the other.
  bool is_known() const { return before.is_zero() || is_number(added / before); }
  /// What `before` has to be above for half of the digits to be left.
  ir::Expr least(ir::Expr epsilon) const { return pow(epsilon, ir::Rational(1) / 2) * added; }
};

}  // namespace gaussgen::strategy
