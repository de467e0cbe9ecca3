#pragma once
// Ways from effects that act to fewer of them.

#include <set>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace gausssim {

/// Names of effects that act.
using EffectSet = std::set<std::string>;

struct Move {
  std::string what;              ///< for readers: "without drag (and wind)", "rigid instead of elastic"
  EffectSet left;                ///< what acts then
  bool is_other_choice = false;  ///< one of several instead of another
};

/// One for each effect that may be left out, with those that need it, and one for each alternative of a choice of one among several that
/// goes with the rest. What only changes a choice that another effect needs is not among them.
std::vector<Move> moves_from(const EffectSet& acting, const std::vector<gaussgen::model::Effect>& effects);

/// In the order of the model, for readers and for `effects:` of scenes; "none" where nothing acts.
std::vector<std::string> in_order(const EffectSet& acting, const std::vector<gaussgen::model::Effect>& effects);

}  // namespace gausssim
