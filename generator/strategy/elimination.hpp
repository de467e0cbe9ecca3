#pragma once

#include <optional>

#include "strategy/bounds.hpp"
#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// a^μ = c_p^μ a^p + drift^μ with c = -b_μρ^-1 b_ρp (Vujičić (3.6); the paper prints it without the minus).
struct Elimination {
  std::vector<std::size_t> dependent;    ///< μ: row i of c_dep belongs to dependent[i]; paired with `rows`
  std::vector<std::size_t> rows;         ///< the constraint used for dependent[i]
  std::vector<std::size_t> independent;  ///< p
  Matrix c_dep;                          ///< l×(n-l)
  Vector drift;                          ///< l
  Vector pivots;                         ///< l: numbers and terms of parameters that were divided by
  std::vector<Addition> additions;       ///< of dependent accelerations to independent ones
};

/// A partition that holds in every configuration: every pivot of the elimination is a number or depends on parameters alone
/// (architecture, decision 5). Nothing if there is none among `allowed` (all speeds when empty).
std::optional<Elimination> eliminate(const Dynamics& dynamics, const std::vector<std::size_t>& allowed, Steps& steps);

}  // namespace gaussgen::strategy
