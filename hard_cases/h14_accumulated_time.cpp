// Time as a sum of steps, and as their number times their length.

#include <cmath>

#include "gauss/integrate/time_grid.hpp"
#include "registry.hpp"

namespace hard_cases {

namespace {

constexpr std::int64_t k_steps = 100'000'000;

/// In units in the last place of the exact k h.
template <class Scalar>
double ulps(Scalar t, std::int64_t k, Scalar h) {
  const long double exact = static_cast<long double>(k) * static_cast<long double>(h);
  const Scalar rounded = static_cast<Scalar>(exact);
  const Scalar ulp = std::nextafter(rounded, std::numeric_limits<Scalar>::max()) - rounded;
  return static_cast<double>(std::abs(static_cast<long double>(t) - exact) / static_cast<long double>(ulp));
}

template <class Scalar>
Figure figure(const char* id, const char* quantity) {
  const Scalar h = Scalar(0.01);
  Figure result{id, quantity, "ulp", {}};
  result.bar = 1;
  Stopwatch naive;
  Scalar sum = 0;
  for (std::int64_t k = 0; k < k_steps; ++k) sum += h;
  result.naive = ulps(sum, k_steps, h);
  result.seconds_naive = naive.seconds();
  Stopwatch ours;
  result.ours = 0;
  const gauss::integrate::TimeGrid<Scalar> grid(0, h);
  for (std::int64_t k = 0; k <= k_steps; k += 1 + k / 100'000)
    result.ours = std::max(result.ours, ulps(grid.at(k), k, h));
  result.ours = std::max(result.ours, ulps(grid.at(k_steps), k_steps, h));
  result.seconds_ours = ours.seconds();
  return result;
}

}  // namespace

std::vector<Figure> accumulated_time(const Scope&) {
  return {figure<double>("H14.double", "time after 1e8 steps of 0.01 s"),
          figure<float>("H14.float", "time after 1e8 steps of 0.01 s, in float")};
}

}  // namespace hard_cases
