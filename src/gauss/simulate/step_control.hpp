// What an error of a step is measured by: sizes that the motion itself has, and rounding. No unit is preferred.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_STEP_CONTROL_HPP
#define GAUSS_SIMULATE_STEP_CONTROL_HPP

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include "gauss/integrate/odeint.hpp"
#include "gauss/integrate/unit_groups.hpp"

namespace gauss::simulate {

/// A model as a system of Odeint that notes how large the states are at which a step looks. What starts from 0 has no size but this.
///
/// The states within a step miss the constraints by errors of low order. Near a change point of a linkage, rates there have nothing to do with the motion. `close`
/// makes it the system of the rates at the nearest states that satisfy the constraints: the same motion on the constraints, so steps keep their order.
template <class Model>
class NotingSystem {
 public:
  using Scalar = typename Model::Scalar;
  using Array = typename integrate::OdeintSystem<Model>::Array;

  explicit NotingSystem(const Model& model) : model_(model), system_(model_), sizes_(Arrays::zeros(model)) {}

  void operator()(const Array& x, Array& dxdt, const Scalar& t) {
    note(x.data(), sizes_.data(), x.size());
    if (is_closed_) return at_closed(x, dxdt, t);
    system_(x, dxdt, t);
  }

  /// For implicit methods.
  template <class Fill>
  bool jacobian(const Scalar& t, const Array& x, const Fill& fill) {
    return system_.jacobian(t, x, fill);
  }
  /// What the error of a step may be, as far as is known of the sizes within it.
  const Array& allowed(const Scalar& dt) const { return allowed_(dt); }
  void set_allowed(std::function<const Array&(const Scalar&)> allowed) { allowed_ = std::move(allowed); }

  void close(bool is_closed) { is_closed_ = is_closed; }
  bool is_closed() const { return is_closed_; }

  auto trouble() const { return system_.trouble(); }
  void forget() {
    system_.forget_trouble();
    std::fill(sizes_.begin(), sizes_.end(), Scalar(0));
  }
  /// Largest of each component since forget().
  const Array& sizes() const { return sizes_; }
  long calls() const { return system_.calls(); }
  long jacobians() const { return system_.jacobians(); }

 private:
  using Arrays = integrate::StateArrays<Model>;

  static void note(const Scalar* x, Scalar* sizes, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) sizes[i] = std::max(sizes[i], integrate::magnitude(x[i]));
  }

  /// Apart, since hardly any step looks here.
  [[gnu::noinline]] void at_closed(const Array& x, Array& dxdt, const Scalar& t) { system_(closed(x, t), dxdt, t); }

  /// As it is where it cannot be closed: rates say what there is to say.
  Array closed(const Array& x, const Scalar& t) const {
    typename Model::State state = Arrays::state_of(x);
    if (!integrate::is_motion_known(model_.projection(t, state))) return x;
    return Arrays::array_of(state);
  }

  const Model& model_;
  integrate::OdeintSystem<Model> system_;
  Array sizes_;
  std::function<const Array&(const Scalar&)> allowed_;
  bool is_closed_ = false;
};

/// Parts of 1, of either sign, no two alike: what constraints tie together is not taken back by them as if they held it (Weyl's sequences).
template <class Scalar>
Scalar unlike_part(std::size_t i, int pattern) {
  const double turn = static_cast<double>(i + 1) * (pattern == 0 ? 0.6180339887498949 : 0.4142135623730951);
  const double part = 2 * (turn - std::floor(turn)) - 1;
  return Scalar(part < 0 ? part - 0.5 : part + 0.5) / Scalar(1.5);
}

/// The error of a step in units of what is allowed: the largest over the components. Each is allowed the tolerance of the largest size that it had so far or has within
/// the step; some units in the last place of the largest component that has the same unit (of 1, for angles), or of what constraints make of it where all others move, since what
/// is smaller is rounding of that; and what rounding changes its rate by.
///
/// Odeint's own checker adds one absolute tolerance for all components, which suits neither a speed of 100 rad/s nor a quaternion nor other units, and its maximum loses a NaN.
template <class Model>
class StepControl {
 public:
  using Scalar = typename Model::Scalar;
  using Array = typename NotingSystem<Model>::Array;

  StepControl(const Model& model, const Scalar& tolerance, const NotingSystem<Model>& system)
      : tolerance_(tolerance),
        groups_(model),
        system_(&system),
        own_(Arrays::zeros(model)),
        rounding_(own_),
        least_rounding_(own_),
        by_constraints_(own_),
        sizes_(own_),
        allowed_(own_),
        is_held_(Arrays::template filled<bool>(model, false)) {}

  /// Sizes are those of `x` at least from now on.
  void grow(const Array& x) {
    for (std::size_t i = 0; i < x.size(); ++i) own_[i] = std::max(own_[i], integrate::magnitude(x[i]));
  }
  void set_smallest(std::size_t i, const Scalar& size) { own_[i] = size; }
  void set_rounding(const Array& of_rates) {
    for (std::size_t i = 0; i < of_rates.size(); ++i) rounding_[i] = std::max(of_rates[i], least_rounding_[i]);
  }
  void set_least_rounding(const Array& of_rates) { rounding_ = least_rounding_ = of_rates; }
  /// What constraints make of components where all of them move. A body that a blade guides straight does not turn: rounding of its speed, divided by an arm, is what it seems to turn by. And what they
  /// bring back to where it was, as the angle of a slab on parallel bars, is theirs: errors of a step in it are of no other size than those of all that moves.
  /// `project(state, result)` is false where it does not arrive.
  template <class Project>
  void find_by_constraints(const Array& x, const Project& project) {
    Array here = x, sizes = x, smallest = x, held = integrate::zeros_like(x);
    if (!project(x, here)) return;
    for (std::size_t i = 0; i < own_.size(); ++i) sizes[i] = integrate::magnitude(here[i]);
    const Array moves = groups_.moves(sizes, reach_);
    std::fill(smallest.begin(), smallest.end(), std::numeric_limits<Scalar>::infinity());
    bool holds = false;
    for (const int pattern : {0, 1}) {
      Array changes = x;
      std::fill(changes.begin(), changes.end(), std::numeric_limits<Scalar>::infinity());
      for (const int sign : {1, -1}) {
        Array moved = here, back = here;
        for (std::size_t i = 0; i < own_.size(); ++i)
          moved[i] += Scalar(sign) * k_part * moves[i] * unlike_part<Scalar>(i, pattern);
        if (!project(moved, back)) return;
        holds = holds || back != moved;
        for (std::size_t i = 0; i < own_.size(); ++i)
          changes[i] = std::min(changes[i], integrate::magnitude(back[i] - here[i]));
      }
      for (std::size_t i = 0; i < own_.size(); ++i) {
        smallest[i] = std::min(smallest[i], changes[i]);
        held[i] = std::max(held[i], changes[i]);
      }
    }
    if (!holds) return;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      is_held_[i] = held[i] < k_held * k_part * moves[i];
      by_constraints_[i] = is_held_[i] ? moves[i] : smallest[i] / k_part;
    }
  }

  Scalar size(std::size_t i) const { return std::max(own_[i], system_->sizes()[i]); }
  /// That of its own, unless it is nothing beside what constraints make of it. (Near a change point they make much of what is not nothing.)
  Scalar usual_size(std::size_t i) const { return is_held_[i] || is_nothing(i) ? by_constraints_[i] : size(i); }

  /// By components: what an error may be. Until the next call.
  const Array& allowed(const Scalar& tolerance, const Scalar& dt) const {
    // Below it, numbers have not all of their digits.
    constexpr Scalar least = std::numeric_limits<Scalar>::min() / std::numeric_limits<Scalar>::epsilon();
    const std::size_t n = own_.size();
    Scalar* const sizes = sizes_.data();
    Scalar* const result = allowed_.data();
    const Scalar *const own = own_.data(), *const now = system_->sizes().data(), *const rounding = rounding_.data();
    const Scalar* const by_constraints = by_constraints_.data();
    const bool* const is_held = is_held_.data();
    for (std::size_t i = 0; i < n; ++i) sizes[i] = std::max(own[i], now[i]);
    groups_.find_largest(sizes, result);
    const Scalar length = integrate::magnitude(dt);
    for (std::size_t i = 0; i < n; ++i) {
      const Scalar places = is_held[i] ? Scalar(0) : k_last_places * result[i];
      result[i] = least + tolerance * sizes[i] + places + length * rounding[i];
      if (is_held[i] || sizes[i] <= k_last_places * by_constraints[i])
        result[i] += (is_held[i] ? std::max(tolerance, k_last_places) : k_last_places) * by_constraints[i];
    }
    return allowed_;
  }

  /// As ErrorBy asks for it.
  Scalar error(const Array& errors, const Scalar& dt) {
    const Scalar found = last_ = largest(errors, dt);
    const Scalar length = integrate::magnitude(dt);
    if (found > Scalar(1) && !is_edge(found, length)) return found;
    accepted(dt);
    if (found > Scalar(1)) before_edge_ = edge_.dt;
    if (!is_resting_ || found > Scalar(1)) edge_ = Edge{};
    return std::min(found, Scalar(1));
  }

  /// Of a step that was taken over an edge, once: the longest one that was refused before it, which motion behind the edge may bear. What has moved by now is too little for short steps: it is
  /// rounding of times for the most part. 0: there was none.
  Scalar take_step_before_edge() {
    const Scalar step = before_edge_;
    before_edge_ = 0;
    return step;
  }

  /// Of the step that was looked at last, as it was.
  const Scalar& last_error() const { return last_; }

  /// The first step that is tried, as long as none was accepted.
  void set_reach(const Scalar& dt) { reach_ = dt; }
  const Scalar& reach() const { return reach_; }

 private:
  using Arrays = integrate::StateArrays<Model>;

  bool is_nothing(std::size_t i) const { return size(i) <= k_last_places * by_constraints_[i]; }

  // No rounding; near a change point, where changes are roots, a smaller one would seem to move all by more.
  static constexpr Scalar k_part = Scalar(1) / 128;
  static constexpr Scalar k_held = Scalar(1e-6);  ///< of a move

  static constexpr Scalar k_last_places = 64 * std::numeric_limits<Scalar>::epsilon();

  // Where what rests is pushed at a point of time (a force that begins to act), the error of a step over it is a part of all that moves, however short the step
  // is. It shows by errors that stay much the same from one refused step to a far shorter one, where those of smooth motions go with its fifth power and more. What
  // happens in this part of the longest step so far is not asked for then.
  static constexpr double k_brief = 1e-10;
  static constexpr double k_far_shorter = 1e-2;

  /// The longest step that was refused since something has moved.
  struct Edge {
    Scalar error = 0, dt = 0;
  };

  bool is_edge(const Scalar& error, const Scalar& dt) {
    if (!(error < std::numeric_limits<Scalar>::max())) return edge_ = Edge{}, false;
    // More than all that moves is that.
    const Scalar part = std::min(error, 1 / tolerance_);
    if (dt >= edge_.dt) edge_ = Edge{part, dt};
    return dt <= k_brief * reach_ && dt < k_far_shorter * edge_.dt && part * edge_.dt > edge_.error * dt;
  }

  Scalar largest(const Array& errors, const Scalar& dt) {
    const Array& bounds = allowed(tolerance_, dt);
    Scalar result = 0;
    is_resting_ = true;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (errors[i] == Scalar(0)) continue;
      const Scalar relative = integrate::magnitude(errors[i]) / bounds[i];
      if (!(relative <= std::numeric_limits<Scalar>::max())) return std::numeric_limits<Scalar>::max();
      if (relative > Scalar(0.01) && tolerance_ * size(i) > bounds[i] / 2) is_resting_ = false;
      result = std::max(result, relative);
    }
    return result;
  }

  void accepted(const Scalar& dt) { reach_ = std::max(reach_, integrate::magnitude(dt)); }

  Scalar tolerance_;
  integrate::UnitGroups<Model> groups_;
  const NotingSystem<Model>* system_;
  Array own_;       ///< largest size so far
  Array rounding_;  ///< changes of rates by it
  Array least_rounding_;
  Array by_constraints_;
  mutable Array sizes_, allowed_;  ///< of `allowed`
  typename Arrays::template Of<bool> is_held_;
  Scalar reach_ = 0;  ///< the longest step so far
  Scalar last_ = 0;   ///< error
  Edge edge_;
  Scalar before_edge_ = 0;  ///< step
  bool is_resting_ = true;  ///< no error beyond rounding in the step that was looked at last
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_STEP_CONTROL_HPP
