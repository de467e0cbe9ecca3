#include "sim/ensemble/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "sim/ensemble/philox.hpp"
#include "support/content_hash.hpp"

namespace gausssim {

namespace {

std::uint64_t word_of(const Varied& one) {
  const std::string name = std::string(name_of(one.section)) + "." + one.name;
  return std::stoull(gaussgen::support::content_hash(name), nullptr, 16);
}

std::uint32_t low(std::uint64_t word) { return static_cast<std::uint32_t>(word); }
std::uint32_t high(std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); }

/// Multiples of 2^-53 below 1.
double fraction(std::uint32_t upper, std::uint32_t lower) {
  const std::uint64_t bits = (static_cast<std::uint64_t>(upper) << 32 | lower) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace

double drawn(const Distribution& distribution, double first, double second) {
  const double a = distribution.a, b = distribution.b;
  // Rounding may reach an end, and no more than that.
  if (distribution.kind == Distribution::Kind::uniform) return std::min(a + (b - a) * first, b);
  if (distribution.kind == Distribution::Kind::log_uniform)
    return std::clamp(a * std::exp((std::log(b) - std::log(a)) * first), a, b);
  // Box and Muller: one of the two normal numbers.
  const double pi = std::acos(-1.0);
  return a + b * std::sqrt(-2 * std::log1p(-first)) * std::cos(2 * pi * second);
}

double nominal(const Distribution& distribution) {
  const auto& points = distribution.points;
  if (!points.empty()) return points[points.size() / 2];
  if (distribution.kind == Distribution::Kind::normal) return distribution.a;
  return drawn(distribution, 0.5, 0);
}

Plan::Plan(const Ensemble& ensemble) : varied_(ensemble.varied), seed_(ensemble.seed) {
  stride_.assign(varied_.size(), 1);
  for (std::size_t i = varied_.size(); i-- > 0;) {
    if (varied_[i].distribution.is_random()) continue;
    stride_[i] = count_;
    count_ *= static_cast<long>(varied_[i].distribution.points.size());
  }
  count_ *= ensemble.trajectories;
  for (const Varied& one : varied_) words_.push_back(word_of(one));
}

std::vector<double> Plan::values(long trajectory) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < varied_.size(); ++i) all.push_back(value(i, trajectory));
  return all;
}

double Plan::value(std::size_t which, long trajectory) const {
  const Distribution& distribution = varied_[which].distribution;
  if (!distribution.is_random()) {
    const auto& points = distribution.points;
    return points[static_cast<std::size_t>(trajectory / stride_[which]) % points.size()];
  }
  const auto number = static_cast<std::uint64_t>(trajectory);
  const std::uint64_t word = words_[which];
  const auto bits = philox({low(number), high(number), low(word), high(word)}, {low(seed_), high(seed_)});
  return drawn(distribution, fraction(bits[0], bits[1]), fraction(bits[2], bits[3]));
}

}  // namespace gausssim
