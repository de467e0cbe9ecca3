#include "sim/regimes/hybrid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "gauss/event/impulse.hpp"
#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

using gauss::simulate::Outcome;
using Kind = gaussgen::model::Guard::Kind;

namespace {

constexpr const char* k_hits = "hits";
constexpr int k_most_at_once = 100;          ///< events between which no time goes by
constexpr std::size_t k_most_touching = 11;  ///< contacts of which all ways to be open and closed are tried
constexpr double k_densest = 1000;           ///< events in a second of motion, once there are so many
constexpr std::size_t k_most_tried = 4096;   ///< regimes at one instant
constexpr double k_rest = 1e-8;  ///< of the time since the start: impacts that would end within it are at an end

template <class S>
S length_of(const std::vector<S>& v) {
  S square = 0;
  for (const S& one : v) square += one * one;
  return gauss::Math<S>::sqrt(square);
}

}  // namespace

template <class S>
Hybrid<S>::Hybrid(std::shared_ptr<RegimeSource> source, Array start, const S& t, Setting setting)
    : source_(std::move(source)),
      setting_(std::move(setting)),
      t_(t),
      start_(t),
      x_(std::move(start)),
      last_event_(t) {}

template <class S>
Modes Hybrid<S>::ground_modes() const {
  Modes modes = ground_of(source_->switches());
  for (const std::string& link : broken_) modes[link] = "broken";
  return modes;
}

template <class S>
Regime<S>* Hybrid<S>::regime_at(const Modes& modes, std::string& why) {
  const auto [place, is_new] = regimes_.try_emplace(modes);
  if (is_new) {
    const Stopwatch watch;
    if (auto model = source_->at(modes, why))
      place->second = std::make_unique<Regime<S>>(std::move(model), setting_.change);
    making_ += watch.seconds();
  }
  return place->second.get();
}

template <class S>
Regime<S>* Hybrid<S>::ground() {
  std::string why;
  Regime<S>* const found = regime_at(ground_modes(), why);
  if (found == nullptr) stop(Outcome::no_regime, why);
  return found;
}

template <class S>
void Hybrid<S>::stop(Outcome outcome, std::string why) {
  outcome_ = outcome;
  why_ = std::move(why);
}

template <class S>
void Hybrid<S>::note(const std::string& what, double impulse) {
  events_.push_back({static_cast<double>(t_), what, impulse});
}

template <class S>
Progress<S> Hybrid<S>::progress() const {
  Progress<S> result = before_;
  if (inner_) {
    const Progress<S> own = inner_->progress();
    result.outcome = own.outcome;
    result.status = own.status;
    result.why = own.why;
    result.steps += own.steps;
    result.rejected += own.rejected;
    result.calls += own.calls;
    result.jacobians += own.jacobians;
    result.with_fewer_constraints += own.with_fewer_constraints;
    result.crossings += own.crossings;
  }
  if (outcome_ != Outcome::running) {
    result.outcome = outcome_;
    result.why = why_;
  }
  return result;
}

template <class S>
void Hybrid<S>::go_on_after(const std::vector<Event>& earlier) {
  std::copy_if(earlier.begin(), earlier.end(), std::back_inserter(events_),
               [this](const Event& event) { return event.t <= static_cast<double>(t_); });
  modes_ = ground_modes();
  for (const Event& event : events_) {
    const std::size_t blank = event.what.rfind(' ');
    const auto known = modes_.find(event.what.substr(0, blank));
    const std::string mode = event.what.substr(blank + 1);
    if (known == modes_.end() || mode == k_hits) continue;
    known->second = mode;
    if (mode == "broken") broken_.insert(known->first);
  }
}

template <class S>
bool Hybrid<S>::advance_to(const S& end) {
  if (!is_started_ && !start()) return false;
  while (t_ < end && outcome_ == Outcome::running) step(end);
  return outcome_ == Outcome::running && t_ == end;
}

template <class S>
void Hybrid<S>::note_speeds(const Array& x) {
  fastest_ = std::max(fastest_, largest_of(x.data() + coordinates_, x.size() - coordinates_));
}

template <class S>
bool Hybrid<S>::look(Standing<S>& standing) {
  Regime<S>* const free = ground();
  if (free == nullptr) return false;
  if (find_standing(*free, source_->switches(), t_, x_, standing)) return true;
  stop(Outcome::model_failed, "contacts and slips have no value here");
  return false;
}

template <class S>
bool Hybrid<S>::start() {
  is_started_ = true;
  Standing<S> standing;
  if (!look(standing)) return false;
  coordinates_ = ground()->functions().n_q;
  note_speeds(x_);
  const Switches& switches = source_->switches();
  const S touch = gap_that_is_none<S>(x_, coordinates_);
  std::set<std::string> closing;
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    if (standing.gaps[c] < -touch) {
      stop(Outcome::no_regime, fmt::format("the contact '{}' begins with a gap of {:.3g}: what touches overlaps", name,
                                           static_cast<double>(standing.gaps[c])));
      return false;
    }
    if (standing.gaps[c] > touch) continue;
    closed_.insert(name);
    if (standing.gap_rate(c) < -slow()) closing.insert(name);
  }
  if (modes_.empty()) modes_ = ground_modes();
  if (!closing.empty()) hit(closing);
  return outcome_ == Outcome::running && settle({});
}

/// Impulses on all that touches, and rest where impacts would follow each other without end.
template <class S>
void Hybrid<S>::hit(const std::set<std::string>& closing) {
  Standing<S> standing;
  if (!look(standing)) return;
  const Switches& switches = source_->switches();
  Regime<S>* const free = ground();
  const std::size_t n_q = free->functions().n_q;
  auto& problem = standing.impact;
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    problem.takes_part[c] = closed_.count(name) > 0 || closing.count(name) > 0 ? 1 : 0;
  }
  // How long the impacts that would follow take: a geometric series of flights.
  const S dt = S(1e-7) * std::max(S(t_ - last_event_), S(1e-7));
  const Array later = moved(x_, free->rates(t_, x_), dt);
  Standing<S> then;
  const bool is_known = find_standing(*free, switches, S(t_ + dt), later, then);
  for (std::size_t c = 0; is_known && c < switches.contacts.size(); ++c) {
    const S e = problem.restitution[c], before = standing.gap_rate(c);
    if (problem.takes_part[c] == 0 || !(e > S(0)) || !(e < S(1)) || !(before < S(0))) continue;
    const S acceleration = (then.gap_rate(c) - before) / dt;
    if (!(acceleration < S(0))) continue;
    const S rest = 2 * e * before / acceleration / (S(1) - e);
    if (rest < S(k_rest) * (t_ - start_) || rest < 64 * gauss::Math<S>::epsilon() * gauss::event::magnitude_of(t_))
      problem.restitution[c] = S(0);
  }
  const gauss::event::Impulses<S> found = gauss::event::ImpactSolver<S>(problem).solve();
  if (!found.is_found) return stop(Outcome::no_regime, "no impulses satisfy the law of this impact");
  for (std::size_t i = 0; i < problem.speeds; ++i) x_[n_q + i] += found.changes[i];
  note_speeds(x_);
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    if (closing.count(name) > 0)
      note(name + " " + k_hits, static_cast<double>(found.impulses[problem.constraints + c]));
  }
}

template <class S>
std::vector<S> Hybrid<S>::slip_accelerations(const Modes& modes, const std::string& friction, const Array& x) {
  std::string why;
  Modes without = modes;
  without[friction] = "free";
  Regime<S>* const regime = regime_at(without, why);
  Regime<S>* const sliding = regime_at(modes, why);
  if (regime == nullptr || sliding == nullptr) return {};
  const S dt = S(1e-6) * std::max(S(t_ - last_event_), S(1e-3));
  const Array rates = regime->rates(t_, x);
  const std::vector<S> now = sliding->guard_values(t_, x), then = sliding->guard_values(t_ + dt, moved(x, rates, dt));
  std::vector<S> result;
  for (std::size_t g = 0; g < now.size(); ++g) {
    const GuardOf& guard = sliding->guards()[g];
    if (guard.of == friction && guard.kind == Kind::slip) result.push_back((then[g] - now[g]) / dt);
  }
  return result;
}

/// Whether a regime goes on from here for some time. `x` becomes the state in it.
template <class S>
bool Hybrid<S>::is_consistent(const Modes& modes, const std::set<std::string>& open_at_rest, Array& x,
                              std::string& why) {
  Regime<S>* const regime = regime_at(modes, why);
  if (regime == nullptr) return false;
  x = x_;
  if (!regime->project(t_, x)) return why = "no state is near that satisfies its constraints", false;
  const std::vector<S> now = regime->guard_values(t_, x);
  const Array rates = regime->rates(t_, x);
  const S dt = S(1e-7) * std::max(S(t_ - last_event_), S(1e-3));
  const std::vector<S> then = regime->guard_values(t_ + dt, moved(x, rates, dt));
  S press = 0;
  const auto& guards = regime->guards();
  for (std::size_t g = 0; g < now.size(); ++g)
    if (guards[g].kind == Kind::falls && modes.at(guards[g].of) == "closed")
      press = std::max(press, gauss::event::magnitude_of(now[g]));
  const std::size_t n_q = regime->functions().n_q;
  const S size = largest_of(rates.data() + n_q, rates.size() - n_q);
  for (std::size_t g = 0; g < now.size(); ++g) {
    const GuardOf& guard = guards[g];
    const std::string& mode = modes.at(guard.of);
    const S change = (then[g] - now[g]) / dt;
    if (!(now[g] == now[g])) return why = fmt::format("'{}' has no value", guard.name), false;
    if (mode == "closed" && now[g] < -S(1e-9) * press) return why = fmt::format("'{}' would pull", guard.of), false;
    if (mode == "sticks" && now[g] < S(0)) return why = fmt::format("'{}' cannot hold it", guard.of), false;
    if (mode == "holds" && now[g] < S(0)) return why = fmt::format("'{}' breaks", guard.of), false;
    const bool is_resting = guard.kind == Kind::rate_of_gap && open_at_rest.count(guard.of) > 0;
    if (is_resting && change < -S(1e-6) * size) return why = fmt::format("'{}' would overlap", guard.of), false;
    const bool has_sense = guard.kind == Kind::slip && (mode == "forwards" || mode == "backwards");
    const S sense = mode == "backwards" ? S(-1) : S(1);
    const bool begins = halted_.count(guard.of) > 0 || gauss::event::magnitude_of(now[g]) <= slow();
    if (has_sense && begins && sense * change < -S(1e-6) * size)
      return why = fmt::format("'{}' would turn back", guard.of), false;
    if (has_sense && !begins && sense * now[g] < S(0)) return false;
  }
  return true;
}

/// Which regime goes on from here. `banned`: modes that have just come to their end.
template <class S>
bool Hybrid<S>::settle(const std::map<std::string, std::string>& banned) {
  if (outcome_ != Outcome::running) return false;
  Standing<S> standing;
  if (!look(standing)) return false;
  const Switches& switches = source_->switches();
  const auto is_banned = [&](const std::string& name, const std::string& mode) {
    const auto found = banned.find(name);
    return found != banned.end() && found->second == mode;
  };
  // What may be closed: touches, and does not part.
  std::vector<std::string> touching;
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    if (closed_.count(name) == 0) continue;
    if (standing.gap_rate(c) > slow()) {
      closed_.erase(name);
    } else {
      touching.push_back(name);
    }
  }
  const std::size_t contacts = switches.contacts.size();
  std::string why;
  std::size_t tried = 0;
  const bool are_few = touching.size() <= k_most_touching;
  const std::size_t choices = are_few ? std::size_t(1) << touching.size() : 0;
  for (std::size_t choice = 0; choice < std::max<std::size_t>(choices, 1); ++choice) {
    Modes modes = ground_modes();
    std::set<std::string> open_at_rest;
    bool is_allowed = true;
    for (std::size_t k = 0; k < touching.size(); ++k) {
      const bool opens = (choice >> k & 1U) != 0;
      modes[touching[k]] = opens ? "open" : "closed";
      if (opens) open_at_rest.insert(touching[k]);
      is_allowed = is_allowed && !is_banned(touching[k], modes[touching[k]]);
    }
    if (!is_allowed) continue;
    // Frictions that act, and how they may.
    std::vector<std::pair<std::string, std::vector<std::string>>> open;
    for (std::size_t f = 0; f < switches.frictions.size(); ++f) {
      const FrictionSwitch& friction = switches.frictions[f];
      bool is_of_contacts = false, acts = false;
      for (std::size_t c = 0; c < contacts; ++c) {
        if (!standing.has_limit(f, c)) continue;
        is_of_contacts = true;
        acts = acts || modes.at(switches.contacts[c].name) == "closed";
      }
      if (is_of_contacts && !acts) continue;
      const std::vector<S> slip = standing.slip(f);
      const bool slips = halted_.count(friction.name) == 0 && length_of(slip) > slow();
      std::vector<std::string> ways;
      if (slips) {
        ways = {friction.sliding(friction.slips == 1 && slip[0] < S(0))};
      } else {
        ways = {"sticks", friction.sliding(false)};
        if (friction.slips == 1) ways.emplace_back(friction.sliding(true));
        ways.erase(std::remove_if(ways.begin(), ways.end(),
                                  [&](const std::string& way) { return is_banned(friction.name, way); }),
                   ways.end());
      }
      open.emplace_back(friction.name, std::move(ways));
    }
    std::vector<std::size_t> at(open.size(), 0);
    for (bool is_last = false; !is_last && ++tried < k_most_tried;) {
      for (std::size_t f = 0; f < open.size(); ++f) modes[open[f].first] = open[f].second[at[f]];
      Array x;
      if (is_consistent(modes, open_at_rest, x, why)) {
        const Array before = x_;
        x_ = x;
        if (enter(modes)) return true;
        x_ = before;
        return false;
      }
      is_last = true;
      for (std::size_t f = 0; f < open.size() && is_last; ++f) {
        is_last = ++at[f] == open[f].second.size();
        if (is_last) at[f] = 0;
      }
    }
  }
  if (!are_few)
    why += fmt::format(
        "; of {} contacts that touch, all closed is tried alone, since no more than {} are tried in all ways",
        touching.size(), k_most_touching);
  stop(Outcome::no_regime, fmt::format("contacts and friction leave no motion from here on ({})", why));
  return false;
}

/// Slip in two directions begins with one: that in which it is driven.
template <class S>
bool Hybrid<S>::enter(const Modes& modes) {
  std::string why;
  Regime<S>* const regime = regime_at(modes, why);
  for (const FrictionSwitch& friction : source_->switches().frictions) {
    if (friction.slips < 2 || modes.at(friction.name) != "slides") continue;
    Standing<S> standing;
    if (!look(standing)) return false;
    std::size_t f = 0;
    while (source_->switches().frictions[f].name != friction.name) ++f;
    const auto& impact = standing.impact;
    const std::vector<S> slip = standing.slip(f);
    const std::size_t n_q = regime->functions().n_q, n = impact.speeds;
    if (halted_.count(friction.name) == 0 && length_of(slip) > slow()) continue;
    const std::vector<S> driven = slip_accelerations(modes, friction.name, x_);
    const S size = length_of(driven);
    if (!(size > S(0))) continue;
    // The least change of speeds that slips so, and leaves closed contacts and constraints as they are.
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < impact.constraints; ++k) chosen.push_back(k);
    for (std::size_t c = 0; c < impact.contacts(); ++c)
      if (modes.at(source_->switches().contacts[c].name) == "closed") chosen.push_back(impact.constraints + c);
    for (std::size_t i = 0; i < 2; ++i) chosen.push_back(impact.first_slip(f) + i);
    gauss::event::DenseMatrix<S> system(n + chosen.size(), n + chosen.size());
    std::vector<S> right(n + chosen.size(), S(0));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) system(i, j) = impact.metric[i * n + j];
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      for (std::size_t i = 0; i < n; ++i) {
        const S entry = impact.rows[chosen[k] * n + i];
        system(n + k, i) = entry;
        system(i, n + k) = entry;
      }
    }
    const S speed = S(1e-12) * std::max(fastest_, size);
    right[n + chosen.size() - 2] = speed * driven[0] / size - slip[0];
    right[n + chosen.size() - 1] = speed * driven[1] / size - slip[1];
    const std::vector<S> change = gauss::event::solve_dense(std::move(system), std::move(right));
    for (std::size_t i = 0; i < n; ++i) x_[n_q + i] += change[i];
  }
  for (const auto& [name, mode] : modes) {
    const auto known = modes_.find(name);
    if (known == modes_.end() || known->second != mode) note(name + " " + mode);
  }
  modes_ = modes;
  regime_ = regime;
  closed_.clear();
  for (const ContactSwitch& contact : source_->switches().contacts)
    if (modes_.at(contact.name) == "closed") closed_.insert(contact.name);
  if (inner_) {
    const Outcome none = Outcome::running;
    before_ = progress();
    before_.outcome = none;
    before_.why.clear();
  }
  MethodSettings<S> settings = setting_.of_method;
  settings.most_steps -= before_.steps;
  if (settings.most_steps <= 0) {
    stop(Outcome::too_many_steps, "");
    return false;
  }
  inner_ = make_integrator(setting_.method, regime_->motion(), x_, t_, settings, why);
  if (!inner_) inner_ = make_integrator("prince87", regime_->motion(), x_, t_, settings, why = "");
  if (!inner_) stop(Outcome::bad_settings, why);
  slipping_.clear();
  for (const FrictionSwitch& friction : source_->switches().frictions) {
    if (modes_.at(friction.name) == "slides") slipping_.push_back(&friction);
  }
  last_step_.emplace(*regime_, modes_, t_, x_, setting_.method, setting_.of_method);
  return inner_ != nullptr;
}

/// Slip in two directions is a root of squares, which no step passes: steps end before, and come near by a tenth each.
template <class S>
S Hybrid<S>::cap(const S& end, std::string& halting) const {
  S result = end;
  for (const FrictionSwitch* const friction : slipping_) {
    const S dt = S(1e-7) * std::max(S(t_ - last_event_), S(1e-6));
    const std::vector<S> now = regime_->guard_values(t_, x_);
    const std::vector<S> then = regime_->guard_values(t_ + dt, moved(x_, regime_->rates(t_, x_), dt));
    S square = 0, falling = 0;
    for (std::size_t g = 0; g < now.size(); ++g) {
      const GuardOf& guard = regime_->guards()[g];
      if (guard.of != friction->name || guard.kind != Kind::slip) continue;
      square += now[g] * now[g];
      falling -= now[g] * (then[g] - now[g]) / dt;
    }
    const S at = falling > S(0) ? S(t_ + S(0.9) * square / falling) : result;
    if (!(at < result)) continue;
    result = at;
    halting = friction->name;
  }
  return result;
}

template <class S>
void Hybrid<S>::step(const S& end) {
  std::string halting;
  const S target = slipping_.empty() ? end : cap(end, halting);
  if (target < end) {
    const S least = 16 * gauss::Math<S>::epsilon() * gauss::event::magnitude_of(t_);
    if (target - t_ <= std::max(least, S(S(1e-13) * (t_ - last_event_)))) {
      halted_.insert(halting);
      return happen(t_, Array(x_), {});
    }
  }
  if (!inner_->step_towards(target)) {
    const Progress<S> own = inner_->progress();
    t_ = inner_->time();
    x_ = inner_->state();
    return stop(own.outcome == Outcome::running ? Outcome::step_too_small : own.outcome, own.why);
  }
  note_speeds(inner_->state());
  last_step_->end_at(inner_->time(), inner_->state());
  if (const auto fired = last_step_->first(slow())) {
    const std::optional<Array> x = last_step_->state_at(fired->t);
    return x ? happen(fired->t, *x, fired->guards)
             : stop(Outcome::step_too_small, "the instant of an event cannot be found");
  }
  t_ = inner_->time();
  x_ = inner_->state();
  without_time_ = 0;
}

template <class S>
void Hybrid<S>::happen(const S& t, const Array& x, const std::vector<std::size_t>& fired) {
  without_time_ = t - last_event_ > S(1e-12) * (t - start_) ? 0 : without_time_ + 1;
  t_ = t;
  x_ = x;
  const auto count = static_cast<double>(events_.size());
  if (count > k_densest && count > k_densest * static_cast<double>(t_ - start_))
    return stop(Outcome::too_many_events,
                fmt::format("there are more than {} events in each second of the motion", k_densest));
  if (without_time_ > k_most_at_once)
    return stop(Outcome::too_many_events, "contacts and friction change without end at this instant");
  std::map<std::string, std::string> banned;
  std::set<std::string> closing;
  for (const std::size_t guard : fired) {
    const std::string& name = regime_->guards()[guard].of;
    const std::string& mode = modes_.at(name);
    if (mode == "holds") broken_.insert(name);
    if (regime_->guards()[guard].kind == Kind::slip) halted_.insert(name);
    if (mode == "open") {
      closing.insert(name);
      closed_.insert(name);
    } else {
      banned[name] = mode;
    }
  }
  if (!closing.empty()) hit(closing);
  settle(banned);
  halted_.clear();
  last_event_ = t_;
}

template class Hybrid<float>;
template class Hybrid<double>;
template class Hybrid<long double>;
template class Hybrid<Quad>;

}  // namespace gausssim
