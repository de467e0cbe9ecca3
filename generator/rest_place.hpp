#pragma once
// A place of a model at rest with its multipliers, in double or with as many digits as it takes, and how it moves on from there.

#include <optional>
#include <string>
#include <vector>
#include "dense.hpp"

#include "evaluate/arithmetic_paired.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/evaluator.hpp"
#include "rest_equations.hpp"

namespace gaussgen {

/// In which numbers a search goes.
template <class T>
struct RestNumber;

template <>
struct RestNumber<double> {
  using Real = double;
};

template <>
struct RestNumber<evaluate::Paired> {
  using Real = cln::cl_F;
};

inline double to_double(double value) { return value; }
inline double to_double(const cln::cl_F& value) { return cln::double_approx(value); }

/// Instances for double and Paired are in rest_place.cpp.
template <class T>
class RestPlace {
 public:
  using Real = typename RestNumber<T>::Real;

  RestPlace(Mechanics& mechanics, const RestEquations& rest, const support::Rational& time,
            evaluate::Arithmetic<T> arithmetic);

  /// To where the model starts, or to its guesses if these lead nowhere; false if they have no value either. Multipliers are 0.
  bool start();

  /// Quaternions become of unit length.
  void set(std::vector<Real> position, std::vector<Real> multipliers);
  void set_time(const support::Rational& time);

  /// By `unit` times a change along speeds and in multipliers; along a path on which constraints on velocities hold if it `is_held`.
  void move(const Eigen::VectorXd& change, const Real& unit, bool is_held);

  const std::vector<Real>& position() const { return position_; }
  const std::vector<Real>& multipliers() const { return multipliers_; }

  /// So far, of paths on which constraints on velocities hold.
  long short_steps() const { return short_steps_; }

  Real number(const support::Rational& value) const;
  Real number(double value) const;

  std::optional<Real> value_of(ir::NodeId node);
  double plain(ir::Expr expression);    ///< 0 where it has no value
  double size_of(ir::Expr expression);  ///< of what it is made of; likewise
  Eigen::MatrixXd rows_of(const std::vector<std::vector<ir::Expr>>& entries);

  /// Why it has no value, and where; nothing if it has one.
  std::optional<std::string> trouble(ir::Expr expression);

 private:
  using Vector = std::vector<Real>;

  void bind(ir::SymbolId symbol, const Real& value);
  void bind_position(const Vector& position);
  std::optional<Vector> position_of(const std::vector<ir::NodeId>& state);
  Vector along_path(const Eigen::VectorXd& speeds, const Real& unit);
  Vector rates_at(const Vector& position, const Eigen::VectorXd& speeds, const Eigen::VectorXd& closing);
  Vector rates(const Eigen::VectorXd& speeds);

  Mechanics& mechanics_;
  const RestEquations& rest_;
  evaluate::Evaluator<T> values_;
  evaluate::Evaluator<evaluate::Scaled<double>> sizes_;
  Vector position_;
  Vector multipliers_;
  long short_steps_ = 0;
};

}  // namespace gaussgen
