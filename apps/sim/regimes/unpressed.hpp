#pragma once
// Which contacts nothing presses, were there no friction: Gauss's principle with inequalities (docs/theory.md, section 11).

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gauss/event/least_constraint.hpp"
#include "sim/regimes/standing.hpp"

namespace gausssim {

/// Contacts without a reaction, and of these the ones that part.
struct Unpressed {
  std::set<std::string> all, parting;
};

/// Of these contacts, which touch, as they stand in a state. Rates of gaps change within `dt`; accelerations below 1e-6 of `largest` are none. Nothing: the
/// principle has no answer.
template <class S>
std::optional<Unpressed> unpressed_contacts(const Regime<S>& ground, const Switches& switches,
                                            const Standing<S>& standing, const std::vector<std::size_t>& contacts,
                                            const S& t, const Numbers<S>& x, const S& dt, const S& largest) {
  Standing<S> then;
  if (!find_standing(ground, switches, S(t + dt), moved(x, ground.rates(t, x), dt), then)) return std::nullopt;
  const auto& impact = standing.impact;
  gauss::event::ContactProblem<S> problem;
  problem.speeds = impact.speeds;
  problem.equations = impact.constraints;
  problem.metric = impact.metric;
  const auto add = [&](std::size_t row, const S& right) {
    const auto begin = impact.rows.begin() + static_cast<std::ptrdiff_t>(row * impact.speeds);
    problem.rows.insert(problem.rows.end(), begin, begin + static_cast<std::ptrdiff_t>(impact.speeds));
    problem.right.push_back(right);
  };
  for (std::size_t k = 0; k < impact.constraints; ++k) add(k, S(0));
  for (const std::size_t c : contacts) add(impact.constraints + c, (standing.gap_rate(c) - then.gap_rate(c)) / dt);
  const auto found = gauss::event::LeastConstraint<S>(problem).solve();
  if (!found.is_found) return std::nullopt;
  // Those with reactions are independent of each other. Of more than a body needs, others stay where they are by these.
  Unpressed result;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (found.reactions[impact.constraints + k] > S(0)) continue;
    const std::string& name = switches.contacts[contacts[k]].name;
    result.all.insert(name);
    if (found.rates[impact.constraints + k] > S(1e-6) * largest) result.parting.insert(name);
  }
  return result;
}

}  // namespace gausssim
