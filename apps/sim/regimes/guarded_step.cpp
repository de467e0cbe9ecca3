#include "sim/regimes/guarded_step.hpp"

#include <algorithm>
#include <limits>

#include "gauss/event/crossing.hpp"
#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

using gauss::event::magnitude_of;

namespace {

constexpr int k_halvings = 3;  ///< of steps within which a guard may dip

}  // namespace

template <class S>
GuardedStep<S>::GuardedStep(const Regime<S>& regime, const Modes& modes, const Instant<S>& here, std::string method,
                            const MethodSettings<S>& of_method)
    : regime_(regime), here_(here), entered_(here.t), method_(std::move(method)), of_method_(of_method) {
  using Kind = gaussgen::model::Guard::Kind;
  for (std::size_t g = 0; g < regime.guards().size(); ++g) {
    const GuardOf& guard = regime.guards()[g];
    const std::string& mode = modes.at(guard.of);
    if (guard.kind == Kind::falls) watched_.push_back({g, S(1), mode == "open", false});
    if (guard.kind == Kind::slip && mode != "slides")
      watched_.push_back({g, S(mode == "backwards" ? -1 : 1), false, true});
  }
  to_.t = here.t;
  to_.x = here.x;
  look_at_guards(to_);
}

template <class S>
void GuardedStep<S>::end_at(const S& t, const Array& x) {
  std::swap(from_, to_);
  to_.t = t;
  to_.x = x;
  look_at_guards(to_);
}

template <class S>
std::string GuardedStep<S>::undefined() const {
  for (const Watched& one : watched_)
    if (!(to_.values[one.guard] == to_.values[one.guard])) return regime_.guards()[one.guard].name;
  return "";
}

template <class S>
std::optional<typename GuardedStep<S>::Fired> GuardedStep<S>::first(const S& slow) const {
  std::vector<std::pair<S, std::size_t>> found;
  for (const Watched& one : watched_) {
    if (const std::optional<S> at = crossing(one, slow)) found.emplace_back(*at, one.guard);
  }
  if (found.empty()) return std::nullopt;
  Fired fired{std::min_element(found.begin(), found.end())->first, {}};
  // Those of one instant are one event.
  const S together =
      std::max(S(S(1e-12) * (to_.t - from_.t)), S(4 * gauss::Math<S>::epsilon() * magnitude_of(fired.t)));
  for (const auto& [at, guard] : found)
    if (at <= fired.t + std::max(together, uncertainty_of(guard, fired.t))) fired.guards.push_back(guard);
  return fired;
}

/// The time that a gap takes for what its places are rounded by: feet that fall flat touch at once.
template <class S>
S GuardedStep<S>::uncertainty_of(std::size_t guard, const S& t) const {
  const bool is_gap = std::any_of(watched_.begin(), watched_.end(),
                                  [&](const Watched& one) { return one.guard == guard && one.is_told; });
  const std::optional<Place> place = is_gap ? place_at(t) : std::nullopt;
  if (!place || !(place->rates[guard] < S(0))) return S(0);
  return -32 * gauss::Math<S>::epsilon() * regime_.reaches(place->t, place->x)[guard] / place->rates[guard];
}

/// Rates of gaps are told; those of others follow from a look a little later.
template <class S>
void GuardedStep<S>::look_at_guards(Place& place) const {
  regime_.fill_guards(place.t, place.x, place.values);
  place.rates.resize(place.values.size());
  bool are_told = true;
  for (const Watched& one : watched_) {
    are_told = are_told && one.is_told;
    if (one.is_told) place.rates[one.guard] = place.values[one.guard + 1];
  }
  if (are_told) return;
  const S dt = S(1e-7) * std::max(S(place.t - entered_), S(1e-6));
  const std::vector<S> rates = regime_.guard_rates(place.t, place.x, regime_.rates(place.t, place.x), place.values, dt);
  for (const Watched& one : watched_)
    if (!one.is_told) place.rates[one.guard] = rates[one.guard];
}

/// A place within the last step at which the guard is below 0, between two at which it is not; nothing where there is none. A cubic stands for the guard
/// where it is far above 0 beside its changes, or right at half of the step.
template <class S>
std::optional<typename GuardedStep<S>::Place> GuardedStep<S>::dip(const Watched& one, const Place& low,
                                                                  const Place& high, const S& slow, int depth) const {
  const std::size_t g = one.guard;
  const S h = high.t - low.t;
  const gauss::event::Ends<S> ends{one.sense * low.values[g], h * one.sense * low.rates[g], one.sense * high.values[g],
                                   h * one.sense * high.rates[g]};
  const S least = ends.least_control();
  if (least > ends.largest_control() - least) return std::nullopt;
  // Slip that begins, but for rounding, begins.
  if (one.is_slip && magnitude_of(low.values[g]) <= slow && !(least < -slow)) return std::nullopt;
  if (depth == 0) {
    const std::optional<S> part = gauss::event::least_inside(ends);
    if (!part || !(ends(*part) < S(0))) return std::nullopt;
    std::optional<Place> found = place_at(low.t + *part * h);
    return found && one.sense * found->values[g] < S(0) ? found : std::nullopt;
  }
  std::optional<Place> middle = place_at(low.t + h / 2);
  if (!middle || one.sense * middle->values[g] < S(0)) return middle;
  const S off = magnitude_of(S(one.sense * middle->values[g] - ends(S(0.5))));
  if (least > 4 * off) return std::nullopt;
  if (auto found = dip(one, low, *middle, slow, depth - 1)) return found;
  return dip(one, *middle, high, slow, depth - 1);
}

template <class S>
std::optional<typename GuardedStep<S>::Place> GuardedStep<S>::place_at(const S& t) const {
  const std::optional<Array> x = state_at(t);
  if (!x) return std::nullopt;
  Place place;
  place.t = t;
  place.x = *x;
  look_at_guards(place);
  return place;
}

/// Not what touches without a speed, as what has just opened does by rounding: it is a hit when it goes on closing.
template <class S>
bool GuardedStep<S>::is_hit(const Watched& one, const S& at, const S& slow) const {
  if (!one.is_told) return true;
  const std::optional<Place> place = place_at(at);
  if (!place) return true;
  const S rate = place->rates[one.guard];
  return rate < -slow ||
         (rate < S(0) && place->values[one.guard] < -S(1e-9) * regime_.reaches(place->t, place->x)[one.guard]);
}

/// The time at which a guard falls through 0 within the last step.
template <class S>
std::optional<S> GuardedStep<S>::crossing(const Watched& one, const S& slow) const {
  const std::size_t g = one.guard;
  const S h = to_.t - from_.t, begin = one.sense * from_.values[g], end = one.sense * to_.values[g];
  const auto value = [&](const S& at) { return value_at(at, one); };
  // A slip that others hold at 0 is that but for rounding.
  if (one.is_slip && magnitude_of(begin) <= slow && magnitude_of(end) <= slow) return std::nullopt;
  S high = to_.t, high_value = end;
  if (!(end < S(0))) {
    const std::optional<Place> below = dip(one, from_, to_, slow, k_halvings);
    if (!below) return std::nullopt;
    high = below->t;
    high_value = one.sense * below->values[g];
  }
  // What rounding has left a little below 0 is no event while it rises.
  if (!(begin > S(0)) && one.sense * from_.rates[g] > S(0) && high_value >= begin) return std::nullopt;
  // What has just been at 0, as far as places have digits, is above it for a while, unless it falls at once.
  const S none = one.is_told ? S(16 * gauss::Math<S>::epsilon() * regime_.reaches(from_.t, from_.x)[one.guard]) : S(0);
  const S last = high;
  S low = from_.t, low_value = begin;
  constexpr int k_looks = 40;
  for (int k = 0; k < k_looks && !(low_value > none); ++k) {
    const S at = from_.t + (high - from_.t) / 2;
    if (!(from_.t < at && at < high)) break;
    const S found = value(at);
    if (found > none) {
      low = at;
      low_value = found;
    } else {
      high = at;
      high_value = found;
    }
  }
  const S nearness = std::max(S(S(1e-13) * h), S(2 * gauss::Math<S>::epsilon() * magnitude_of(to_.t)));
  const S at =
      low_value > none ? gauss::event::falls_through(low, low_value, high, high_value, nearness, value) : from_.t;
  return first_hit(one, at, last, slow, nearness);
}

/// A bounce may be lower than a gap is rounded: it is hit where it goes on closing.
template <class S>
std::optional<S> GuardedStep<S>::first_hit(const Watched& one, S low, S high, const S& slow, const S& nearness) const {
  if (is_hit(one, low, slow)) return low;
  if (!is_hit(one, high, slow)) return std::nullopt;
  while (nearness < high - low) {
    const S middle = low + (high - low) / 2;
    (is_hit(one, middle, slow) ? high : low) = middle;
  }
  return high;
}

/// Within the last step, by steps that end there.
template <class S>
std::optional<typename GuardedStep<S>::Array> GuardedStep<S>::state_at(const S& t) const {
  if (!(from_.t < t)) return from_.x;
  std::string why;
  const auto again = make_integrator(method_, regime_.motion(), from_.x, from_.t, of_method_, why);
  if (!again) return std::nullopt;
  here_.tell(*again);
  if (!again->advance_to(t)) return std::nullopt;
  return again->state();
}

template <class S>
S GuardedStep<S>::value_at(const S& t, const Watched& one) const {
  const std::optional<Array> x = state_at(t);
  return x ? S(one.sense * regime_.guard_values(t, *x)[one.guard]) : S(std::numeric_limits<double>::quiet_NaN());
}

template class GuardedStep<float>;
template class GuardedStep<double>;
template class GuardedStep<long double>;
template class GuardedStep<Quad>;

}  // namespace gausssim
