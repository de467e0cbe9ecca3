#include "spans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "position_equations.hpp"

namespace gaussgen {

namespace {

using Vector = std::vector<double>;

constexpr double k_changed = 0.5;     ///< of a gradient
constexpr double k_factor = 4;        ///< from one span that is tried to the next
constexpr double k_least = 1e-8;      ///< of a coordinate: half of its digits
constexpr double k_solved = 1e-10;    ///< of what an equation is made of
constexpr double k_turned = 10;       ///< times the root of what is left, as in gauss/rank_rule.hpp
constexpr double k_rounding = 1e-28;  ///< of the square of a gradient
constexpr double k_far = 1e12;        ///< where nothing has changed there, nothing does

class Spans {
 public:
  Spans(const Mechanics& mechanics, PositionEquations& equations)
      : mechanics_(mechanics),
        equations_(equations),
        from_(equations.position()),
        all_(mechanics.dynamics.n(), true),
        speeds_(equations.speeds()),
        here_(equations.of_speeds(speeds_, all_)),
        inertias_(equations.inertias()) {
    if (here_) find_rounding();
  }

  /// Of all speeds. One that changes no gradient may have any size: as much as what else is in its equations asks for, so that a coordinate of 1e-17 is not
  /// measured by itself.
  Vector all() const {
    Vector result;
    for (std::size_t i = 0; i < all_.size(); ++i) result.push_back(along(i));
    if (!here_) return result;
    const Vector found = result;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (is_angle(i) || change(i, k_far * found[i]) > k_changed) continue;
      result[i] = std::max(found[i], asked_for(i, found));
      while (result[i] > found[i] && change(i, result[i]) > k_changed) result[i] /= k_factor;
    }
    return result;
  }

 private:
  /// What is left of the equations turns a gradient by its root where they are double roots. One that is no larger here than a radian makes of that has no size: a bar in
  /// line with others has such a row.
  void find_rounding() {
    rounding_.assign(here_->j.size(), 0);
    const auto places = equations_.linearised();
    if (!places || places->left() > k_solved) return;
    const double off = k_turned * std::sqrt(places->left());
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const auto there = is_angle(i) ? beside(i, 1) : std::nullopt;
      for (std::size_t mu = 0; there && mu < rounding_.size(); ++mu)
        rounding_[mu] = std::max(rounding_[mu], off * off * square_of_change(mu, *there));
    }
  }

  /// Gradients a displacement on.
  std::optional<Linearised> beside(std::size_t i, double span) const {
    Vector along(all_.size(), 0);
    along[i] = span;
    equations_.set(from_);
    equations_.move(along);
    auto there = equations_.of_speeds(speeds_, all_);
    equations_.set(from_);
    return there;
  }

  double weight(std::size_t k) const { return inertias_[k] > 0 ? 1 / inertias_[k] : 1; }

  double square_of(const Vector& row) const {
    double sum = 0;
    for (std::size_t k = 0; k < all_.size(); ++k) sum += weight(k) * row[k] * row[k];
    return sum;
  }

  double square_of_change(std::size_t mu, const Linearised& there) const {
    double sum = 0;
    for (std::size_t k = 0; k < all_.size(); ++k) sum += weight(k) * std::pow(there.j[mu][k] - here_->j[mu][k], 2);
    return sum;
  }

  double asked_for(std::size_t i, const Vector& spans) const {
    double largest = 0;
    for (const Vector& row : here_->j) {
      // Where something stands at 0 but for rounding, so does the sine of it.
      if (weight(i) * row[i] * row[i] <= k_rounding * square_of(row)) continue;
      for (std::size_t k = 0; k < spans.size(); ++k)
        largest = std::max(largest, std::abs(row[k]) * spans[k] / std::abs(row[i]));
    }
    return largest;
  }

  double along(std::size_t i) const {
    const double first = first_span(i), least = k_least * (i < from_.size() ? std::abs(from_[i]) : 0);
    if (!here_) return first;
    double span = first;
    while (span > least && change(i, span) > k_changed) span /= k_factor;
    if (span < first || is_angle(i) || change(i, k_far * first) <= k_changed) return span;
    while (change(i, k_factor * span) <= k_changed) span *= k_factor;
    return span;
  }

  bool is_angle(std::size_t i) const { return mechanics_.symbols.speeds[kinematics::FreeIndex{i}].unit == "rad/s"; }

  double first_span(std::size_t i) const {
    const bool is_plain = i < mechanics_.symbols.plain_count();
    return !is_angle(i) && is_plain && from_[i] != 0 ? std::abs(from_[i]) : 1;
  }

  /// The largest of a gradient beside what it is here. One that vanishes here has no size.
  double change(std::size_t i, double span) const {
    const auto there = beside(i, span);
    if (!there) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t mu = 0; mu < here_->j.size(); ++mu) {
      const double before = square_of(here_->j[mu]);
      if (before > rounding_[mu]) largest = std::max(largest, std::sqrt(square_of_change(mu, *there) / before));
    }
    return largest;
  }

  const Mechanics& mechanics_;
  PositionEquations& equations_;
  Vector from_;
  std::vector<bool> all_;
  Vector speeds_;
  std::optional<Linearised> here_;
  Vector inertias_;
  Vector rounding_;  ///< squares of gradients that have no size
};

}  // namespace

std::vector<double> spans_at(const Mechanics& mechanics, PositionEquations& equations) {
  return Spans(mechanics, equations).all();
}

}  // namespace gaussgen
