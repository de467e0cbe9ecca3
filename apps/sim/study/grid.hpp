#pragma once

#include <string>
#include <vector>

#include "sim/study/candidate.hpp"
#include "sim/study/form.hpp"

namespace gausssim {

struct GridOptions {
  double loosest = 1e-3, tightest = 0;  ///< 0: as far as the digits go, by methods that are defaults
  int per_decade = 1;
  std::vector<std::string> only = {};  ///< methods: these, of the scene as it is, in double; empty: all, and all else
};

/// What a study tries, what people are likely to take first, and loose tolerances first: the usual methods of all forms, then all methods of the scene as it is, then the usual ones in other number types and with other projections. What a model does not allow is left to the run to say.
std::vector<Candidate> grid_of(const std::vector<Form>& forms, const GridOptions& options);

}  // namespace gausssim
