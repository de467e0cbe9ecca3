#pragma once
// A model at one state, in as many digits as wanted and without a compiler: `gauss-gen evaluate`.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "artefacts.hpp"
#include "evaluate/evaluator.hpp"

namespace gaussgen {

/// One number of the report.
struct EvaluatedValue {
  std::string group;  ///< state, accelerations, multipliers, reactions, …, in this order
  std::string name;
  std::string unit;
  std::string about;  ///< meaning, frame, sign; may be empty
  std::string text;   ///< decimal, or why there is none
  bool is_defined = true;
};

struct Evaluation {
  std::vector<EvaluatedValue> values;
  std::vector<std::string> warnings;  ///< singular mass matrix, dependent constraints, initial state that violates them
  std::vector<std::string>
      doubts;  ///< why nothing is to be trusted, by the names of gauss::Status or "impossible_bodies"
  std::vector<std::string>
      not_unique;  ///< groups in which the least of several answers is shown, where that is the only doubt of a constraint
  std::vector<std::string> notes;  ///< what a group holds, and what is left out of it on purpose
};

/// Groups in which a value is undefined, in their order.
std::vector<std::string> undefined_groups(const Evaluation& evaluation);

/// Whether the groups in which all values are defined are to be trusted, as functions of emitted code each have a status of their own: nothing else is in
/// doubt, and the motion is known.
bool are_others_trusted(const Evaluation& evaluation);

/// Whether everything but multipliers, and what follows from single ones, is to be trusted.
bool is_motion_trusted(const Evaluation& evaluation);

/// Accelerations of which the forces and inputs are asked for, by their names; others are 0.
using WantedAccelerations = std::map<std::string, support::Rational>;

/// Whether open positions satisfy their equations in all digits after the steps that emitted code takes.
bool is_start_reached(Mechanics& mechanics, const support::Rational& time, int digits);

/// λ of each constraint where a model rests.
using RestingMultipliers = std::vector<support::Rational>;

/// At the initial state of `mechanics.model` and time `time`, with `digits` decimal digits; with `resting` multipliers in the rest that this
/// state is, in which masses have no part. Changes `mechanics` then, and with `wanted` accelerations.
Evaluation evaluate_model(Mechanics& mechanics, const support::Rational& time, int digits,
                          const std::optional<WantedAccelerations>& wanted = std::nullopt,
                          const std::optional<RestingMultipliers>& resting = std::nullopt);

/// Binds parameters and inputs to their values in the model.
template <class T>
void bind_parameters(ModelGraph& motion, evaluate::Evaluator<T>& evaluator);

}  // namespace gaussgen
