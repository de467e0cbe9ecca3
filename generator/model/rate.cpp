#include "model/rate.hpp"

#include "model/ast_build.hpp"

namespace gaussgen::model {

Ast rate_of(const PositionLaw& law) { return law.phi ? *law.phi : call_of("dot", law.f); }

}  // namespace gaussgen::model
