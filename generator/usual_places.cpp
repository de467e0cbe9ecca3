#include "usual_places.hpp"

#include <algorithm>
#include <cmath>

#include "nearest_position.hpp"
#include "spans.hpp"

namespace gaussgen {

namespace {

constexpr double k_first_displacement = 0.3;  ///< of a span
constexpr double k_least_displacement = 1e-3;
constexpr double k_rounding = 1e-14;  ///< of what an equation is made of
constexpr double k_polished = 4e-16;  ///< likewise: what polishing leaves where roots are single
constexpr double k_far = 1000;        ///< times the root of what is left
constexpr double k_near = 1e-4;       ///< of a span: no place of its own, as exact as double roots are
constexpr double k_turned = 10;       ///< times the root of what is left, as in gauss/rank_rule.hpp

}  // namespace

UsualPlaces::UsualPlaces(Mechanics& mechanics, double time, RepeatedNumbers& numbers)
    : equations_(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), time), numbers_(numbers) {
  const Approach begin = long_approach(mechanics, equations_.movable(), time);
  if (!equations_.start()) return;
  is_solution_ = begin.is_solved;
  if (begin.is_solved) equations_.set(begin.position);
  begin_ = equations_.position();
  spans_ = spans_at(mechanics, equations_);
  reaches_ = reaches();
}

bool UsualPlaces::next(double solved) {
  for (double part = k_first_displacement; !begin_.empty() && part > k_least_displacement; part /= 4) {
    equations_.set(begin_);
    equations_.move(displacement(part));
    if (!nearest_solution(equations_, spans_, solved, true)) continue;
    polish(equations_, spans_, true);
    (is_beyond(k_near) ? went_on_ : came_back_) = true;
    if (is_elsewhere()) return true;
  }
  return false;
}

void UsualPlaces::go_beside() {
  go_back();
  equations_.move(displacement(k_first_displacement));
}

// What is good to half of its digits is where the search began, unless it went on by much more.
bool UsualPlaces::is_elsewhere() {
  auto here = equations_.linearised();
  if (!here) return false;
  here->measure_by(spans_);
  return here->left() <= k_polished || is_beyond(k_far * std::sqrt(here->left()));
}

bool UsualPlaces::is_beyond(double part) const {
  const std::vector<double>& position = equations_.position();
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (reaches_[i] > 0 && std::abs(position[i] - begin_[i]) > part * reaches_[i]) return true;
  }
  return false;
}

/// A quaternion has a component more than angular velocities, and speeds may stand for several rates.
std::vector<double> UsualPlaces::reaches() {
  std::vector<double> result(begin_.size(), 0);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    std::vector<double> along(spans_.size(), 0);
    along[i] = spans_[i];
    go_back();
    equations_.move(along);
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = std::max(result[k], std::abs(equations_.position()[k] - begin_[k]));
  }
  go_back();
  return result;
}

double UsualPlaces::rounding() {
  auto here = equations_.linearised();
  if (!here) return k_rounding;
  const double turned = k_rounding * here->amplification(spans_);
  here->measure_by(spans_);
  return here->left() > k_polished ? std::max(turned, k_turned * std::sqrt(here->left())) : turned;
}

std::vector<double> UsualPlaces::displacement(double part) {
  std::vector<double> result;
  for (const double span : spans_) result.push_back(part * span * numbers_());
  return result;
}

}  // namespace gaussgen
