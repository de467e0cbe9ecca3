#pragma once
// How the coordinates of a model map their rates to motions of its bodies, as numbers at one configuration after another.

#include <memory>
#include <optional>
#include <vector>
#include "dense.hpp"

#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// S with SᵀS = g of the free speeds (1.10), the rows of the constraints below it. Of g itself the least singular value would have half of
/// the digits. On a graph of its own, so that emitted code does not depend on who asks.
class ChartMap {
 public:
  explicit ChartMap(const Mechanics& mechanics);

  /// At the parameters of the model, t = 0; nothing where an entry has no finite value.
  std::optional<Eigen::MatrixXd> operator()(const std::vector<double>& configuration);

  /// ∂q̇/∂u over plain coordinates: of speeds that take the place of rates.
  std::optional<Eigen::MatrixXd> rates(const std::vector<double>& configuration);

  /// Rows that are of bodies; those of constraints follow.
  Eigen::Index inertial_rows() const { return inertial_rows_; }

  /// How many nodes one evaluation computes at most.
  std::size_t nodes() const { return own_.graph.size(); }

 private:
  using Rows = std::vector<std::vector<ir::NodeId>>;

  struct Body {
    ir::NodeId mass;
    bool is_rigid = false;
    std::vector<ir::NodeId> inertia;  ///< by rows
    Rows J, W;                        ///< 3×n
  };

  void bind(const std::vector<double>& configuration);
  std::optional<Eigen::MatrixXd> values(const Rows& rows);
  bool add(const Body& body, Eigen::Index& row, Eigen::MatrixXd& result);

  KinematicModel own_;
  evaluate::Evaluator<double> values_;
  std::vector<Body> bodies_;
  Rows constraints_;
  Eigen::Index inertial_rows_ = 0;
};

}  // namespace gaussgen
