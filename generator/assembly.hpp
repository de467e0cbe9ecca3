#pragma once
// Where a model starts: open positions that satisfy the constraints, found from as far away as it takes.

#include <optional>
#include <string>
#include <vector>

#include "mechanics.hpp"
#include "support/diagnostics.hpp"

namespace gaussgen {

/// In the order of a state: positions, then speeds. Nothing where the model says neither a value nor a guess.
using StatedStart = std::vector<std::optional<ir::Expr>>;

StatedStart stated_start(const model::Model& model, kinematics::Expressions& expressions);

/// A guess of the model that a longer search has replaced.
struct FoundGuess {
  std::string name;
  double value = 0;
  bool is_of_quaternion = false;
};

struct FoundStart {
  enum class Reason {
    far,     ///< emitted code would not have arrived
    choice,  ///< it would have found one, too, and rounding which
    turns,   ///< likewise, some whole turns on
  };
  std::vector<FoundGuess> guesses;
  Reason reason = Reason::far;
  int digits = 17;  ///< with so many written down as guesses, emitted code comes to the same position
};

/// Emitted code takes eight steps of Newton's method from the guesses. Where these do not arrive and a longer search does, the position
/// that it finds takes the place of the guesses, angles within half a turn of them; given values stay. So does one that the steps come to if it depends on
/// which they take of equations that follow from others, and one with angles more than half a turn from their guesses, less the turns. Nothing where the guesses serve, or where no search helps.
FoundStart improve_guesses(Mechanics& mechanics, model::Model& model, double time = 0);

/// Warns of them.
void report_found(const FoundStart& found, const model::Model& model, support::Diagnostics& diagnostics);

/// Where emitted code would find a position from the guesses: they become what double holds of it.
void refine_guesses(Mechanics& mechanics, model::Model& model, double time);

/// `--assemble`: given positions become guesses where they and the open ones do not satisfy the equations of positions, and given rates
/// where they and the open ones do not satisfy the constraints there.
void assemble(Mechanics& mechanics, model::Model& model, double time = 0);

}  // namespace gaussgen
