#pragma once
// How contacts and friction stand at a state, whatever their modes.

#include <cstddef>
#include <utility>
#include <vector>

#include "gauss/event/impulse.hpp"
#include "sim/regimes/parts.hpp"
#include "sim/regimes/regime.hpp"

namespace gausssim {

template <class S>
struct Standing {
  gauss::event::ImpactProblem<S> impact;  ///< with the restitution of the model, and with no contact that takes part
  std::vector<S> gaps;

  const S& gap_rate(std::size_t contact) const { return impact.rates[impact.constraints + contact]; }
  bool has_limit(std::size_t friction, std::size_t contact) const {
    return gauss::event::magnitude_of(impact.limits[friction * impact.contacts() + contact]) > S(0);
  }
  std::vector<S> slip(std::size_t friction) const {
    const auto first = impact.rates.begin() + static_cast<std::ptrdiff_t>(impact.first_slip(friction));
    return {first, first + static_cast<std::ptrdiff_t>(impact.slips[friction])};
  }
};

/// False: they have no value there. `ground`: the regime in which all contacts are open and no friction acts, whose `impact_system`
/// has these parts one after another (docs/emitted-code.md).
template <class S>
bool find_standing(const Regime<S>& ground, const Switches& switches, const S& t, const Numbers<S>& x,
                   Standing<S>& standing) {
  auto& impact = standing.impact;
  impact = {};
  impact.speeds = ground.functions().n_v;
  impact.constraints = ground.model().unit.constraints.size();
  for (const ContactSwitch& contact : switches.contacts) {
    impact.restitution.push_back(S(contact.restitution));
    impact.takes_part.push_back(0);
  }
  for (const FrictionSwitch& friction : switches.frictions) impact.slips.push_back(friction.slips);
  const std::size_t n = impact.speeds, contacts = impact.contacts(), frictions = impact.slips.size();
  const std::size_t rows = impact.first_slip(frictions);
  std::vector<S> filled(n * n + rows * n + rows + contacts + contacts * frictions, S(0));
  if (contacts + frictions > 0 && !ground.impact_system(t, x, filled)) return false;
  take_parts<S>(filled, {{&impact.metric, n * n},
                         {&impact.rows, rows * n},
                         {&impact.rates, rows},
                         {&standing.gaps, contacts},
                         {&impact.limits, contacts * frictions}});
  return true;
}

/// Of each friction, once the least change of the speeds has taken away what constraints and closed contacts still have of a rate, such as of a bounce
/// that is too low to count.
template <class S>
std::vector<std::vector<S>> slips_while_closed(const Standing<S>& standing, const Switches& switches,
                                               const Modes& modes) {
  const auto& impact = standing.impact;
  const std::size_t n = impact.speeds;
  const auto rows = gauss::event::in_metric(impact.metric, impact.rows, n, impact.count());
  const auto row = [&](std::size_t k) {
    const auto begin = rows.entries.begin() + static_cast<std::ptrdiff_t>(k * n);
    return std::vector<S>(begin, begin + static_cast<std::ptrdiff_t>(n));
  };
  gauss::event::OrthonormalVectors<S> across(n);
  std::vector<S> change(n, S(0));
  for (std::size_t k = 0; k < impact.constraints + impact.contacts(); ++k) {
    if (k >= impact.constraints && modes.at(switches.contacts[k - impact.constraints].name) != "closed") continue;
    const std::vector<S> own = across.across(row(k));
    if (!(gauss::event::length_of(own) > S(1e-9) * gauss::event::length_of(row(k)))) continue;
    const S left = impact.rates[k] + gauss::event::product_of(row(k), change);
    for (std::size_t i = 0; i < n; ++i) change[i] -= left / gauss::event::product_of(own, own) * own[i];
    across.vectors.push_back(gauss::event::in_one_direction(own));
  }
  std::vector<std::vector<S>> slips;
  for (std::size_t f = 0; f < impact.slips.size(); ++f) {
    slips.push_back(standing.slip(f));
    for (std::size_t i = 0; i < impact.slips[f]; ++i)
      slips.back()[i] += gauss::event::product_of(row(impact.first_slip(f) + i), change);
  }
  return slips;
}

/// Rows of constraints, closed contacts and what sticks, of length 1 in the metric of masses.
template <class S>
std::vector<std::vector<S>> held_rows(const Standing<S>& standing, const Switches& switches, const Modes& modes) {
  const auto& impact = standing.impact;
  std::vector<std::vector<S>> result;
  const auto hold = [&](std::size_t k) {
    std::vector<S> one = impact.row_in_metric(k);
    if (gauss::event::length_of(one) > S(0)) result.push_back(gauss::event::in_one_direction(std::move(one)));
  };
  for (std::size_t k = 0; k < impact.constraints; ++k) hold(k);
  for (std::size_t c = 0; c < impact.contacts(); ++c)
    if (modes.at(switches.contacts[c].name) == "closed") hold(impact.constraints + c);
  for (std::size_t f = 0; f < impact.slips.size(); ++f) {
    if (modes.at(switches.frictions[f].name) != "sticks") continue;
    for (std::size_t i = 0; i < impact.slips[f]; ++i) hold(impact.first_slip(f) + i);
  }
  return result;
}

}  // namespace gausssim
