#include "sim/regimes/hybrid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>

#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"
#include "sim/regimes/impact.hpp"
#include "sim/regimes/stiffness.hpp"

namespace gausssim {

using gauss::simulate::Outcome;
using Kind = gaussgen::model::Guard::Kind;

namespace {

constexpr const char* k_hits = "hits";
constexpr const char* k_for_stiff = "radau";
constexpr int k_most_at_once = 100;  ///< events between which no time goes by
constexpr double k_densest = 1000;   ///< events in a second of motion, once there are so many
// Steps times the fastest decay: explicit methods have no longer ones than about 5.
constexpr double k_stiff = 3, k_not_stiff = 1;
constexpr int k_looks = 8;  ///< steps, from one look at that to the next

}  // namespace

template <class S>
Hybrid<S>::Hybrid(std::shared_ptr<RegimeSource> source, Array start, const S& t, Setting setting)
    : pool_(std::move(source), setting.change, setting.of_method.ends), setting_(std::move(setting)) {
  here_.t = here_.start = here_.last_event = t;
  here_.x = std::move(start);
}

template <class S>
Regime<S>* Hybrid<S>::ground() {
  std::string why;
  Regime<S>* const found = pool_.at(here_.ground_modes(pool_.switches()), why);
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
  events_.push_back({static_cast<double>(here_.t), what, impulse});
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
               [this](const Event& event) { return event.t <= static_cast<double>(here_.t); });
  modes_ = here_.ground_modes(pool_.switches());
  for (const Event& event : events_) {
    const std::size_t blank = event.what.rfind(' ');
    const auto known = modes_.find(event.what.substr(0, blank));
    const std::string mode = event.what.substr(blank + 1);
    if (known == modes_.end() || mode == k_hits) continue;
    known->second = mode;
    if (mode == "broken") here_.broken.insert(known->first);
  }
}

template <class S>
bool Hybrid<S>::advance_to(const S& end) {
  if (!is_started_ && !start()) return false;
  while (here_.t < end && outcome_ == Outcome::running) step(end);
  return outcome_ == Outcome::running && here_.t == end;
}

template <class S>
bool Hybrid<S>::look(Standing<S>& standing) {
  Regime<S>* const free = ground();
  if (free == nullptr) return false;
  const std::vector<S> reaches = free->reaches(here_.t, here_.x);
  for (std::size_t g = 0; g < reaches.size(); ++g)
    if (free->guards()[g].kind == Kind::falls) here_.reaches[free->guards()[g].of] = reaches[g];
  if (find_standing(*free, pool_.switches(), here_.t, here_.x, standing)) return true;
  stop(Outcome::model_failed, "contacts and slips have no value here");
  return false;
}

template <class S>
bool Hybrid<S>::start() {
  is_started_ = true;
  Standing<S> standing;
  if (!look(standing)) return false;
  here_.coordinates = ground()->functions().n_q;
  here_.note_sizes(here_.x);
  const Switches& switches = pool_.switches();
  std::set<std::string> closing;
  for (std::size_t c = 0; c < switches.contacts.size(); ++c) {
    const std::string& name = switches.contacts[c].name;
    const S reach = here_.reaches.at(name);
    if (standing.gaps[c] < -S(1e-9) * reach) {
      stop(Outcome::no_regime, fmt::format("the contact '{}' begins with a gap of {:.3g}: what touches overlaps", name,
                                           static_cast<double>(standing.gaps[c])));
      return false;
    }
    // Here nothing but the digits of what is given makes a gap.
    if (standing.gaps[c] > std::max(S(1e-12), S(16 * gauss::Math<S>::epsilon())) * reach) continue;
    here_.closed.insert(name);
    if (standing.gap_rate(c) < -here_.slow()) closing.insert(name);
  }
  if (modes_.empty()) modes_ = here_.ground_modes(switches);
  if (!closing.empty()) hit_at(closing);
  return outcome_ == Outcome::running && settle({}, {});
}

template <class S>
void Hybrid<S>::hit_at(const std::set<std::string>& closing) {
  Standing<S> standing;
  if (!look(standing)) return;
  std::string why;
  Regime<S>& free = *ground();
  const auto hits = hit(free, regime_ == nullptr ? free : *regime_, standing, pool_.switches(), closing, here_, why);
  if (!hits) return stop(Outcome::no_regime, why);
  for (const Hit& one : *hits) note(one.contact + " " + k_hits, one.impulse);
}

template <class S>
bool Hybrid<S>::settle(const Bans& banned, const Bans& ended_here) {
  std::string why;
  bool is_calm = false;
  // Each pass but the last two breaks a link.
  for (std::size_t pass = 0; pass <= pool_.switches().links.size() + 1; ++pass) {
    if (outcome_ != Outcome::running) return false;
    Standing<S> standing;
    if (!look(standing)) return false;
    std::string overloaded;
    std::vector<typename RegimeChoice<S>::Ended> tries{{ended_here, {}}};
    if (banned.size() < ended_here.size()) tries.push_back({banned, {}});
    // Each mode that has ended may go on without the others.
    if (!banned.empty()) tries.push_back({{}, modes_});
    for (const auto& ended : tries) {
      RegimeChoice<S> choice(pool_, *ground(), standing, here_, ended);
      std::string why_not;
      if (auto next = choice.find(why_not)) {
        enter(std::move(*next));
        return outcome_ == Outcome::running;
      }
      overloaded = choice.overloaded();
      if (why.empty()) why = why_not + (choice.underived().empty() ? "" : "; " + choice.underived());
    }
    if (!overloaded.empty()) {
      here_.broken.insert(overloaded);
      continue;
    }
    // Rates that count as none may be such that nothing goes on with them, as of a block that has rocked to rest: an impact takes them.
    if (is_calm) break;
    is_calm = true;
    hit_at({});
  }
  if (pool_.has_ended())
    stop(Outcome::interrupted, "");
  else
    stop(Outcome::no_regime, fmt::format("contacts and friction leave no motion from here on ({})", why));
  return false;
}

template <class S>
void Hybrid<S>::enter(NextRegime<S> next) {
  for (const auto& [name, mode] : next.modes) {
    const auto known = modes_.find(name);
    if (known == modes_.end() || known->second != mode) note(name + " " + mode);
  }
  here_.x = std::move(next.x);
  modes_ = std::move(next.modes);
  regime_ = next.regime;
  here_.closed.clear();
  for (const ContactSwitch& contact : pool_.switches().contacts)
    if (modes_.at(contact.name) == "closed") here_.closed.insert(contact.name);
  find_rounding();
  slipping_.clear();
  for (const FrictionSwitch& friction : pool_.switches().frictions)
    if (modes_.at(friction.name) == "slides") slipping_.push_back(&friction);
  integrate_by(next.has_fresh_slip && regime_->motion().has_jacobian() ? k_for_stiff : setting_.method);
}

/// Reactions take away what would accelerate bodies that nothing holds: what is left is that but for rounding.
template <class S>
void Hybrid<S>::find_rounding() {
  here_.rounding.assign(here_.x.size(), S(0));
  Regime<S>* const free = ground();
  if (free == nullptr || free == regime_) return;
  const Array rates = free->rates(here_.t, here_.x);
  const S least = 64 * gauss::Math<S>::epsilon();
  const S acceleration = largest_of(rates.data() + here_.coordinates, rates.size() - here_.coordinates);
  // Where nothing has moved yet, speeds that count are those after a way as long as places are far.
  const S fall = gauss::Math<S>::sqrt(acceleration * largest_of(here_.x.data(), here_.coordinates));
  here_.rounded_speed = least * gauss::Math<S>::sqrt(acceleration * size_of_places(here_.x, here_.coordinates));
  const S speed = here_.fastest > S(0) ? here_.fastest : fall > S(0) ? fall : acceleration;
  for (std::size_t i = 0; i < here_.x.size(); ++i)
    here_.rounding[i] = least * (i < here_.coordinates ? speed : acceleration);
}

/// From the present state on.
template <class S>
void Hybrid<S>::integrate_by(const std::string& method) {
  if (inner_) {
    before_ = progress();
    before_.outcome = Outcome::running;
    before_.why.clear();
  }
  MethodSettings<S> settings = setting_.of_method;
  // Of a slip of 1e-12, which is on its way to its end.
  settings.crosses_lost_digits = slipping_.empty() && method != k_for_stiff;
  const MethodSettings<S> within_steps = settings;
  settings.most_steps -= before_.steps;
  if (settings.most_steps <= 0) return stop(Outcome::too_many_steps, "");
  std::string why;
  for (const std::string& name : {method, setting_.method, std::string("prince87")}) {
    method_ = name;
    why.clear();
    inner_ = make_integrator(name, regime_->motion(), here_.x, here_.t, settings, why);
    if (!inner_) continue;
    here_.tell(*inner_);
    break;
  }
  if (!inner_) return stop(Outcome::bad_settings, why);
  unwatched_ = 0;
  last_step_.emplace(*regime_, modes_, here_, method_, within_steps);
}

/// Slip in two directions is a root of squares, which no step passes: steps end before, and come near by a tenth each.
template <class S>
S Hybrid<S>::cap(const S& end, std::string& halting) const {
  S result = end;
  for (const FrictionSwitch* const friction : slipping_) {
    const S dt = here_.a_while(S(1e-7), S(1e-6));
    const std::vector<S> now = regime_->guard_values(here_.t, here_.x);
    const std::vector<S> rates = regime_->guard_rates(here_.t, here_.x, regime_->rates(here_.t, here_.x), now, dt);
    S square = 0, falling = 0;
    for (std::size_t g = 0; g < now.size(); ++g) {
      const GuardOf& guard = regime_->guards()[g];
      if (guard.of != friction->name || guard.kind != Kind::slip) continue;
      square += now[g] * now[g];
      falling -= now[g] * rates[g];
    }
    const S at = falling > S(0) ? S(here_.t + S(0.9) * square / falling) : result;
    if (!(at < result)) continue;
    result = at;
    halting = friction->name;
  }
  return result;
}

/// The direction of a slip comes back to where forces drive it the faster the smaller the slip is, which makes small ones stiff. Other methods go on where it is not any more.
template <class S>
void Hybrid<S>::watch_stiffness(const S& step) {
  if (slipping_.empty() || ++unwatched_ < k_looks) return;
  unwatched_ = 0;
  const bool is_for_stiff = method_ == k_for_stiff;
  if (setting_.method == k_for_stiff) return;
  const S stiffness = step * fastest_decay(*regime_, here_.t, here_.x);
  if (is_for_stiff ? stiffness < S(k_not_stiff) : stiffness > S(k_stiff))
    integrate_by(is_for_stiff ? setting_.method : k_for_stiff);
}

template <class S>
void Hybrid<S>::step(const S& end) {
  std::string halting;
  const S target = slipping_.empty() ? end : cap(end, halting);
  if (target < end) {
    const S least = 16 * gauss::Math<S>::epsilon() * gauss::event::magnitude_of(here_.t);
    if (target - here_.t <= std::max(least, S(S(1e-13) * (here_.t - here_.last_event)))) {
      here_.halted.insert(halting);
      return happen(here_.t, Array(here_.x), {});
    }
  }
  if (!inner_->step_towards(target)) {
    const Progress<S> own = inner_->progress();
    here_.t = inner_->time();
    here_.x = inner_->state();
    return stop(own.outcome == Outcome::running ? Outcome::step_too_small : own.outcome, own.why);
  }
  here_.note_sizes(inner_->state());
  last_step_->end_at(inner_->time(), inner_->state());
  if (const std::string undefined = last_step_->undefined(); !undefined.empty())
    return stop(Outcome::model_failed, fmt::format("'{}' has no value", undefined));
  if (const auto fired = last_step_->first(here_.slow())) {
    const std::optional<Array> x = last_step_->state_at(fired->t);
    if (x) return happen(fired->t, *x, fired->guards);
    return pool_.has_ended() ? stop(Outcome::interrupted, "")
                             : stop(Outcome::step_too_small, "the instant of an event cannot be found");
  }
  const S length = inner_->time() - here_.t;
  here_.t = inner_->time();
  here_.x = inner_->state();
  without_time_ = 0;
  watch_stiffness(length);
}

template <class S>
void Hybrid<S>::happen(const S& t, const Array& x, const std::vector<std::size_t>& fired) {
  without_time_ = t - here_.last_event > S(1e-12) * (t - here_.start) ? 0 : without_time_ + 1;
  here_.t = t;
  here_.x = x;
  const auto count = static_cast<double>(events_.size());
  if (count > k_densest && count > k_densest * static_cast<double>(here_.t - here_.start))
    return stop(Outcome::too_many_events,
                fmt::format("there are more than {} events in each second of the motion", k_densest));
  if (without_time_ > k_most_at_once)
    return stop(Outcome::too_many_events, "contacts and friction change without end at this instant");
  // What has ended at this instant does not begin again at it, where that leaves something.
  if (without_time_ == 0) ended_here_.clear();
  std::map<std::string, std::string> banned;
  std::set<std::string> closing;
  for (const std::size_t guard : fired) {
    const std::string& name = regime_->guards()[guard].of;
    const std::string& mode = modes_.at(name);
    if (mode == "holds") here_.broken.insert(name);
    if (regime_->guards()[guard].kind == Kind::slip) here_.halted.insert(name);
    if (mode == "open") {
      closing.insert(name);
      here_.closed.insert(name);
    } else {
      banned[name] = mode;
    }
  }
  if (!closing.empty()) {
    hit_at(closing);
    ended_here_.clear();
  }
  for (const auto& [name, mode] : banned) ended_here_[name] = mode;
  settle(banned, ended_here_);
  here_.halted.clear();
  here_.last_event = here_.t;
}

template class Hybrid<float>;
template class Hybrid<double>;
template class Hybrid<long double>;
template class Hybrid<Quad>;

}  // namespace gausssim
