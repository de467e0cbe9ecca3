#pragma once

#include <optional>

#include "ir/substitute.hpp"
#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// Puts a state, and a time where one is given, in for their symbols; numbers are rounded, as `ir::rounded` says.
inline ir::Substitution state_values(const kinematics::Symbols& symbols, const std::optional<ir::Expr>& time,
                                     const Vector& configuration, const Vector& speeds) {
  ir::Substitution put_in(speeds[0].graph());
  put_in.round_numbers();
  if (time) put_in.replace(symbols.time, *time);
  for (const kinematics::ConfigurationIndex i : symbols.configuration.indices()) {
    put_in.replace(symbols.configuration[i].symbol, configuration[i.value]);
  }
  for (const kinematics::FreeIndex i : symbols.speeds.indices()) {
    put_in.replace(symbols.speeds[i].symbol, speeds[i.value]);
  }
  return put_in;
}

}  // namespace gaussgen::strategy
