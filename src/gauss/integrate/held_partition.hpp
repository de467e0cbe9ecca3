// A model whose dependent speeds are expressed by the others, and a stepper that holds the choice and switches it between steps.
// SPDX-License-Identifier: MIT
//
// For models whose header has `linear_system` and `rhs_of_solution`; the others have a way of their own that divides by nothing which may vanish.
#ifndef GAUSS_INTEGRATE_HELD_PARTITION_HPP
#define GAUSS_INTEGRATE_HELD_PARTITION_HPP

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "gauss/integrate/bound_model.hpp"
#include "gauss/integrate/elimination.hpp"
#include "gauss/integrate/model_decorator.hpp"
#include "gauss/integrate/step_result.hpp"

namespace gauss::integrate {

namespace detail {

// Outside of classes whose members would hide them; found through the namespace of State.
template <class Scalar, class State, class Inputs, class Prepared, class System>
Status fill_system(const Scalar& t, const State& state, const Inputs& inputs, const Prepared& prepared,
                   System& system) {
  return linear_system(t, state, inputs, prepared, system);
}

template <class Scalar, class State, class Inputs, class Prepared, class Solution, class Derivative>
Status rates_of(const Scalar& t, const State& state, const Inputs& inputs, const Prepared& prepared,
                const Solution& solution, Derivative& derivative) {
  return rhs_of_solution(t, state, inputs, prepared, solution, derivative);
}

}  // namespace detail

/// The model `Base` (a BoundModel, which outlives it) with accelerations from an elimination. `System` is the emitted struct,
/// such as gauss::pendulum::LinearSystem<double>.
template <class Base, class System>
class PartitionedModel : public ModelDecorator<PartitionedModel<Base, System>, Base> {
  using Decorator = ModelDecorator<PartitionedModel<Base, System>, Base>;

 public:
  using typename Decorator::Derivative;
  using typename Decorator::Scalar;
  using typename Decorator::State;
  using typename Decorator::Status;
  static_assert(std::is_same_v<Status, gauss::Status>, "lanes of a batch may ask for different partitions");
  static constexpr int n = static_cast<int>(std::extent_v<decltype(System::b), 1>);
  static constexpr int l = static_cast<int>(std::extent_v<decltype(System::b), 0>);
  using Choice = Partition<n, l>;
  using Solution = LinearSolution<Scalar, n, l>;

  /// The best partition at every call. `rule` is that of the model: rank_on_positions<S>(r), or rank_of_velocities<S>(r) of
  /// one without equations of positions, where r is the usual rank, as `mobility` tells.
  PartitionedModel(const Base& base, const RankRule<Scalar>& rule) : base_(&base), rule_(rule) {}
  /// This partition at every call.
  PartitionedModel(const Base& base, const RankRule<Scalar>& rule, const Choice& held)
      : base_(&base), rule_(rule), held_(held), is_held_(true) {}

  Status derivative(const Scalar& t, const State& state, Derivative& result) const {
    Solution solution;
    const Status solved = solve(t, state, solution);
    return Math<Scalar>::worse(solved,
                               detail::rates_of(t, state, this->inputs(t, state), this->prepared(), solution, result));
  }

  /// Accelerations and multipliers. Where the partition does not carry the state, they and the status are those of `gauss::solve`.
  Status solve(const Scalar& t, const State& state, Solution& solution) const {
    System system;
    const Status filled = linear_system(t, state, system);
    const Elimination<Scalar, n, l> elimination(system, rule_);
    if (!elimination.solve(is_held_ ? held_ : elimination.best(), solution)) {
      gauss::solve(system, rule_, solution);
      ++handed_over_;
    }
    return Math<Scalar>::worse(filled, solution.motion);
  }

  Status linear_system(const Scalar& t, const State& state, System& system) const {
    return detail::fill_system(t, state, this->inputs(t, state), this->prepared(), system);
  }

  /// Calls so far that the partition did not carry.
  long handed_over() const { return handed_over_; }

  const Base& base() const { return *base_; }

 private:
  const Base* base_;
  RankRule<Scalar> rule_;
  Choice held_;
  bool is_held_ = false;
  mutable long handed_over_ = 0;
};

/// What holding a partition came to since the beginning of a run.
template <class Scalar>
struct PartitionReport {
  struct Switch {
    long step = 0;    ///< taken before it
    Scalar time = 0;  ///< at which it happened
  };
  static constexpr int k_shown = 16;

  long switches = 0;  ///< without the first choice
  long handed_over =
      0;  ///< evaluations that the partition did not carry, as where constraints become dependent within a step
  std::array<Switch, k_shown> latest{};  ///< number k since the beginning, counted from 0, is at k % k_shown

  /// The k-th switch, counted from 0, while fewer than k_shown came after it.
  const Switch& at(long k) const { return latest[static_cast<std::size_t>(k % k_shown)]; }
};

/// Steps by `Inner`, a stepper of PartitionedModel<Model, System>, with one partition within each step. Before a step the best
/// one there takes its place if the condition of the held one is more than `ratio` times as large, or the rank is another: so it
/// does not go to and fro where two are about equal.
template <class Inner, class System>
class Held {
 public:
  using Scalar = typename Inner::Scalar;
  using State = typename Inner::State;
  static constexpr int n = static_cast<int>(std::extent_v<decltype(System::b), 1>);
  static constexpr int l = static_cast<int>(std::extent_v<decltype(System::b), 0>);
  using Choice = Partition<n, l>;

  static constexpr double k_ratio = 2;

  /// `rule` as of PartitionedModel. `ratio` 1 takes the best before each step.
  explicit Held(const RankRule<Scalar>& rule, Inner inner = Inner(), const Scalar& ratio = Scalar(k_ratio))
      : rule_(rule), inner_(std::move(inner)), ratio_(ratio) {}

  template <class Model>
  StepResult step(const Model& model, const Scalar& t, const Scalar& h, State& state) {
    const StepResult chosen = choose(model, t, state);
    if (!chosen.is_taken()) return chosen;
    const PartitionedModel<Model, System> partitioned(model, rule_, held_);
    const StepResult result = inner_.step(partitioned, t, h, state);
    report_.handed_over += partitioned.handed_over();
    if (result.is_taken()) ++steps_;
    return result;
  }

  const PartitionReport<Scalar>& report() const { return report_; }
  const Choice& partition() const { return held_; }
  const Inner& inner() const { return inner_; }

 private:
  template <class Model>
  StepResult choose(const Model& model, const Scalar& t, const State& state) {
    System system;
    const PartitionedModel<Model, System> at(model, rule_);
    const StepResult filled = result_of(at.linear_system(t, state, system));
    if (!filled.is_taken()) return filled;
    const Elimination<Scalar, n, l> elimination(system, rule_);
    const Choice best = elimination.best();
    if (!has_choice_) {
      held_ = best;
      has_choice_ = true;
    } else if (best != held_ && is_better(elimination, best)) {
      held_ = best;
      report_.latest[static_cast<std::size_t>(report_.switches % report_.k_shown)] = {steps_, t};
      ++report_.switches;
    }
    return filled;
  }

  bool is_better(const Elimination<Scalar, n, l>& elimination, const Choice& best) const {
    return best.rank != held_.rank || elimination.condition(held_) > ratio_ * elimination.condition(best);
  }

  RankRule<Scalar> rule_;
  Inner inner_;
  Scalar ratio_;
  Choice held_;
  bool has_choice_ = false;
  long steps_ = 0;
  PartitionReport<Scalar> report_;
};

}  // namespace gauss::integrate

#endif  // GAUSS_INTEGRATE_HELD_PARTITION_HPP
