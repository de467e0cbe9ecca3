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

 private:
  bool is_elsewhere();
  std::vector<double> displacement(double part);

  PositionEquations equations_;
  RepeatedNumbers& numbers_;
  std::vector<double>
      begin_;  ///< a solution where one is found from the guess, else the guess; empty where it has no value
  std::vector<double> spans_;
};

}  // namespace gaussgen
