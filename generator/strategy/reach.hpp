#pragma once
// How large an expression would be if everything stood as it stands worst for it.

#include <optional>

#include "ir/expr.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::strategy {

/// What |e| can be at most where parts may turn as they like, and lengths, masses and all else stay as they are: sines, cosines and components
/// of unit quaternions count as 1, and so nothing cancels between them. A response that is small beside this is one of a row
/// that nearly vanishes here, as at the change point of a linkage.
class Reach {
 public:
  explicit Reach(ir::Graph& graph) : graph_(graph) {}

  /// Nothing where nothing turns.
  std::optional<ir::Expr> operator()(ir::Expr e);

 private:
  struct Entry {
    bool turns = false;  ///< it has such a part
    ir::NodeId reach;
  };

  Entry of(ir::NodeId id);
  bool is_turn(ir::NodeId id) const;
  ir::Expr of_sum(const ir::Node& node);
  ir::Expr known(ir::NodeId id) const { return {graph_, found_.find(id)->reach}; }
  bool turns(ir::NodeId id) const { return found_.find(id)->turns; }

  ir::Graph& graph_;
  ir::NodeTable<Entry> found_;
};

}  // namespace gaussgen::strategy
