#pragma once
// A specimen at its state with all that the laws need: motions, loads, and which part belongs to what.

#include "newton/loads.hpp"
#include "newton/specimen.hpp"

namespace agreement::newton {

class Setting {
 public:
  explicit Setting(Specimen& specimen);

  Specimen& specimen;
  const gaussgen::model::Model& model;
  Course course;
  Motion motion;
  Motion time;
  std::vector<Load> loads;
  std::vector<std::vector<Load>> actions;  ///< by constraint, per multiplier
  std::vector<Motion> displaced;           ///< along each coordinate, held ones last
  Eigen::MatrixXd beta;                    ///< ∂φ/∂ẏ
  Eigen::VectorXd drift;                   ///< dφ/dt without free accelerations

  /// Sizes of the terms that m a and dH/dt are sums of, by body: what cancels in them leaves its rounding.
  struct Terms {
    double force = 0;
    double moment = 0;
  };
  std::vector<Terms> terms;

  /// Likewise of all the work of inertia and loads along a displacement.
  double size_of_work(Motion& displacement);

  Vector centre(const gaussgen::model::Body& body) { return motion.point(body.frame, motion(body.centre)); }

  bool acts_on(const Load& load, std::size_t body) const;
  std::optional<std::size_t> joint_at(std::size_t frame) const;
  /// The joint that carries a frame, through frames without one.
  std::optional<std::size_t> link_of(std::size_t frame) const;
  /// Whether the frame moves against its parent.
  bool moves(const gaussgen::model::Frame& frame) const;
  /// Whether joints make all the motion and carry all that acts.
  bool is_of_joints() const;

 private:
  std::optional<std::size_t> body_of(std::size_t frame) const;
  std::optional<std::size_t> only_body_of(std::size_t part) const;
  /// What frames are fixed to that do not move against each other.
  std::size_t part_of(std::size_t frame) const;
  bool varies(const gaussgen::model::Ast& ast) const;
  void find_beta();
  void find_terms();
};

Sum work_of_loads(const std::vector<Load>& loads, Motion& displaced);

}  // namespace agreement::newton
