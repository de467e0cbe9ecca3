#include "usual_places.hpp"

#include "nearest_position.hpp"
#include "spans.hpp"

namespace gaussgen {

namespace {

constexpr double k_first_displacement = 0.3;  ///< of a span
constexpr double k_least_displacement = 1e-3;
constexpr double k_rounding = 1e-14;  ///< of what an equation is made of

}  // namespace

UsualPlaces::UsualPlaces(Mechanics& mechanics, double time, RepeatedNumbers& numbers)
    : equations_(mechanics, std::vector<bool>(mechanics.dynamics.n(), true), time), numbers_(numbers) {
  const Approach begin = long_approach(mechanics, equations_.movable(), time);
  if (!equations_.start()) return;
  if (begin.is_solved) equations_.set(begin.position);
  begin_ = equations_.position();
  spans_ = spans_at(mechanics, equations_);
}

bool UsualPlaces::next() {
  for (double part = k_first_displacement; !begin_.empty() && part > k_least_displacement; part /= 4) {
    equations_.set(begin_);
    equations_.move(displacement(part));
    if (!nearest_solution(equations_, spans_)) continue;
    polish(equations_, spans_);
    return true;
  }
  return false;
}

double UsualPlaces::rounding() {
  const auto here = equations_.linearised();
  return here ? k_rounding * here->amplification(spans_) : k_rounding;
}

std::vector<double> UsualPlaces::displacement(double part) {
  std::vector<double> result;
  for (const double span : spans_) result.push_back(part * span * numbers_());
  return result;
}

}  // namespace gaussgen
