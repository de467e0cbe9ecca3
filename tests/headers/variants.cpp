#include "variants.hpp"

#include "compute.hpp"
#include "folded_headers.inc"
#include "paper_headers.inc"

#define GAUSS_TESTED_MODEL(name_space) GAUSS_MAKE_TESTED(name_space)
#include "folded_models.inc"
#include "paper_models.inc"
#undef GAUSS_TESTED_MODEL

#define GAUSS_TESTED_MODEL(name_space) computed<name_space::Tested, double>(),

namespace headertest {

std::vector<Computed> folded_models() {
  return {
#include "folded_models.inc"
  };
}

std::vector<Computed> paper_models() {
  return {
#include "paper_models.inc"
  };
}

}  // namespace headertest
