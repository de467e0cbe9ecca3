// How many constraints say something of their own: one rule for positions, velocities and accelerations.
// SPDX-License-Identifier: MIT-0
#ifndef GAUSS_RANK_RULE_HPP
#define GAUSS_RANK_RULE_HPP

#include "gauss/selections.hpp"

namespace gauss {

/// How it is decided which constraints say something of their own. Tolerances are sines of the angle to all others, where inertias are 1.
template <class S>
struct RankRule {
  int usual;                ///< rank of b where nothing singles a state out; less is a status
  S tolerance;              ///< below, a row follows from the others
  S beyond;                 ///< the same of rows beyond the usual rank
  bool follows_positions;   ///< `beyond` is the most that is asked: less where positions satisfy their equations well
  bool is_agreement_known;  ///< whether rows contradict each other is not asked
};

namespace detail {

/// How far row mu has to be from the others beyond the usual rank. Positions that are off turn rows that follow from others away from these, by as much as
/// they are off; near positions at which rows depend on each other, an equation is off by the square of that.
template <class S, class System>
GAUSS_FUNCTION S beyond_usual(const System& system, const RankRule<S>& rule, int mu) {
  if (!rule.follows_positions) return rule.beyond;
  const S turned = larger<S>(S(10) * root(root(system.off[mu])), rule.tolerance);
  return Math<S>::select(Math<S>::less(turned, rule.beyond), turned, rule.beyond);
}

}  // namespace detail

/// Of accelerations: half of the digits and four bits.
template <class S>
GAUSS_FUNCTION S default_rank_tolerance() {
  return Math<S>::sqrt(Math<S>::epsilon()) / S(16);
}

/// One that was asked for; never less than what the digits of S allow.
template <class S>
GAUSS_FUNCTION S rank_tolerance(const S& wanted) {
  return detail::larger(wanted, default_rank_tolerance<S>());
}

/// For constraints of velocities alone: nothing but parameters makes their rank higher than it was where the model was generated.
template <class S>
GAUSS_FUNCTION RankRule<S> rank_of_velocities(int usual, const S& tolerance = default_rank_tolerance<S>()) {
  return {usual, tolerance, tolerance, false, false};
}

/// With equations of positions: beside them, as in the stages of a step, rows that follow from others seem to say something, and what they say is
/// error. What other parameters make of them is more than positions are off by.
template <class S>
GAUSS_FUNCTION RankRule<S> rank_on_positions(int usual, const S& tolerance = default_rank_tolerance<S>()) {
  return {usual, tolerance, detail::larger<S>(S(1) / S(20), tolerance), true, false};
}

/// Of steps of Newton's method: rounding of a residual, divided by this sine, is less than the sine. So a step stays on its side of a
/// position at which rows depend on each other. It begins far from the equations, and no row is taken beyond the usual rank.
template <class S>
GAUSS_FUNCTION RankRule<S> rank_of_steps(int usual, const S& tolerance = S(0)) {
  return {usual, detail::larger<S>(S(4) * Math<S>::sqrt(Math<S>::epsilon()), tolerance), S(2), false, true};
}

}  // namespace gauss

#endif  // GAUSS_RANK_RULE_HPP
