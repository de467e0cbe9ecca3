// Power series of the state: those of what rhs fills.

#include "artefact_builder.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

using emit::Artefact;

bool has_taylor(Mechanics& mechanics) {
  return mechanics.dynamics.n() > 0 && (!has_general_way(mechanics) || usual_rank(mechanics) == mechanics.dynamics.l());
}

std::vector<Artefact> taylor_artefact(Mechanics& mechanics) {
  std::vector<Artefact> result;
  if (!has_taylor(mechanics)) return result;
  result.push_back(rhs_artefact(mechanics));
  result.back().name = "taylor";
  result.back().about =
      "Coefficients of the power series of the state from t on, up to `order` (1 to TaylorSeries<S>::most): those of "
      "order 1 are what rhs fills. Inputs are constant. Where the status is not ok there is no series, while rhs may "
      "know "
      "the motion all the same.";
  result.back().is_series = true;
  return result;
}

}  // namespace gaussgen
