#pragma once

#include "model/model.hpp"

namespace gaussgen::model {

/// φ of an equation of positions: df/dt, or what the law has instead.
Ast rate_of(const PositionLaw& law);

}  // namespace gaussgen::model
