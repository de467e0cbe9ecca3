#include "sim/regimes/next_regime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"
#include "sim/regimes/slip_start.hpp"

namespace gausssim {

using gauss::event::length_of;
using gauss::event::magnitude_of;
using Kind = gaussgen::model::Guard::Kind;

namespace {

using Names = std::set<std::string>;

constexpr std::size_t k_most_touching = 11;  ///< contacts of which all ways to be open and closed are tried
constexpr std::size_t k_most_unpressed = 4;  ///< likewise, of those alone that have no reaction without friction
constexpr std::size_t k_most_tried = 4096;   ///< regimes at one instant

/// All ways to take some of these, beside those that are taken.
std::vector<Names> few_first(const std::vector<std::string>& names, const Names& taken) {
  std::vector<Names> ways;
  for (std::size_t choice = 0; choice < std::size_t(1) << names.size(); ++choice) {
    ways.push_back(taken);
    for (std::size_t k = 0; k < names.size(); ++k)
      if ((choice >> k & 1U) != 0) ways.back().insert(names[k]);
  }
  std::stable_sort(ways.begin(), ways.end(), [](const Names& a, const Names& b) { return a.size() < b.size(); });
  return ways;
}

}  // namespace

template <class S>
RegimeChoice<S>::RegimeChoice(RegimePool<S>& pool, Regime<S>& ground, const Standing<S>& standing,
                              const Instant<S>& here, const Ended& ended)
    : pool_(pool), switches_(pool.switches()), ground_(ground), standing_(standing), here_(here), ended_(ended) {
  const Numbers<S> rates = ground.rates(here.t, here.x);
  free_ = largest_of(rates.data() + here.coordinates, rates.size() - here.coordinates);
  for (std::size_t c = 0; c < switches_.contacts.size(); ++c) {
    if (here.touches(switches_.contacts[c].name, standing.gaps[c], standing.gap_rate(c))) touching_.push_back(c);
  }
}

template <class S>
std::optional<NextRegime<S>> RegimeChoice<S>::find(std::string& why) {
  for (const Opens& opens : choices_of_contacts()) {
    if (!is_allowed(opens)) continue;
    if (auto found = find_with(opens, why)) return found;
  }
  if (touching_.size() > k_most_touching)
    why += fmt::format("; of {} contacts that touch, no more than {} are tried in all ways", touching_.size(),
                       k_most_touching);
  return std::nullopt;
}

template <class S>
bool RegimeChoice<S>::is_banned(const std::string& name, const std::string& mode) const {
  const auto found = ended_.modes.find(name);
  return found != ended_.modes.end() && found->second == mode;
}

/// Those that touch and may not be closed.
template <class S>
typename RegimeChoice<S>::Opens RegimeChoice<S>::banned_contacts() const {
  Opens result;
  for (const std::size_t c : touching_)
    if (is_banned(switches_.contacts[c].name, "closed")) result.insert(switches_.contacts[c].name);
  return result;
}

template <class S>
bool RegimeChoice<S>::is_allowed(const Opens& opens) const {
  return std::none_of(touching_.begin(), touching_.end(), [&](std::size_t c) {
    const std::string& name = switches_.contacts[c].name;
    return is_banned(name, opens.count(name) > 0 ? "open" : "closed");
  });
}

/// First all closed, then what Gauss's principle with inequalities says, then all ways, where there are not too many. Where no friction changes what the principle says, that comes first, with all closed
/// that do not part; where some does, one contact after the other that has no reaction without it may have one.
template <class S>
std::vector<typename RegimeChoice<S>::Opens> RegimeChoice<S>::choices_of_contacts() {
  std::vector<Opens> all(1);
  if (touching_.size() > 1 && unpressed()) {
    if (switches_.frictions.empty()) {
      all = {unpressed()->parting, unpressed()->all, {}};
    } else {
      const Opens banned = banned_contacts();
      std::vector<std::string> others;
      std::set_difference(unpressed()->all.begin(), unpressed()->all.end(), banned.begin(), banned.end(),
                          std::back_inserter(others));
      if (others.size() <= k_most_unpressed) all = few_first(others, banned);
      all.push_back(unpressed()->all);
    }
  }
  if (touching_.size() > k_most_touching) return all;
  std::vector<std::string> names;
  for (const std::size_t c : touching_) names.push_back(switches_.contacts[c].name);
  for (Opens& opens : few_first(names, {})) all.push_back(std::move(opens));
  return all;
}

/// Friction is left to contacts that are pressed without it, now and later. (Ground, switches and the instant last as long as regimes do.)
template <class S>
void RegimeChoice<S>::tell_unloaded(const NextRegime<S>& next) const {
  if (!next.regime->shared_loads().are_possible()) return;
  std::vector<std::size_t> closed;
  for (const std::size_t c : touching_)
    if (next.modes.at(switches_.contacts[c].name) == "closed") closed.push_back(c);
  next.regime->shared_loads().ask_unloaded(
      [&ground = ground_, &switches = switches_, &here = here_, closed](const S& t, const Numbers<S>& x) {
        Standing<S> standing;
        if (!find_standing(ground, switches, t, x, standing)) return Opens{};
        const S dt = S(1e-7) * std::max(S(t - here.last_event), S(1e-3));
        const auto found = unpressed_contacts(ground, switches, standing, closed, t, x, dt, S(0));
        return found ? found->all : Opens{};
      });
}

template <class S>
const std::optional<Unpressed>& RegimeChoice<S>::unpressed() {
  if (!unpressed_) unpressed_ = find_unpressed();
  return *unpressed_;
}

template <class S>
std::optional<Unpressed> RegimeChoice<S>::find_unpressed() const {
  const Opens banned = banned_contacts();
  std::vector<std::size_t> taking_part;
  for (const std::size_t c : touching_)
    if (banned.count(switches_.contacts[c].name) == 0) taking_part.push_back(c);
  const S dt = here_.a_while(S(1e-7), S(1e-3));
  auto found = unpressed_contacts(ground_, switches_, standing_, taking_part, here_.t, here_.x, dt, free_);
  if (found) {
    found->all.insert(banned.begin(), banned.end());
    found->parting.insert(banned.begin(), banned.end());
  }
  return found;
}

/// Where rates that count as none have to be taken, slip that comes of that alone does so, too: of a block that has rocked to rest, friction takes both.
template <class S>
bool RegimeChoice<S>::rests(std::size_t friction) const {
  const std::vector<S> slip = slips_[friction], before = standing_.slip(friction);
  std::vector<S> change = slip;
  for (std::size_t i = 0; i < change.size(); ++i) change[i] -= before[i];
  return here_.halted.count(switches_.frictions[friction].name) > 0 || !(length_of(slip) > here_.slow()) ||
         !(length_of(slip) > 2 * length_of(change));
}

/// What is closed and what sticks leave it no slip: then it sticks like these.
template <class S>
bool RegimeChoice<S>::is_held(const std::string& friction, const Modes& modes) const {
  const auto& impact = standing_.impact;
  gauss::event::OrthonormalVectors<S> held(impact.speeds);
  held.add(held_rows(standing_, switches_, modes), S(1e-9));
  for (std::size_t f = 0; f < impact.slips.size(); ++f) {
    for (std::size_t i = 0; switches_.frictions[f].name == friction && i < impact.slips[f]; ++i) {
      const std::vector<S> row = impact.row_in_metric(impact.first_slip(f) + i);
      if (length_of(held.across(row)) > S(1e-9) * length_of(row)) return false;
    }
  }
  return true;
}

/// None: it does not act.
template <class S>
std::vector<std::string> RegimeChoice<S>::ways_of(std::size_t f, const Modes& modes) const {
  const FrictionSwitch& friction = switches_.frictions[f];
  bool is_of_contacts = false, acts = false;
  for (std::size_t c = 0; c < switches_.contacts.size(); ++c) {
    if (!standing_.has_limit(f, c)) continue;
    is_of_contacts = true;
    acts = acts || modes.at(switches_.contacts[c].name) == "closed";
  }
  if (is_of_contacts && !acts) return {};
  if (!rests(f)) return {friction.sliding(friction.slips == 1 && slips_[f][0] < S(0))};
  std::vector<std::string> ways;
  for (const char* const way : {"sticks", friction.sliding(false), friction.sliding(true)}) {
    const bool is_known = std::find(ways.begin(), ways.end(), way) != ways.end();
    if (!is_known && !is_banned(friction.name, way)) ways.emplace_back(way);
  }
  return ways;
}

template <class S>
std::optional<NextRegime<S>> RegimeChoice<S>::find_with(const Opens& opens, std::string& why) {
  Modes modes = here_.ground_modes(switches_);
  for (const std::size_t c : touching_) {
    const std::string& name = switches_.contacts[c].name;
    modes[name] = opens.count(name) > 0 ? "open" : "closed";
  }
  slips_ = slips_while_closed(standing_, switches_, modes);
  Ways acting;
  for (std::size_t f = 0; f < switches_.frictions.size(); ++f) {
    std::vector<std::string> ways = ways_of(f, modes);
    if (!ways.empty()) acting.emplace_back(switches_.frictions[f].name, std::move(ways));
  }
  std::vector<std::size_t> at(acting.size(), 0);
  while (++tried_ < k_most_tried) {
    for (std::size_t f = 0; f < acting.size(); ++f) modes[acting[f].first] = acting[f].second[at[f]];
    if (auto found = consistent(modes, opens, why)) return found;
    std::size_t f = 0;
    while (f < acting.size() && ++at[f] == acting[f].second.size()) at[f++] = 0;
    if (f == acting.size()) break;
  }
  return std::nullopt;
}

/// Frictions that slide in two directions, and had no slip so far.
template <class S>
std::vector<std::size_t> RegimeChoice<S>::beginning_slips(const Modes& modes) const {
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f < switches_.frictions.size(); ++f)
    if (switches_.frictions[f].slips > 1 && modes.at(switches_.frictions[f].name) == "slides" && rests(f))
      result.push_back(f);
  return result;
}

/// What sticks has come to rest: whatever takes more than that would be an impact, such as of a crank whose slide rests at the dead centre.
template <class S>
bool RegimeChoice<S>::is_near(const Numbers<S>& x) const {
  S change = 0;
  for (std::size_t i = here_.coordinates; i < x.size(); ++i)
    change = std::max(change, magnitude_of(S(x[i] - here_.x[i])));
  return !(change > std::max(S(S(1e-4) * here_.fastest), S(S(1e6) * here_.rounded_speed)));
}

/// If it goes on from here for some time.
template <class S>
std::optional<NextRegime<S>> RegimeChoice<S>::consistent(const Modes& modes, const Opens& opens, std::string& why) {
  if (modes == ended_.regime) return why = "this has just come to its end", std::nullopt;
  const std::vector<std::size_t> beginning = beginning_slips(modes);
  for (const std::size_t f : beginning) {
    const std::string& name = switches_.frictions[f].name;
    if (is_held(name, modes)) return why = fmt::format("'{}' cannot slide", name), std::nullopt;
  }
  NextRegime<S> next{modes, pool_.at(modes, why), here_.x};
  if (next.regime == nullptr) {
    if (underived_.empty()) underived_ = why;
    return std::nullopt;
  }
  if (!next.regime->project(here_.t, next.x) || !is_near(next.x))
    return why = "no state is near that satisfies its constraints", std::nullopt;
  tell_unloaded(next);
  if (!beginning.empty()) {
    SlipStart<S> start(*next.regime, switches_, modes, standing_, beginning, here_, next.x);
    const auto x = start.state(why);
    if (!x) return std::nullopt;
    next.x = *x;
    next.has_fresh_slip = true;
  }
  if (!holds(next, opens, why) || !stays_held(next, why)) return std::nullopt;
  return next;
}

/// At a dead centre a slip is 0 whatever friction does, and what holds it there says nothing of its acceleration: then rows contradict each other, and one of them gives way.
template <class S>
bool RegimeChoice<S>::stays_held(const NextRegime<S>& next, std::string& why) const {
  const S dt = here_.a_while(S(1e-5), S(1e-3));
  const Numbers<S> rates = next.regime->rates(here_.t, next.x);
  const S size = std::max(free_, largest_of(rates.data() + here_.coordinates, rates.size() - here_.coordinates));
  Standing<S> now, then;
  if (!find_standing(ground_, switches_, here_.t, next.x, now) ||
      !find_standing(ground_, switches_, S(here_.t + dt), moved(next.x, rates, dt), then))
    return true;
  const auto is_broken = [&](std::size_t row) {
    return magnitude_of(S(then.impact.rates[row] - now.impact.rates[row])) > S(1e-3) * size * dt;
  };
  const auto& impact = now.impact;
  for (std::size_t k = 0; k < impact.constraints; ++k)
    if (is_broken(k)) return why = "constraints contradict each other", false;
  for (std::size_t c = 0; c < impact.contacts(); ++c) {
    const std::string& name = switches_.contacts[c].name;
    if (next.modes.at(name) == "closed" && is_broken(impact.constraints + c))
      return why = fmt::format("'{}' would not stay closed", name), false;
  }
  for (std::size_t f = 0; f < impact.slips.size(); ++f) {
    const std::string& name = switches_.frictions[f].name;
    for (std::size_t i = 0; i < impact.slips[f]; ++i)
      if (next.modes.at(name) == "sticks" && is_broken(impact.first_slip(f) + i))
        return why = fmt::format("'{}' is at rest for an instant only", name), false;
  }
  return true;
}

template <class S>
bool RegimeChoice<S>::holds(const NextRegime<S>& next, const Opens& opens, std::string& why) {
  const Regime<S>& regime = *next.regime;
  const auto& guards = regime.guards();
  const Numbers<S> rates = regime.rates(here_.t, next.x);
  const S dt = here_.a_while(S(1e-7), S(1e-3));
  const std::vector<S> now = regime.guard_values(here_.t, next.x);
  const std::vector<S> changes = regime.guard_rates(here_.t, next.x, rates, now, dt);
  S press = 0;
  for (std::size_t g = 0; g < now.size(); ++g)
    if (guards[g].kind == Kind::falls && next.modes.at(guards[g].of) == "closed")
      press = std::max(press, magnitude_of(now[g]));
  const S size = std::max(free_, largest_of(rates.data() + here_.coordinates, rates.size() - here_.coordinates));
  for (std::size_t g = 0; g < now.size(); ++g) {
    const GuardOf& guard = guards[g];
    const std::string& mode = next.modes.at(guard.of);
    const S change = changes[g];
    if (!(now[g] == now[g])) return why = fmt::format("'{}' has no value", guard.name), false;
    if (mode == "closed" && now[g] < -S(1e-9) * press) return why = fmt::format("'{}' would pull", guard.of), false;
    if (mode == "sticks" && now[g] < S(0)) return why = fmt::format("'{}' cannot hold it", guard.of), false;
    const bool slides = mode == "forwards" || mode == "backwards" || mode == "slides";
    if (slides && guard.kind == Kind::falls && now[g] < S(0))
      return why = fmt::format("the limit of '{}' is below 0", guard.of), false;
    if (mode == "holds" && now[g] < S(0)) {
      if (overloaded_.empty() || now[g] < overload_) overloaded_ = guard.of, overload_ = now[g];
      return why = fmt::format("'{}' breaks", guard.of), false;
    }
    const bool is_resting = guard.kind == Kind::rate_of_gap && opens.count(guard.of) > 0;
    if (is_resting && change < -S(1e-6) * size) return why = fmt::format("'{}' would overlap", guard.of), false;
    const bool has_sense = guard.kind == Kind::slip && (mode == "forwards" || mode == "backwards");
    const S sense = mode == "backwards" ? S(-1) : S(1);
    const bool begins = here_.halted.count(guard.of) > 0 || magnitude_of(now[g]) <= here_.slow();
    if (has_sense && begins && sense * change < -S(1e-6) * size)
      return why = fmt::format("'{}' would turn back", guard.of), false;
    if (has_sense && begins && sense * change <= S(1e-6) * size && is_held(guard.of, next.modes))
      return why = fmt::format("'{}' would not slide", guard.of), false;
    if (has_sense && !begins && sense * now[g] < S(0)) return false;
  }
  return true;
}

template class RegimeChoice<float>;
template class RegimeChoice<double>;
template class RegimeChoice<long double>;
template class RegimeChoice<Quad>;

}  // namespace gausssim
