#include "sim/regimes/slip_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gauss/event/crossing.hpp"
#include "gauss/event/dense.hpp"
#include "gauss/event/null_space.hpp"
#include "gauss/scalar/float128.hpp"
#include "sim/drive/quad.hpp"

namespace gausssim {

using gauss::event::length_of;
using gauss::event::magnitude_of;
using gauss::event::product_of;

namespace {

constexpr int k_directions = 24;  ///< in a plane, that are looked at before one is found between two of them
constexpr int k_rounds = 200;     ///< of turns in more than a plane
constexpr double k_turn = 6.283185307179586476925286766559;
constexpr double k_none = 1e-9;  ///< part of a row that is none of its own

template <class S>
std::vector<S> in_one_direction(std::vector<S> v) {
  const S length = length_of(v);
  for (S& one : v) one /= length;
  return v;
}

}  // namespace

template <class S>
SlipStart<S>::SlipStart(const Regime<S>& regime, const Switches& switches, const Modes& modes,
                        const Standing<S>& standing, std::vector<std::size_t> beginning, const Instant<S>& here,
                        const Numbers<S>& x)
    : regime_(regime), here_(here), x_(x) {
  for (const std::size_t f : beginning) {
    const std::string& name = switches.frictions[f].name;
    frictions_ += fmt::format("{}'{}'", frictions_.empty() ? "" : ", ", name);
    for (std::size_t g = 0; g < regime.guards().size(); ++g) {
      const GuardOf& guard = regime.guards()[g];
      if (guard.of == name && guard.kind == gaussgen::model::Guard::Kind::slip) guards_.push_back(g);
    }
  }
  find_moves(standing, switches, modes, beginning);
  leave_rest(standing, beginning);
}

/// Of all changes of speeds that leave constraints, closed contacts and what sticks as they are, those that make slip: across all that make none, in the metric of masses.
template <class S>
void SlipStart<S>::find_moves(const Standing<S>& standing, const Switches& switches, const Modes& modes,
                              const std::vector<std::size_t>& beginning) {
  const auto& impact = standing.impact;
  const std::size_t n = impact.speeds;
  gauss::event::OrthonormalVectors<S> held(n);
  const auto scaled = gauss::event::in_metric(impact.metric, impact.rows, n, impact.count());
  const auto row = [&](std::size_t k) {
    const auto begin = scaled.entries.begin() + static_cast<std::ptrdiff_t>(k * n);
    return std::vector<S>(begin, begin + static_cast<std::ptrdiff_t>(n));
  };
  std::vector<std::vector<S>> holding, slipping;
  const auto hold = [&](std::size_t k) {
    const std::vector<S> one = row(k);
    if (length_of(one) > S(0)) holding.push_back(in_one_direction(one));
  };
  for (std::size_t k = 0; k < impact.constraints; ++k) hold(k);
  for (std::size_t c = 0; c < impact.contacts(); ++c)
    if (modes.at(switches.contacts[c].name) == "closed") hold(impact.constraints + c);
  for (std::size_t f = 0; f < impact.slips.size(); ++f) {
    const bool begins = std::find(beginning.begin(), beginning.end(), f) != beginning.end();
    for (std::size_t i = 0; i < impact.slips[f]; ++i) {
      if (begins) slipping.push_back(row(impact.first_slip(f) + i));
      if (!begins && modes.at(switches.frictions[f].name) == "sticks") hold(impact.first_slip(f) + i);
    }
  }
  held.add(std::move(holding), S(k_none));
  const std::size_t rank = held.vectors.size();
  S longest = 0;
  for (const auto& one : slipping) longest = std::max(longest, length_of(one));
  held.add(slipping, S(k_none) * longest);
  std::vector<std::vector<S>> across(held.vectors.begin() + static_cast<std::ptrdiff_t>(rank), held.vectors.end());
  for (const auto& one : slipping) {
    slips_.emplace_back();
    for (const auto& move : across) slips_.back().push_back(product_of(one, move));
  }
  for (const auto& move : across) moves_.push_back(gauss::event::out_of_metric(impact.metric, move));
}

/// From the nearest state without slip: what is left of it says nothing.
template <class S>
void SlipStart<S>::leave_rest(const Standing<S>& standing, const std::vector<std::size_t>& beginning) {
  std::vector<S> left;
  for (const std::size_t f : beginning)
    for (const S& one : standing.slip(f)) left.push_back(one);
  const Direction parts = moves_with(left);
  for (std::size_t j = 0; j < moves_.size(); ++j)
    for (std::size_t i = 0; i < moves_[j].size(); ++i) x_[here_.coordinates + i] -= parts[j] * moves_[j][i];
}

/// By least squares.
template <class S>
typename SlipStart<S>::Direction SlipStart<S>::moves_with(const std::vector<S>& slips) const {
  const std::size_t r = moves_.size();
  gauss::event::DenseMatrix<S> normal(r, r);
  std::vector<S> right(r, S(0));
  for (std::size_t k = 0; k < slips_.size(); ++k) {
    for (std::size_t i = 0; i < r; ++i) {
      right[i] += slips_[k][i] * slips[k];
      for (std::size_t j = 0; j < r; ++j) normal(i, j) += slips_[k][i] * slips_[k][j];
    }
  }
  return gauss::event::solve_dense(std::move(normal), std::move(right));
}

template <class S>
Numbers<S> SlipStart<S>::sliding(const Direction& way) const {
  S fastest = 0;
  for (const auto& slip : slips_) fastest = std::max(fastest, magnitude_of(product_of(slip, way)));
  Numbers<S> result = x_;
  for (std::size_t j = 0; j < moves_.size(); ++j)
    for (std::size_t i = 0; i < moves_[j].size(); ++i)
      result[here_.coordinates + i] += speed_ / fastest * way[j] * moves_[j][i];
  return result;
}

template <class S>
typename SlipStart<S>::Direction SlipStart<S>::acceleration(const Direction& way) const {
  const Numbers<S> x = sliding(way);
  const S dt = here_.a_while(S(1e-6), S(1e-3));
  const std::vector<S> now = regime_.guard_values(here_.t, x);
  const std::vector<S> rates = regime_.guard_rates(here_.t, x, regime_.rates(here_.t, x), now, dt);
  std::vector<S> result;
  for (const std::size_t g : guards_) result.push_back(rates[g]);
  return moves_with(result);
}

/// Of its acceleration, the part across it: it turns that way.
template <class S>
typename SlipStart<S>::Direction SlipStart<S>::turning(const Direction& way) const {
  Direction a = acceleration(way);
  const S along = product_of(a, way);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= along * way[i];
  return a;
}

template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::in_line() const {
  const Direction forwards{S(1)}, backwards{S(-1)};
  return acceleration(forwards)[0] < -acceleration(backwards)[0] ? backwards : forwards;
}

/// A direction to which it returns from both sides; of several, that in which it grows the most.
template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::in_plane() const {
  const auto at = [](const S& angle) { return Direction{gauss::Math<S>::cos(angle), gauss::Math<S>::sin(angle)}; };
  const auto turn = [&](const S& angle) {
    const Direction way = at(angle), a = acceleration(way);
    return S(way[0] * a[1] - way[1] * a[0]);
  };
  const S step = S(k_turn) / k_directions;
  std::optional<Direction> best;
  S best_growth = 0, low_value = turn(S(0));
  for (int k = 0; k < k_directions; ++k) {
    const S low = S(k) * step, high = S(k + 1) * step, high_value = turn(high);
    if (low_value >= S(0) && high_value < S(0)) {
      const Direction way =
          at(low_value > S(0) ? gauss::event::falls_through(low, low_value, high, high_value, S(1e-15), turn) : low);
      const S growth = product_of(way, acceleration(way));
      if (!best || growth > best_growth) best = way, best_growth = growth;
    }
    low_value = high_value;
  }
  return best;
}

/// Newton's method on the sphere of directions, from that which there would be without friction; where it does not come nearer, it turns as the slip would.
template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::in_space() const {
  Direction way(moves_.size(), S(0));
  way[0] = S(1);
  Direction free = acceleration(way);
  way[0] = S(-1);
  const Direction other = acceleration(way);
  for (std::size_t i = 0; i < way.size(); ++i) free[i] += other[i];
  if (length_of(free) > S(0)) way = in_one_direction(free);
  const S size = length_of(acceleration(way)) + length_of(free);
  Direction turn = turning(way);
  for (int round = 0; round < k_rounds; ++round) {
    if (!(length_of(turn) > S(1e-9) * size)) return way;
    S stiffness = 0;
    if (const auto next = nearer(way, turn, stiffness)) {
      way = *next;
    } else {
      for (std::size_t i = 0; i < way.size(); ++i) way[i] += turn[i] / (2 * std::max(stiffness, length_of(turn)));
      way = in_one_direction(way);
    }
    turn = turning(way);
  }
  return std::nullopt;
}

/// A step of Newton's method, if it halves what turns. `stiffness`: how fast it returns.
template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::nearer(const Direction& way, const Direction& turn,
                                                                     S& stiffness) const {
  const std::size_t r = way.size();
  const S part = S(1e-5);
  gauss::event::DenseMatrix<S> matrix(r, r);
  std::vector<S> right(r);
  for (std::size_t j = 0; j < r; ++j) {
    Direction aside = way;
    aside[j] += part;
    const Direction changed = turning(in_one_direction(aside));
    for (std::size_t i = 0; i < r; ++i) {
      // Across the sphere nothing changes.
      matrix(i, j) = (changed[i] - turn[i]) / part + way[i] * way[j];
      stiffness = std::max(stiffness, magnitude_of(matrix(i, j)));
    }
    right[j] = -turn[j];
  }
  Direction next = gauss::event::solve_dense(std::move(matrix), std::move(right));
  for (std::size_t i = 0; i < r; ++i) next[i] += way[i];
  if (!(length_of(next) > S(0))) return std::nullopt;
  next = in_one_direction(next);
  if (!(length_of(turning(next)) < length_of(turn) / 2)) return std::nullopt;
  return next;
}

template <class S>
std::optional<Numbers<S>> SlipStart<S>::state(std::string& why) {
  if (moves_.empty()) return why = fmt::format("{} cannot slide", frictions_), std::nullopt;
  // A first speed to find accelerations with, where nothing has moved yet.
  speed_ = here_.fastest > S(0) ? here_.fastest : S(1);
  const S part = std::max(S(1e-12), S(64 * gauss::Math<S>::epsilon()));
  speed_ *= part;
  Direction any(moves_.size(), S(0));
  any[0] = S(1);
  S size = length_of(acceleration(any));
  speed_ = part * std::max(here_.fastest, size);
  const std::optional<Direction> way = moves_.size() == 1 ? in_line() : moves_.size() == 2 ? in_plane() : in_space();
  if (!way) return why = fmt::format("{} finds no way to slide", frictions_), std::nullopt;
  if (product_of(*way, acceleration(*way)) < -S(1e-6) * size)
    return why = fmt::format("{} would turn back", frictions_), std::nullopt;
  return sliding(*way);
}

template class SlipStart<float>;
template class SlipStart<double>;
template class SlipStart<long double>;
template class SlipStart<Quad>;

}  // namespace gausssim
