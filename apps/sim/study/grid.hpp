#pragma once

#include <vector>

#include "sim/run/prepare.hpp"
#include "sim/study/candidate.hpp"

namespace gausssim {

struct GridOptions {
  double loosest = 1e-3, tightest = 1e-13;
  int per_decade = 1;
};

/// All methods at all tolerances, or steps, of one formulation, loose ones first. What a model does not allow is left to the run to say.
std::vector<Candidate> grid_of(const PreparedModel& model, std::size_t formulation, const GridOptions& options);

}  // namespace gausssim
