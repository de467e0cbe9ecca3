#pragma once
// A model as the generator solves it, state by state, in double.

#include "../conditioning.hpp"
#include "newton/course.hpp"

namespace agreement::newton {

struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
};

class Specimen {
 public:
  explicit Specimen(gaussgen::model::Model model);

  /// False where rounding would say more than mechanics: κ > 1e8, or no result.
  bool at(const State& state);

  const gaussgen::model::Model model;
  gaussgen::Mechanics mechanics;
  Values fixed;  ///< parameters, inputs, pi

  State state;
  double condition = 1;
  std::vector<double> a, lambda, R;
  std::vector<Wrench> on_bodies;  ///< about the mass centres
  std::vector<Wrench> in_joints;  ///< on the child, about its origin
  double kinetic = 0, potential = 0;
  double energy_rate = 0;  ///< of the generator's expression, along its own motion

  /// What the generator says of a node at the state.
  double value(gaussgen::ir::NodeId node);

 private:
  using Nodes = std::array<gaussgen::ir::Vector3, 2>;

  void add_energy_rate();
  Wrench wrench(const Nodes& nodes);

  Evaluator<double> evaluator_;
  std::vector<Nodes> bodies_;
  std::vector<Nodes> joints_;
  gaussgen::ir::NodeId energy_rate_;
};

}  // namespace agreement::newton
