#pragma once
// The equations of positions of a model, and its constraints on speeds, as numbers in double at one position after another. For searches
// that decide how the model starts; no result is computed here.

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/evaluator.hpp"
#include "mechanics.hpp"

namespace gaussgen {

/// Equations f = 0 at one place.
struct Linearised {
  using Vector = std::vector<double>;

  Vector f;               ///< times the weights
  Vector size;            ///< of what f is made of, likewise
  std::vector<Vector> j;  ///< rows ∂f/∂(displacement along the speeds), likewise; zero along what does not move

  double square() const;
  double left() const;  ///< the largest f beside what it is made of
  /// What an equation is made of counts what such displacements make of it, too: one of a coordinate that has to be 0 is made of nothing else.
  void measure_by(const std::vector<double>& spans);
  bool is_solved(double part) const;  ///< no f is larger than this part of what it is made of

  /// The largest of what an f is made of, beside its change over a span of each displacement: by how much less exact than a double a position is that satisfies
  /// the equations, as 10⁶ where places are 10⁶ lengths off the origin. 1 at least. One that keeps no digits along any displacement, as a square at its zero, does not count.
  double amplification(const Vector& spans) const;
};

class PositionEquations {
 public:
  using Vector = std::vector<double>;

  /// Along the speeds that are `movable`.
  PositionEquations(Mechanics& mechanics, std::vector<bool> movable, double time);

  /// Goes to the guesses of the model; false where one has no value.
  bool start();

  /// Quaternions become of unit length.
  void set(Vector q);
  /// As if they were made for these, and had started.
  void set(Vector q, std::vector<bool> movable);
  void move(const Vector& along_speeds);

  /// By a little of these spans: where a derivative vanishes by symmetry, as that of x² - 1 at 0, a search does not find its way.
  void leave_symmetry(const Vector& spans);

  /// From here on equations are in units of displacements: times 1 / (the largest derivative here).
  void weigh();

  /// By its unit: in a model without units anything may be one.
  bool may_be_angle(std::size_t variable) const;

  /// By whole turns to its guess, if it is an angle; false where it is as near already.
  bool unwind(std::size_t variable);

  /// Nothing where a value is undefined or not finite.
  std::optional<Linearised> linearised();

  /// φ and ∂φ/∂u of all constraints over the speeds that are `open`; nothing as above.
  std::optional<Linearised> of_speeds(const Vector& u, const std::vector<bool>& open);

  /// Of the guess.
  Vector speeds();

  /// g_αα
  Vector inertias();

  /// g_αβ over what moves, and zero elsewhere.
  std::vector<Vector> metric();

  const Vector& position() const { return q_; }
  const std::vector<bool>& movable() const { return movable_; }
  std::size_t constraint(std::size_t row) const { return rows_[row].value; }  ///< into Model::constraints
  double weight(std::size_t row) const { return weights_[row]; }

 private:
  using Number = evaluate::Scaled<double>;

  void bind(ir::SymbolId symbol, double value);
  bool add(ir::Expr f, const kinematics::ConstraintRow& row, const std::vector<bool>& moves, double weight,
           Linearised& result);

  Mechanics& mechanics_;
  std::vector<bool> movable_;
  double time_;
  evaluate::Evaluator<Number> values_;
  std::vector<kinematics::ConstraintIndex> rows_;  ///< with an equation of positions
  Vector weights_;
  Vector q_;
  Vector guess_;
};

}  // namespace gaussgen
