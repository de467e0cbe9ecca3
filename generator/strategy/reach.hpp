#pragma once
// How large an expression would be if everything stood as it stands worst for it.

#include <array>
#include <cstddef>
#include <optional>

#include "ir/expr.hpp"
#include "ir/node_table.hpp"

namespace gaussgen::strategy {

/// What |e| can be at most where parts may turn as they like, and lengths, masses and all else stay as they are: sines, cosines and components
/// of unit quaternions count as 1, and so nothing cancels between them. What is behind several names stays as it is: through all links of a long chain, such
/// sizes would grow beyond every number. A response that is small beside this is one of a row
/// that nearly vanishes here, as at the change point of a linkage.
class Reach {
 public:
  explicit Reach(ir::Graph& graph) : graph_(graph) {}

  /// Nothing where nothing turns.
  std::optional<ir::Expr> operator()(ir::Expr e);

 private:
  static constexpr std::size_t k_names = 2;

  struct Entry {
    bool turns = false;  ///< it has a part that turns
    ir::NodeId reach;
  };

  /// `names`: through how many it may still look.
  Entry of(ir::NodeId id, std::size_t names);
  Entry found(ir::NodeId id, std::size_t names);
  bool is_turn(ir::NodeId id) const;
  Entry of_sum(const ir::Node& node, std::size_t names);
  Entry of_product(const ir::Node& node, std::size_t names);

  ir::Graph& graph_;
  std::array<ir::NodeTable<Entry>, k_names + 1> found_;
};

}  // namespace gaussgen::strategy
