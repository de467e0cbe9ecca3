#include "assembly.hpp"

#include <cln/dfloat.h>
#include <cln/float.h>
#include <cln/real.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "nearest_position.hpp"
#include "strategy/projection.hpp"
#include "structure_check.hpp"
#include "support/error_codes.hpp"
#include "support/suggest.hpp"

namespace gaussgen {

namespace {

model::Ast number(double value, support::Span span) { return model::number(cln::rational(cln::cl_DF(value)), span); }

bool any(const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); }

/// Along which speeds a search for a position may go; nothing where none is to be found.
std::optional<std::vector<bool>> ways_of_search(Mechanics& mechanics, const model::Model& model) {
  std::vector<bool> movable = strategy::open_positions(model, mechanics.expressions);
  return mechanics.kinematics.has_positions() && any(movable) ? std::optional(std::move(movable)) : std::nullopt;
}

/// Guesses of what is open become this position; what changed by it.
std::vector<FoundGuess> take(const std::vector<double>& position, const std::vector<bool>& movable,
                             const Mechanics& mechanics, model::Model& model) {
  std::vector<FoundGuess> found;
  std::size_t next = 0;
  for (model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    const std::size_t i = next++;
    if (!movable[i] || coordinate.initial) continue;
    coordinate.guess = number(position[i], coordinate.name.span);
    found.push_back({coordinate.name.text, position[i], false});
  }
  for (std::size_t k = 0; k < model.orientations.size(); ++k) {
    model::Orientation& orientation = model.orientations[k];
    const std::size_t first = mechanics.symbols.first_quaternion_component[k].value;
    if (!orientation.is_open) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      orientation.initial[i] = number(position[first + i], orientation.name.span);
      found.push_back({orientation.quaternion[i].text, position[first + i], true});
    }
  }
  return found;
}

void open(std::optional<model::Ast>& value, std::optional<model::Ast>& guess) {
  if (!value) return;
  guess = std::move(value);
  value.reset();
}

/// Along these speeds.
void open_positions(model::Model& model, const std::vector<bool>& chosen) {
  std::size_t next = 0;
  for (model::Coordinate& coordinate : model.coordinates) {
    if (!coordinate.held_at && chosen[next++]) open(coordinate.initial, coordinate.guess);
  }
  for (model::Orientation& orientation : model.orientations) {
    for (std::size_t i = 0; i < 3; ++i) orientation.is_open = chosen[next++] || orientation.is_open;
  }
}

void open_rates(model::Model& model, const std::vector<bool>& chosen) {
  std::size_t next = 0;
  for (model::Coordinate& coordinate : model.coordinates) {
    if (!coordinate.held_at && chosen[next++]) open(coordinate.initial_rate, coordinate.rate_guess);
  }
  for (model::Orientation& orientation : model.orientations) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (chosen[next++]) open(orientation.initial_angular_velocity[i], orientation.angular_velocity_guess[i]);
    }
  }
}

/// Parallel to the state.
std::vector<bool> are_stated(const model::Model& model) {
  std::vector<bool> positions, speeds;
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    positions.push_back(coordinate.initial || coordinate.guess);
    speeds.push_back(coordinate.initial_rate || coordinate.rate_guess);
  }
  for (const model::Orientation& orientation : model.orientations) {
    positions.insert(positions.end(), orientation.initial.size(), true);
    for (std::size_t i = 0; i < 3; ++i)
      speeds.push_back(orientation.initial_angular_velocity[i] || orientation.angular_velocity_guess[i]);
  }
  positions.insert(positions.end(), speeds.begin(), speeds.end());
  return positions;
}

}  // namespace

StatedStart stated_start(const model::Model& model, kinematics::Expressions& expressions) {
  const strategy::Vector guessed = strategy::guessed_state(model, expressions);
  const std::vector<bool> stated = are_stated(model);
  StatedStart result;
  for (std::size_t i = 0; i < guessed.size(); ++i)
    result.push_back(stated[i] ? std::optional<ir::Expr>(guessed[i]) : std::nullopt);
  return result;
}

namespace {

/// Six digits where they serve: of a place far off the origin they would be another one.
int digits_that_serve(const std::vector<double>& position, const std::vector<bool>& movable, Mechanics& mechanics,
                      model::Model& model, double time) {
  for (const int digits : {6, 9, 12, 15}) {
    std::vector<double> rounded;
    for (const double value : position) rounded.push_back(std::stod(fmt::format("{:.{}g}", value, digits)));
    take(rounded, movable, mechanics, model);
    if (is_held_from(mechanics, movable, position, time)) return digits;
  }
  return std::numeric_limits<double>::max_digits10;
}

FoundStart taken(const std::vector<double>& position, FoundStart::Reason reason, const std::vector<bool>& movable,
                 Mechanics& mechanics, model::Model& model, double time) {
  const int digits = digits_that_serve(position, movable, mechanics, model, time);
  return {take(position, movable, mechanics, model), reason, digits};
}

}  // namespace

FoundStart improve_guesses(Mechanics& mechanics, model::Model& model, double time) {
  const auto movable = ways_of_search(mechanics, model);
  if (!movable) return {};
  const Approach emitted = emitted_approach(mechanics, *movable, time);
  if (emitted.is_solved && emitted.is_settled) {
    const auto position = less_whole_turns(mechanics, emitted.position, time);
    return position ? taken(*position, FoundStart::Reason::turns, *movable, mechanics, model, time) : FoundStart();
  }
  const Approach found = emitted.is_solved ? emitted : long_approach(mechanics, *movable, time);
  if (!found.is_solved) return {};
  const auto reason = emitted.is_solved ? FoundStart::Reason::choice : FoundStart::Reason::far;
  return taken(found.position, reason, *movable, mechanics, model, time);
}

void refine_guesses(Mechanics& mechanics, model::Model& model, double time) {
  const auto movable = ways_of_search(mechanics, model);
  if (!movable) return;
  const Approach found = emitted_approach(mechanics, *movable, time);
  if (found.is_solved) take(found.position, *movable, mechanics, model);
}

namespace {

/// In the words of a model file, all of a joint together: 'initial_guess: [4.54, 1.2]' at joint 'hook'.
std::vector<std::string> as_written(const FoundStart& found, const model::Model& model) {
  std::vector<std::string> texts;
  std::map<std::string, std::vector<std::string>> values;  ///< by joint
  std::vector<std::string> joints;
  for (const FoundGuess& guess : found.guesses) {
    if (guess.is_of_quaternion) continue;
    const model::Coordinate& coordinate = model.coordinates[model.resolve(guess.name).index];
    const std::string value = fmt::format("{:.{}g}", guess.value, found.digits);
    if (coordinate.starts_at.empty()) {
      texts.push_back(fmt::format("'initial_guess: {}' at coordinate '{}'", value, guess.name));
    } else {
      if (values.count(coordinate.starts_at) == 0) joints.push_back(coordinate.starts_at);
      values[coordinate.starts_at].push_back(value);
    }
  }
  for (const std::string& joint : joints) {
    const std::vector<std::string>& all = values[joint];
    const std::string list = all.size() == 1 ? all[0] : "[" + support::joined(all) + "]";
    texts.push_back(fmt::format("'initial_guess: {}' at joint '{}'", list, joint));
  }
  return texts;
}

}  // namespace

namespace {

const char* in_words(FoundStart::Reason reason) {
  switch (reason) {
    case FoundStart::Reason::choice:
      return "where emitted code would get from these guesses is for rounding to decide, since constraints follow "
             "from each other there; it starts from one of these positions";
    case FoundStart::Reason::turns:
      return "from these guesses emitted code would get to a position whole turns on, as from beside a place where a "
             "loop is stretched; it starts from that position, less these turns";
    default:
      return "emitted code would not get from these guesses to a position that satisfies the constraints; it "
             "starts from one that a longer search has found";
  }
}

}  // namespace

void report_found(const FoundStart& found, const model::Model& model, support::Diagnostics& diagnostics) {
  if (found.guesses.empty()) return;
  const std::vector<std::string> values = as_written(found, model);
  diagnostics.warning(support::code::k_far_start, span_of_speed(model, found.guesses.front().name),
                      in_words(found.reason),
                      values.empty() ? "give the orientation an 'initial' that is nearer"
                                     : "write it down: " + support::joined(values));
}

void assemble(Mechanics& mechanics, model::Model& model, double time) {
  kinematics::Expressions& expressions = mechanics.expressions;
  const std::vector<bool> all(mechanics.dynamics.n(), true);
  improve_guesses(mechanics, model, time);
  Approach start = emitted_approach(mechanics, strategy::open_positions(model, expressions), time);
  if (!start.is_solved) {
    // What is open goes as far as it gets, then what has to moves too, as little as it must, and then all.
    const std::vector<bool> movable = strategy::open_positions(model, expressions);
    if (any(movable)) take(long_approach(mechanics, movable, time).position, movable, mechanics, model);
    for (const auto& chosen : {needed_displacements(mechanics, movable, time), all}) {
      if (start.is_solved) break;
      open_positions(model, chosen);
      improve_guesses(mechanics, model, time);
      start = emitted_approach(mechanics, strategy::open_positions(model, expressions), time);
    }
  }
  const std::vector<bool> open = strategy::open_speeds(model, expressions);
  for (const auto& chosen : {needed_changes(mechanics, start.position, open, time), all}) {
    if (!speeds_fit(mechanics, start.position, strategy::open_speeds(model, expressions), time))
      open_rates(model, chosen);
  }
}

}  // namespace gaussgen
