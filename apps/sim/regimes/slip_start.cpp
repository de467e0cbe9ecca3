#include "sim/regimes/slip_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gauss/event/crossing.hpp"
#include "gauss/event/dense.hpp"
#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

using gauss::event::magnitude_of;

namespace {

constexpr int k_directions = 24;  ///< that are looked at before one is found between two of them
constexpr int k_rounds = 40;      ///< over frictions that depend on each other
constexpr double k_turn = 6.283185307179586476925286766559;

}  // namespace

template <class S>
SlipStart<S>::SlipStart(const Regime<S>& regime, const Switches& switches, const Modes& modes,
                        const Standing<S>& standing, std::vector<std::size_t> beginning, const Instant<S>& here,
                        const Numbers<S>& x)
    : regime_(regime), here_(here), x_(x) {
  for (const std::size_t f : beginning) {
    Beginning one;
    one.friction = switches.frictions[f].name;
    for (std::size_t g = 0; g < regime.guards().size(); ++g) {
      const GuardOf& guard = regime.guards()[g];
      if (guard.of == one.friction && guard.kind == gaussgen::model::Guard::Kind::slip) one.guards.push_back(g);
    }
    beginnings_.push_back(std::move(one));
  }
  find_changes(standing, switches, modes, beginning);
}

/// Least changes of speeds in the metric of masses that leave constraints, closed contacts and what sticks as they are.
template <class S>
void SlipStart<S>::find_changes(const Standing<S>& standing, const Switches& switches, const Modes& modes,
                                const std::vector<std::size_t>& beginning) {
  const auto& impact = standing.impact;
  const std::size_t n = impact.speeds;
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < impact.constraints; ++k) rows.push_back(k);
  for (std::size_t c = 0; c < impact.contacts(); ++c)
    if (modes.at(switches.contacts[c].name) == "closed") rows.push_back(impact.constraints + c);
  for (std::size_t f = 0; f < impact.slips.size(); ++f) {
    const bool begins = std::find(beginning.begin(), beginning.end(), f) != beginning.end();
    if (!begins && modes.at(switches.frictions[f].name) != "sticks") continue;
    for (std::size_t i = 0; i < impact.slips[f]; ++i) rows.push_back(impact.first_slip(f) + i);
  }
  gauss::event::DenseMatrix<S> system(n + rows.size(), n + rows.size());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) system(i, j) = impact.metric[i * n + j];
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) system(n + k, i) = system(i, n + k) = impact.rows[rows[k] * n + i];
  const auto change = [&](std::size_t f, const S& first, const S& second) {
    std::vector<S> right(n + rows.size(), S(0));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (rows[k] == impact.first_slip(f)) right[n + k] = first;
      if (rows[k] == impact.first_slip(f) + 1) right[n + k] = second;
    }
    std::vector<S> found = gauss::event::solve_dense(system, std::move(right));
    found.resize(n);
    return found;
  };
  for (std::size_t b = 0; b < beginning.size(); ++b) {
    const std::vector<S> left = standing.slip(beginning[b]);
    beginnings_[b].along[0] = change(beginning[b], S(1), S(0));
    beginnings_[b].along[1] = change(beginning[b], S(0), S(1));
    beginnings_[b].against = change(beginning[b], -left[0], -left[1]);
  }
}

template <class S>
Numbers<S> SlipStart<S>::with_slips() const {
  Numbers<S> result = x_;
  for (const Beginning& one : beginnings_) {
    const S cosine = speed_ * gauss::Math<S>::cos(one.angle), sine = speed_ * gauss::Math<S>::sin(one.angle);
    for (std::size_t i = 0; i < one.against.size(); ++i)
      result[here_.coordinates + i] += one.against[i] + cosine * one.along[0][i] + sine * one.along[1][i];
  }
  return result;
}

template <class S>
std::vector<S> SlipStart<S>::acceleration(const Beginning& of) const {
  const Numbers<S> x = with_slips();
  const S dt = here_.a_while(S(1e-6), S(1e-3));
  const std::vector<S> now = regime_.guard_values(here_.t, x);
  const std::vector<S> rates = regime_.guard_rates(here_.t, x, regime_.rates(here_.t, x), now, dt);
  std::vector<S> result;
  for (const std::size_t g : of.guards) result.push_back(rates[g]);
  return result;
}

/// Of its acceleration, the part across it: it turns that way.
template <class S>
S SlipStart<S>::turning(const Beginning& of) const {
  const std::vector<S> a = acceleration(of);
  return gauss::Math<S>::cos(of.angle) * a[1] - gauss::Math<S>::sin(of.angle) * a[0];
}

/// Into a direction to which it returns from both sides; of several, that in which it grows the most. False: there is none.
template <class S>
bool SlipStart<S>::turn(Beginning& one) {
  const auto at = [&one, this](const S& angle) {
    one.angle = angle;
    return turning(one);
  };
  const S step = S(k_turn) / k_directions;
  S best_angle = 0, best_growth = 0, low_value = at(S(0));
  bool is_found = false;
  for (int k = 0; k < k_directions; ++k) {
    const S low = S(k) * step, high = S(k + 1) * step, high_value = at(high);
    if (low_value >= S(0) && high_value < S(0)) {
      const S angle =
          low_value > S(0) ? gauss::event::falls_through(low, low_value, high, high_value, S(1e-15), at) : low;
      one.angle = angle;
      const std::vector<S> a = acceleration(one);
      const S growth = gauss::Math<S>::cos(angle) * a[0] + gauss::Math<S>::sin(angle) * a[1];
      if (!is_found || growth > best_growth) best_angle = angle, best_growth = growth;
      is_found = true;
    }
    low_value = high_value;
  }
  one.angle = best_angle;
  return is_found;
}

template <class S>
std::optional<Numbers<S>> SlipStart<S>::state(std::string& why) {
  // A first speed to find accelerations with, where nothing has moved yet.
  speed_ = here_.fastest > S(0) ? here_.fastest : S(1);
  const S part = std::max(S(1e-12), S(64 * gauss::Math<S>::epsilon()));
  speed_ *= part;
  S size = 0;
  for (const Beginning& one : beginnings_)
    for (const S& a : acceleration(one)) size = std::max(size, magnitude_of(a));
  speed_ = part * std::max(here_.fastest, size);
  for (int round = 0; round < k_rounds; ++round) {
    S change = 0;
    for (Beginning& one : beginnings_) {
      const S before = one.angle;
      if (!turn(one)) return why = fmt::format("'{}' finds no way to slide", one.friction), std::nullopt;
      change = std::max(change, magnitude_of(S(one.angle - before)));
    }
    if (beginnings_.size() == 1 || change < S(1e-9)) break;
  }
  for (const Beginning& one : beginnings_) {
    const std::vector<S> a = acceleration(one);
    const S growth = gauss::Math<S>::cos(one.angle) * a[0] + gauss::Math<S>::sin(one.angle) * a[1];
    if (growth < -S(1e-6) * size) return why = fmt::format("'{}' would turn back", one.friction), std::nullopt;
  }
  return with_slips();
}

template class SlipStart<float>;
template class SlipStart<double>;
template class SlipStart<long double>;
template class SlipStart<Quad>;

}  // namespace gausssim
