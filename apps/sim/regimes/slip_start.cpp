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

using gauss::event::in_one_direction;
using gauss::event::length_of;
using gauss::event::magnitude_of;
using gauss::event::product_of;

namespace {

constexpr int k_directions = 24;  ///< in a plane, that are looked at before one is found between two of them
constexpr int k_rounds = 200;     ///< of turns in more than a plane
constexpr int k_sweeps = 40;      ///< over slips that are not of one body
constexpr double k_turn = 6.283185307179586476925286766559;
constexpr double k_none = 1e-9;  ///< part of a row that is none of its own

/// Of speeds: a slip whose direction has half of the digits, and that changes accelerations by the other half.
template <class S>
S half_of_digits() {
  return gauss::Math<S>::sqrt(gauss::Math<S>::epsilon());
}

}  // namespace

template <class S>
SlipStart<S>::SlipStart(const Regime<S>& regime, const Switches& switches, const Modes& modes,
                        const Standing<S>& standing, std::vector<std::size_t> beginning, const Instant<S>& here,
                        const Numbers<S>& x)
    : regime_(regime), here_(here), x_(x) {
  find_blocks(standing, switches, modes, beginning);
}

template <class S>
void SlipStart<S>::find_blocks(const Standing<S>& standing, const Switches& switches, const Modes& modes,
                               const std::vector<std::size_t>& beginning) {
  const auto& impact = standing.impact;
  gauss::event::OrthonormalVectors<S> held(impact.speeds);
  held.add(held_rows(standing, switches, modes), S(k_none));
  std::vector<Vectors> across;
  for (const std::size_t f : beginning) {
    across.emplace_back();
    for (std::size_t i = 0; i < impact.slips[f]; ++i)
      across.back().push_back(held.across(impact.row_in_metric(impact.first_slip(f) + i)));
  }
  const auto are_coupled = [](const Vectors& a, const Vectors& b) {
    for (const auto& one : a)
      for (const auto& other : b)
        if (magnitude_of(product_of(one, other)) > S(k_none) * length_of(one) * length_of(other)) return true;
    return false;
  };
  std::vector<std::vector<std::size_t>> groups;  // of places in `beginning`
  for (std::size_t b = 0; b < beginning.size(); ++b) {
    std::vector<std::size_t> own{b};
    for (std::size_t g = groups.size(); g-- > 0;) {
      if (std::none_of(groups[g].begin(), groups[g].end(),
                       [&](std::size_t other) { return are_coupled(across[b], across[other]); }))
        continue;
      own.insert(own.end(), groups[g].begin(), groups[g].end());
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(g));
    }
    groups.push_back(std::move(own));
  }
  for (const auto& group : groups) {
    std::vector<std::size_t> frictions;
    std::vector<S> left;
    for (const std::size_t b : group) {
      frictions.push_back(beginning[b]);
      for (const S& one : standing.slip(beginning[b])) left.push_back(one);
    }
    blocks_.push_back(block_of(frictions, standing, switches, held));
    leave_rest(blocks_.back(), left);
  }
}

/// Of all changes of speeds that leave as it is what holds, those that make slip: across all that make none, in the metric of masses.
template <class S>
typename SlipStart<S>::Block SlipStart<S>::block_of(const std::vector<std::size_t>& frictions,
                                                    const Standing<S>& standing, const Switches& switches,
                                                    gauss::event::OrthonormalVectors<S> held) const {
  const auto& impact = standing.impact;
  Block block;
  Vectors slipping;
  S longest = 0;
  for (const std::size_t f : frictions) {
    const std::string& name = switches.frictions[f].name;
    block.frictions += fmt::format("{}'{}'", block.frictions.empty() ? "" : ", ", name);
    for (std::size_t g = 0; g < regime_.guards().size(); ++g) {
      const GuardOf& guard = regime_.guards()[g];
      if (guard.of == name && guard.kind == gaussgen::model::Guard::Kind::slip) block.guards.push_back(g);
    }
    for (std::size_t i = 0; i < impact.slips[f]; ++i) {
      slipping.push_back(impact.row_in_metric(impact.first_slip(f) + i));
      longest = std::max(longest, length_of(slipping.back()));
    }
  }
  const std::size_t rank = held.vectors.size();
  held.add(slipping, S(k_none) * longest);
  const Vectors across(held.vectors.begin() + static_cast<std::ptrdiff_t>(rank), held.vectors.end());
  for (const auto& one : slipping) {
    block.slips.emplace_back();
    for (const auto& move : across) block.slips.back().push_back(product_of(one, move));
  }
  for (const auto& move : across) block.moves.push_back(impact.out_of_metric(move));
  // A direction that nothing singles out: no slip is 0 in it.
  for (std::size_t j = 0; j < across.size(); ++j) block.way.push_back(S(1) / S(1.0 + 0.37 * static_cast<double>(j)));
  if (!block.way.empty()) block.way = in_one_direction(block.way);
  return block;
}

/// From the nearest state without slip: what is left of it says nothing.
template <class S>
void SlipStart<S>::leave_rest(const Block& block, const std::vector<S>& left) {
  const Direction parts = moves_with(block, left);
  for (std::size_t j = 0; j < block.moves.size(); ++j)
    for (std::size_t i = 0; i < block.moves[j].size(); ++i) x_[here_.coordinates + i] -= parts[j] * block.moves[j][i];
}

/// By least squares.
template <class S>
typename SlipStart<S>::Direction SlipStart<S>::moves_with(const Block& block, const std::vector<S>& slips) const {
  const std::size_t r = block.moves.size();
  gauss::event::DenseMatrix<S> normal(r, r);
  std::vector<S> right(r, S(0));
  for (std::size_t k = 0; k < block.slips.size(); ++k) {
    for (std::size_t i = 0; i < r; ++i) {
      right[i] += block.slips[k][i] * slips[k];
      for (std::size_t j = 0; j < r; ++j) normal(i, j) += block.slips[k][i] * block.slips[k][j];
    }
  }
  return gauss::event::solve_dense(std::move(normal), std::move(right));
}

/// Each block with the same largest slip.
template <class S>
Numbers<S> SlipStart<S>::sliding() const {
  Numbers<S> result = x_;
  for (const Block& block : blocks_) {
    S fastest = 0;
    for (const auto& slip : block.slips) fastest = std::max(fastest, magnitude_of(product_of(slip, block.way)));
    for (std::size_t j = 0; j < block.moves.size(); ++j)
      for (std::size_t i = 0; i < block.moves[j].size(); ++i)
        result[here_.coordinates + i] += speed_ / fastest * block.way[j] * block.moves[j][i];
  }
  return result;
}

template <class S>
typename SlipStart<S>::Direction SlipStart<S>::acceleration(Block& block, const Direction& way) const {
  const Direction before = block.way;
  block.way = way;
  const Numbers<S> x = sliding();
  block.way = before;
  const S dt = here_.a_while(S(1e-6), S(1e-3));
  const std::vector<S> now = regime_.guard_values(here_.t, x);
  const std::vector<S> rates = regime_.guard_rates(here_.t, x, regime_.rates(here_.t, x), now, dt);
  std::vector<S> result;
  for (const std::size_t g : block.guards) result.push_back(rates[g]);
  return moves_with(block, result);
}

/// Of its acceleration, the part across it: it turns that way.
template <class S>
typename SlipStart<S>::Direction SlipStart<S>::turning(Block& block, const Direction& way) const {
  Direction a = acceleration(block, way);
  const S along = product_of(a, way);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= along * way[i];
  return a;
}

template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::way_of(Block& block) const {
  if (block.moves.size() == 2) return in_plane(block);
  if (block.moves.size() > 2) return in_space(block);
  const Direction forwards{S(1)}, backwards{S(-1)};
  return acceleration(block, forwards)[0] < -acceleration(block, backwards)[0] ? backwards : forwards;
}

/// A direction to which it returns from both sides; of several, that in which it grows the most.
template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::in_plane(Block& block) const {
  const auto at = [](const S& angle) { return Direction{gauss::Math<S>::cos(angle), gauss::Math<S>::sin(angle)}; };
  const auto turn = [&](const S& angle) {
    const Direction way = at(angle), a = acceleration(block, way);
    return S(way[0] * a[1] - way[1] * a[0]);
  };
  // Pushes are along axes more often than not: none of the directions that are looked at first is.
  const S step = S(k_turn) / k_directions, begin = step / 3;
  const S first_value = turn(begin);
  std::optional<Direction> best;
  S best_growth = 0, low_value = first_value;
  for (int k = 0; k < k_directions; ++k) {
    const S low = begin + S(k) * step, high = low + step;
    // The last one is the first one, whatever rounding makes of its angle.
    const S high_value = k + 1 == k_directions ? first_value : turn(high);
    if (low_value >= S(0) && high_value < S(0)) {
      const Direction way =
          at(low_value > S(0) ? gauss::event::falls_through(low, low_value, high, high_value, S(1e-15), turn) : low);
      const S growth = product_of(way, acceleration(block, way));
      if (!best || growth > best_growth) best = way, best_growth = growth;
    }
    low_value = high_value;
  }
  return best;
}

/// Newton's method on the sphere of directions, from that which there would be without friction; where it does not come nearer, it turns as the slip would.
template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::in_space(Block& block) const {
  Direction way = block.way, opposite = way;
  for (S& one : opposite) one = -one;
  Direction free = acceleration(block, way);
  const Direction other = acceleration(block, opposite);
  for (std::size_t i = 0; i < way.size(); ++i) free[i] += other[i];
  const S size = length_of(acceleration(block, way)) + length_of(free);
  if (length_of(free) > S(1e-9) * size) way = in_one_direction(free);
  Direction turn = turning(block, way);
  for (int round = 0; round < k_rounds; ++round) {
    if (length_of(turn) <= 8 * half_of_digits<S>() * size) return way;
    S stiffness = 0;
    if (const auto next = nearer(block, way, turn, stiffness)) {
      way = *next;
    } else {
      for (std::size_t i = 0; i < way.size(); ++i) way[i] += turn[i] / (2 * std::max(stiffness, length_of(turn)));
      way = in_one_direction(way);
    }
    turn = turning(block, way);
  }
  return std::nullopt;
}

/// A step of Newton's method, if it halves what turns. `stiffness`: how fast it returns.
template <class S>
std::optional<typename SlipStart<S>::Direction> SlipStart<S>::nearer(Block& block, const Direction& way,
                                                                     const Direction& turn, S& stiffness) const {
  const std::size_t r = way.size();
  const S part = S(1e-5);
  gauss::event::DenseMatrix<S> matrix(r, r);
  std::vector<S> right(r);
  for (std::size_t j = 0; j < r; ++j) {
    Direction aside = way;
    aside[j] += part;
    const Direction changed = turning(block, in_one_direction(aside));
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
  if (!(length_of(turning(block, next)) < length_of(turn) / 2)) return std::nullopt;
  return next;
}

template <class S>
std::optional<Numbers<S>> SlipStart<S>::state(std::string& why) {
  for (const Block& block : blocks_)
    if (block.moves.empty()) return why = fmt::format("{} cannot slide", block.frictions), std::nullopt;
  // A first speed to find accelerations with, where nothing has moved yet.
  speed_ = half_of_digits<S>() * (here_.fastest > S(0) ? here_.fastest : S(1));
  S size = 0;
  // One way friction and forces may just cancel each other.
  for (Block& block : blocks_) {
    Direction back = block.way;
    for (S& one : back) one = -one;
    size = std::max({size, length_of(acceleration(block, block.way)), length_of(acceleration(block, back))});
  }
  const S speed = std::max(here_.fastest, size);
  speed_ = half_of_digits<S>() * speed;
  for (int round = 0; round < k_sweeps; ++round) {
    S change = 0;
    for (Block& block : blocks_) {
      const auto way = way_of(block);
      if (!way) return why = fmt::format("{} finds no way to slide", block.frictions), std::nullopt;
      for (std::size_t j = 0; j < way->size(); ++j)
        change = std::max(change, magnitude_of(S((*way)[j] - block.way[j])));
      block.way = *way;
    }
    if (blocks_.size() == 1 || change < S(1e-9)) break;
  }
  for (Block& block : blocks_)
    if (!(product_of(block.way, acceleration(block, block.way)) >= -S(1e-6) * size))
      return why = fmt::format("{} would turn back", block.frictions), std::nullopt;
  speed_ = std::max(S(1e-12), S(64 * gauss::Math<S>::epsilon())) * speed;
  return sliding();
}

template class SlipStart<float>;
template class SlipStart<double>;
template class SlipStart<long double>;
template class SlipStart<Quad>;

}  // namespace gausssim
