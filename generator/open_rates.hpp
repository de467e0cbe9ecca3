#pragma once
// Initial rates that neither the model nor its constraints determine.

#include <string>
#include <vector>

#include "model_values.hpp"

namespace gaussgen {

/// In the order of the speeds: those that the model states.
std::vector<bool> stated_speeds(const model::Model& model);

struct OpenRate {
  std::string name;   ///< "phi_dot", "wx"
  std::string label;  ///< "phi", "wx"
  cln::cl_F value;
};

/// Open rates that can change together without harm to the constraints: `freedom` of them could be stated.
struct OpenRates {
  std::vector<OpenRate> rates;
  std::size_t freedom = 0;
};

/// At the state that is bound in `values`. Empty where all of them kept their guesses: then no choice was made for the user.
OpenRates chosen_rates(Mechanics& mechanics, const std::vector<InitialValue>& state, ModelValues& values);

}  // namespace gaussgen
