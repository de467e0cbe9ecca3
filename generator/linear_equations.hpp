#pragma once
// The motion of a model near one of its states, as numbers: what `linearize` is made of.

#include <optional>
#include <string>
#include <vector>

#include "analysis/matrix.hpp"
#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// On the graph: rates of the state, constraints, and how both change with the state.
struct LinearEquations {
  explicit LinearEquations(Mechanics& mechanics);

  strategy::Vector rates;     ///< of the configuration, then accelerations
  strategy::Matrix by_state;  ///< of each rate
  strategy::Matrix by_inputs;
  strategy::Matrix by_time;  ///< one column
  strategy::Matrix turns;  ///< δq of displacements, a column for each speed: δq itself, and ∂ė/∂ω for quaternions
  strategy::Matrix turn_rates;  ///< how these change along the motion
  strategy::Vector positions;   ///< f of equations of positions
  strategy::Matrix positions_by_configuration;
  strategy::Vector velocities;  ///< φ of all constraints
  strategy::Matrix velocities_by_state;
};

/// These at one state, in displacements: n along the speeds (of a quaternion three small turns about the axes of its angular velocity),
/// then n speeds. A displacement that goes with the motion, as the turn of a wheel does, has no part in it.
struct LinearNumbers {
  analysis::Vector rates;      ///< of displacements and speeds
  analysis::Matrix by_state;   ///< 2n × 2n
  analysis::Matrix by_inputs;  ///< 2n × inputs
  analysis::Vector by_time;
  analysis::Vector positions, velocities;
  analysis::Matrix positions_by_state;   ///< n columns
  analysis::Matrix velocities_by_state;  ///< 2n columns
};

/// A state of a model in numbers of one type. Instances for double and cl_F.
template <class T>
class StatePoint {
 public:
  using State = std::vector<T>;

  StatePoint(Mechanics& mechanics, const LinearEquations& equations, const support::Rational& time,
             evaluate::Arithmetic<T> arithmetic);

  /// False where part of the initial state has no value.
  bool start();

  void set(State state);
  void set_time(const support::Rational& time);
  /// By unit * displacements and speeds; quaternions stay of unit length.
  void move(const analysis::Vector& change, const T& unit);

  const State& state() const { return state_; }

  T number(const support::Rational& value) const;
  T number(analysis::Real value) const;

  /// Nothing where a value is undefined; `trouble` says which.
  std::optional<LinearNumbers> numbers();

  /// Rates alone; positions and velocities of constraints. Nothing as above.
  std::optional<std::vector<T>> values(const strategy::Vector& nodes);
  std::string trouble();

 private:
  analysis::Matrix matrix(const strategy::Matrix& nodes);
  void note(const strategy::Vector& nodes);

  Mechanics& mechanics_;
  const LinearEquations& equations_;
  evaluate::Evaluator<T> values_;
  State state_;
  std::string trouble_;
};

analysis::Real to_real(double value);
analysis::Real to_real(const cln::cl_F& value);

}  // namespace gaussgen
