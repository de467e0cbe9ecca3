#pragma once
// Places that nothing singles out, on the equations of positions: what is so there is so in general.

#include <optional>
#include <vector>

#include "mechanics.hpp"
#include "position_equations.hpp"
#include "repeated_numbers.hpp"

namespace gaussgen {

class UsualPlaces {
 public:
  /// At a time; the numbers say where.
  UsualPlaces(Mechanics& mechanics, double time, RepeatedNumbers& numbers);

  /// Goes to another one; false where none is found. This part of what equations are made of may be left there.
  bool next(double solved = 1e-13);

  /// There.
  PositionEquations& equations() { return equations_; }

  /// How far what is left of equations of positions there, rounding or more, turns the gradients of constraints, as a sine. Equations that are double roots leave
  /// squares of what a place is off by.
  double rounding();

  /// The searches so far ended where they began, at a solution: no other one is near, as far as they see.
  bool came_back() const { return is_solution_ && came_back_ && !went_on_; }

  /// To where the searches begin.
  void go_back() { equations_.set(begin_); }

  /// Beside that, where equations of positions do not hold.
  void go_beside();

 private:
  bool is_elsewhere();
  bool is_beyond(double part) const;  ///< of a reach from where the search began
  std::vector<double> displacement(double part);
  std::vector<double> reaches();

  PositionEquations equations_;
  RepeatedNumbers& numbers_;
  std::vector<double>
      begin_;  ///< a solution where one is found from the guess, else the guess; empty where it has no value
  std::vector<double> spans_;    ///< of speeds
  std::vector<double> reaches_;  ///< of configuration variables, over a span of any speed
  bool is_solution_ = false, came_back_ = false, went_on_ = false;
};

}  // namespace gaussgen
