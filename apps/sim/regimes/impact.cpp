#include "sim/regimes/impact.hpp"

#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

namespace {

constexpr double k_rest = 1e-8;  ///< of the time since the start: impacts that would end within it are at an end
constexpr double k_flat = 16;    ///< units of rounding of places: bounces that are no higher are none

/// How long the impacts that would follow take: a geometric series of flights.
template <class S>
void forget_rebounds_without_end(const Regime<S>& ground, const Regime<S>& before, const Switches& switches,
                                 const Standing<S>& standing, const Instant<S>& here,
                                 gauss::event::ImpactProblem<S>& problem) {
  const S dt = here.a_while(S(1e-7), S(1e-7));
  Standing<S> then;
  if (!find_standing(ground, switches, S(here.t + dt), moved(here.x, before.rates(here.t, here.x), dt), then)) return;
  for (std::size_t c = 0; c < problem.contacts(); ++c) {
    const S e = problem.restitution[c], rate = standing.gap_rate(c);
    if (problem.takes_part[c] == 0 || !(e > S(0)) || !(e < S(1)) || !(rate < S(0))) continue;
    const S acceleration = (then.gap_rate(c) - rate) / dt;
    if (!(acceleration < S(0))) continue;
    const S rest = 2 * e * rate / acceleration / (S(1) - e);
    const S height = -e * e * rate * rate / acceleration / 2;
    const S least = 64 * gauss::Math<S>::epsilon() * gauss::event::magnitude_of(here.t);
    const bool is_brief = rest < S(k_rest) * (here.t - here.start) || rest < least;
    if (is_brief || height < S(k_flat) * gauss::Math<S>::epsilon() * here.reaches.at(switches.contacts[c].name))
      problem.restitution[c] = S(0);
  }
}

}  // namespace

template <class S>
std::optional<std::vector<Hit>> hit(const Regime<S>& ground, const Regime<S>& before, const Standing<S>& standing,
                                    const Switches& switches, const std::set<std::string>& closing, Instant<S>& here,
                                    std::string& why) {
  gauss::event::ImpactProblem<S> problem = standing.impact;
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    const bool touches = here.touches(name, standing.gaps[c], standing.gap_rate(c));
    problem.takes_part[c] = here.closed.count(name) > 0 || closing.count(name) > 0 || touches ? 1 : 0;
  }
  forget_rebounds_without_end(ground, before, switches, standing, here, problem);
  const gauss::event::Impulses<S> found = gauss::event::ImpactSolver<S>(problem).solve();
  if (!found.is_found) return why = "no impulses satisfy the law of this impact", std::nullopt;
  for (std::size_t i = 0; i < problem.speeds; ++i) here.x[here.coordinates + i] += found.changes[i];
  here.note_sizes(here.x);
  std::vector<Hit> hits;
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    if (closing.count(name) > 0) hits.push_back({name, static_cast<double>(found.impulses[problem.constraints + c])});
  }
  return hits;
}

#define GAUSS_SIM_NUMBER(S)                                                                                \
  template std::optional<std::vector<Hit>> hit(const Regime<S>&, const Regime<S>&, const Standing<S>&,     \
                                               const Switches&, const std::set<std::string>&, Instant<S>&, \
                                               std::string&);
GAUSS_SIM_NUMBER(float)
GAUSS_SIM_NUMBER(double)
GAUSS_SIM_NUMBER(long double)
GAUSS_SIM_NUMBER(Quad)
#undef GAUSS_SIM_NUMBER

}  // namespace gausssim
