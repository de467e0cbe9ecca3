#pragma once
// One state of a model, and the motions through it: the actual one, and displacements along single coordinates.

#include "../models.hpp"
#include "newton/motion.hpp"

namespace agreement::newton {

/// Values of parameters, inputs and pi.
Values constants(const gaussgen::model::Model& model);

/// The same values where nothing moves.
Values at_rest(const Values& values);

/// The order is that of the generator's results: free coordinates, then the angular velocities, three for each orientation; after
/// them the held coordinates.
class Course {
 public:
  Course(const gaussgen::model::Model& model, const Values& constants, const State& state);

  std::size_t free_count() const { return state_.speeds.size(); }
  std::size_t full_count() const { return free_count() + held_.size(); }

  /// Along the speeds of the state, with these derivatives of theirs.
  Motion motion(const std::vector<Real>& accelerations) { return motion(accelerations, held_.size()); }

  /// Likewise from rest of all speeds but for index `i`, held ones included, whose derivative is 1: what depends on accelerations
  /// linearly, less the same of `motion` with none, is its coefficient.
  Motion unit_acceleration(std::size_t i);

  /// Rates are displacements per unit of the speed `i`, or of held coordinate i - free_count(), in an instant; that of a speed is
  /// its own.
  Motion displacement(std::size_t i);

  /// What moves in time by itself: explicit time alone, while coordinates rest, unless rheonomic speeds move them.
  Motion passage_of_time();

  /// dy^A/dt, held ones included.
  std::vector<Real> rates() const;

  const std::vector<std::size_t>& held() const { return held_; }

 private:
  Motion motion(const std::vector<Real>& accelerations, std::size_t pushed);
  void bind_orientation(std::size_t index, const std::vector<Real>& accelerations, Values& values) const;
  void displace_orientation(std::size_t index, const std::vector<Real>& speeds, Values& values) const;
  void solve_rates();
  void solve_second(const std::vector<Real>& accelerations, Values& values) const;
  VectorX of_definitions(Values values, bool second) const;
  void displace(const std::vector<Real>& speeds, Values& values) const;

  const gaussgen::model::Model& model_;
  State state_;
  Values fixed_;                   ///< constants, time, held coordinates
  std::vector<std::size_t> free_;  ///< indices into Model::coordinates
  std::vector<std::size_t> held_;  ///< likewise
  std::vector<std::size_t> slow_;  ///< of free_, those whose rate follows from speeds
  std::vector<Real> rates_;        ///< of free_
  MatrixX from_speeds_;            ///< ∂q̇/∂u of slow_
  VectorX drift_;                  ///< q̇ of slow_ where all u vanish
};

}  // namespace agreement::newton
