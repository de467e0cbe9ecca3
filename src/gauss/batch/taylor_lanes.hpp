// As many trajectories as a register has lanes, by power series: each with a time and a step of its own.
// SPDX-License-Identifier: MIT
//
// What a lane does depends on no other one, to the last bit where angles are below a million: a lane that has arrived, or whose status is not ok, stays where it is.
#ifndef GAUSS_BATCH_TAYLOR_LANES_HPP
#define GAUSS_BATCH_TAYLOR_LANES_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "gauss/batch/rough_powers.hpp"
#include "gauss/integrate/taylor.hpp"
#include "gauss/integrate/unit_groups.hpp"
#include "gauss/scalar/xsimd.hpp"
#include "gauss/simulate/report.hpp"
#include "gauss/simulate/rounding.hpp"

namespace gauss::batch {

/// `Model` is a BoundModel over a batch, `Series` the emitted TaylorSeries of that batch. Inputs are those at the beginning of each step.
template <class Model, class Series>
class TaylorLanes {
 public:
  using Batch = typename Model::Scalar;
  using Number = typename Batch::value_type;
  using Mask = typename Batch::batch_bool_type;
  using State = typename Model::State;
  using Status = typename Model::Status;
  static constexpr std::size_t lanes = Batch::size;

  TaylorLanes(const Model& model, const State& start, const Batch& start_time = Batch(Number(0)),
              const simulate::Settings<Number>& settings = {}, int order = 0)
      : model_(model), settings_(settings), state_(start), t_(start_time) {
    order_ = order > 0 ? order : integrate::taylor_order(static_cast<double>(settings_.tolerance), Series::most);
    if (order_ < 4) order_ = 4;
    if (settings_.project) project(Mask(true));
    grow();
  }

  /// All lanes to `end`; false where some do not arrive: `lost()` tells which.
  bool advance_to(const Number& end) {
    const Batch goal(end);
    if (!settings_.are_usable()) return false;
    for (long steps = 0; !xsimd::all(are_done(end)); ++steps) {
      if (steps >= settings_.most_steps) return false;
      step(goal);
    }
    return xsimd::none(lost_);
  }

  /// For callers that look at the motion within steps, or give other trajectories to lanes that are done: one step of all that have a way to go.
  void step_towards(const Number& end) { step(Batch(end)); }
  /// Lanes that are at the end, where the model has been asked whether the last step holds, or have stopped.
  Mask are_done(const Number& end) const { return lost_ || (t_ >= Batch(end) && !(span_ > Batch(Number(0)))); }
  /// Lanes of `where` begin anew, with what `model` has of them; its other lanes are those that there are. Nothing changes in others.
  void begin(const Mask& where, const Model& model, const State& start, const Batch& start_time) {
    const Batch none(Number(0));
    model_ = model;
    for (std::size_t i = 0; i < Model::size; ++i) {
      state_.values[i] = xsimd::select(where, start.values[i], state_.values[i]);
      sizes_[i] = xsimd::select(where, none, sizes_[i]);
      largest_rates_[i] = xsimd::select(where, none, largest_rates_[i]);
      noise_[i] = xsimd::select(where, none, noise_[i]);
    }
    t_ = xsimd::select(where, start_time, t_);
    span_ = xsimd::select(where, none, span_);
    reach_ = xsimd::select(where, none, reach_);
    refused_ = xsimd::select(where, none, refused_);
    refusals_ = xsimd::select(where, none, refusals_);
    taken_ = xsimd::select(where, none, taken_);
    most_ = xsimd::select(where, Batch(std::numeric_limits<Number>::infinity()), most_);
    lost_ = lost_ && !where;
    status_ = status_.within(!where);
    if (settings_.project) project(where);
    grow();
  }
  /// Lanes of `where` stay where they are.
  void stop(const Mask& where) { lost_ = lost_ || where; }
  /// Of the last step, from where each lane was then. A lane may be back there after the next one, which found that it did not hold.
  const Series& series() const { return series_; }
  const Batch& begin_of_step() const { return t_before_; }
  /// Steps that each lane has taken, without those that it took back.
  const Batch& steps_of_lanes() const { return taken_; }

  const State& states() const { return state_; }
  const Batch& times() const { return t_; }
  /// Lanes that have stopped: their status is not ok, or no step is short enough.
  const Mask& lost() const { return lost_; }
  const Status& status() const { return status_; }
  long steps() const { return steps_; }

 private:
  using Values = std::array<Batch, Model::size>;

  static Batch size_of(const Batch& x) { return xsimd::abs(x); }

  void project(const Mask& where) {
    State moved = state_;
    const Status status = model_.projection(t_, moved);
    status_ = Math<Batch>::worse(status_, status.within(where));
    lost_ = lost_ || (where && stops(status));
    for (std::size_t i = 0; i < Model::size; ++i)
      state_.values[i] = xsimd::select(where && !stops(status), moved.values[i], state_.values[i]);
  }

  /// Where constraints depend on each other the motion is known all the same, but has no series.
  static Mask stops(const Status& status) { return status.bad(); }

  void grow() {
    for (std::size_t i = 0; i < Model::size; ++i) sizes_[i] = xsimd::max(sizes_[i], size_of(state_.values[i]));
  }

  void step(const Batch& goal) {
    const Status status = model_.series(t_, state_, order_, series_);
    const Mask is_refused = must_go_back(status);
    const Mask is_lost = stops(status) && !is_refused && !lost_;
    status_ = Math<Batch>::worse(status_, status.within(is_lost));
    lost_ = lost_ || is_lost;
    go_back(is_refused);
    // Where a step led that did not hold says nothing of sizes.
    grow();
    Batch span = xsimd::min(longest(goal), most_);
    lost_ = lost_ || (!(span > least_span(goal)) && !is_refused && (t_ < goal));
    const Mask arrives = t_ + span >= goal;
    span = xsimd::select(arrives, goal - t_, span);
    const Mask moves = (t_ < goal) && !lost_ && !is_refused;
    span = xsimd::select(moves, span, Batch(Number(0)));
    before_ = state_;
    t_before_ = t_;
    State there;
    integrate::state_of_series(series_, span, there);
    const Mask is_new = moves && !(refusals_ > Batch(Number(0)));
    Batch rates[Model::size];
    integrate::rate_of_series(series_, span, rates);
    for (std::size_t i = 0; i < Model::size; ++i) {
      expected_[i] = rates[i];
      const Batch largest = xsimd::max(Number(k_recent) * largest_rates_[i], size_of(series_.values[1][i]));
      largest_rates_[i] = xsimd::select(is_new, largest, largest_rates_[i]);
      noise_[i] = xsimd::select(is_new, Number(k_recent) * noise_[i], noise_[i]);
      state_.values[i] = xsimd::select(moves, there.values[i], state_.values[i]);
    }
    t_ = xsimd::select(moves, xsimd::select(arrives, goal, t_ + span), t_);
    if (settings_.project) project(moves);
    taken_ = taken_ + xsimd::select(moves, Batch(Number(1)), Batch(Number(0)));
    span_ = span;
    reach_ = xsimd::select(moves, span, reach_);
    ++steps_;
  }

  /// Lanes whose last step ended where the model has other rates than its series, or none.
  Mask must_go_back(const Status& status) {
    const Mask has_moved = (span_ > Batch(Number(0))) && !lost_;
    note_noise(has_moved);
    Values rounding = zeros();
    Mask agrees = agrees_but_for(rounding);
    if (xsimd::any(has_moved && !agrees && !stops(status)) && find_rounding(rounding)) agrees = agrees_but_for(rounding);
    return has_moved && (!agrees || stops(status));
  }

  Batch off(std::size_t i) const { return size_of(expected_[i] - series_.values[1][i]); }

  void note_noise(const Mask& has_moved) {
    const Mask is_noise = has_moved && refusals_ >= Batch(Number(k_noise));
    if (xsimd::none(is_noise)) return;
    for (std::size_t i = 0; i < Model::size; ++i)
      noise_[i] = xsimd::select(is_noise, xsimd::max(noise_[i], off(i)), noise_[i]);
  }

  Mask agrees_but_for(const Values& rounding) const {
    const Mask is_strict = refused_ > Batch(Number(0));
    Mask agrees = Mask(true);
    for (std::size_t i = 0; i < Model::size; ++i) {
      const Batch apart = off(i);
      const Mask is_jump = apart > Number(k_jump) * largest_rates_[i] && apart > Number(k_lost) * noise_[i];
      const Batch by_terms = xsimd::select(is_jump, Batch(most_off(k_stiff_at_jumps)), Batch(most_off(k_stiff)));
      const Batch most = xsimd::select(is_told_ && !(is_jump && is_strict), by_terms, Batch(Number(1)));
      agrees = agrees && span_ * (apart - rounding[i]) <= most * allowed_[i];
    }
    return agrees;
  }

  Number most_off(double stiff) const { return std::min(Number(stiff), Number(k_of_rates) / settings_.tolerance); }

  /// Of rates, as TaylorSimulation has it. A lane without rates there has none that it could have been taken for.
  bool find_rounding(Values& rounding) const {
    Values x, rates;
    std::copy_n(state_.values, x.size(), x.begin());
    std::copy_n(series_.values[1], rates.size(), rates.begin());
    Series near;
    return simulate::changes_by_rounding(
        x, rates,
        [&](const Values& moved, Values& result) {
          State state;
          std::copy_n(moved.begin(), moved.size(), state.values);
          const Mask is_bad = stops(model_.series(t_, state, 4, near));
          for (std::size_t i = 0; i < Model::size; ++i)
            result[i] = xsimd::select(is_bad, rates[i], near.values[1][i]);
          return true;
        },
        rounding);
  }

  void go_back(const Mask& where) {
    for (std::size_t i = 0; i < Model::size; ++i)
      state_.values[i] = xsimd::select(where, before_.values[i], state_.values[i]);
    t_ = xsimd::select(where, t_before_, t_);
    taken_ = taken_ - xsimd::select(where, Batch(Number(1)), Batch(Number(0)));
    const Batch none(std::numeric_limits<Number>::infinity());
    const Batch refused = xsimd::select(span_ < refused_, refused_, Batch(Number(0)));
    refused_ = xsimd::select(where, xsimd::max(refused_, span_), refused);
    const Batch others = xsimd::select(span_ > Batch(Number(0)), Batch(Number(0)), refusals_);
    refusals_ = xsimd::select(where, refusals_ + Batch(Number(1)), others);
    most_ = xsimd::select(where, span_ * Number(0.5), xsimd::select(span_ > Batch(Number(0)), none, most_));
  }

  static Batch least_span(const Batch& goal) { return Number(4) * Math<Batch>::epsilon() * size_of(goal); }

  /// As SeriesControl has it. What is allowed is that of a step which is no longer than one that was refused.
  Batch longest(const Batch& goal) {
    constexpr double k_alike = 0.125;
    constexpr int k_most_times = 30;
    const Mask is_first = !(reach_ > Batch(Number(0)));
    Batch reach = reach_, most = goal - t_;
    if (settings_.longest_step > Number(0)) most = xsimd::min(most, Batch(settings_.longest_step));
    if (xsimd::any(is_first)) reach = xsimd::select(is_first, first_reach(xsimd::max(most, least())), reach_);
    reach = xsimd::min(reach, most_);
    Batch span = longest_within(reach);
    for (int k = 0; k < k_most_times; ++k) {
      const Mask is_shorter = is_first && span < Number(k_alike) * reach;
      if (xsimd::none(is_shorter)) break;
      reach = xsimd::select(is_shorter, span, reach);
      span = xsimd::select(is_shorter, longest_within(reach), span);
    }
    return settings_.longest_step > Number(0) ? xsimd::min(span, Batch(settings_.longest_step)) : span;
  }

  /// By the last two terms, and by the two before them where these are larger than they usually are; by the last that there is where these are 0.
  Batch longest_within(const Batch& reach) {
    Values sizes, places, by_allowed;
    for (std::size_t i = 0; i < Model::size; ++i) sizes[i] = size_within(reach, i);
    groups_.find_largest(sizes.data(), places.data());
    for (std::size_t i = 0; i < Model::size; ++i) {
      allowed_[i] = settings_.tolerance * sizes[i] + last_places() * places[i] + least();
      by_allowed[i] = Batch(Number(1)) / allowed_[i];
    }
    const int q = order_ - 3;
    const Batch first = part(by_allowed, q + 3), second = part(by_allowed, q + 2);
    const Batch by_two = xsimd::min(logarithm_within(first, q + 3), logarithm_within(second, q + 2));
    Batch span = rough_exp2(by_two);
    const Batch third = part(by_allowed, q + 1), fourth = part(by_allowed, q), factor = integrate::power(span, q);
    const Mask is_usual = third * factor * span <= Number(k_usual) && fourth * factor <= Number(k_usual);
    if (!xsimd::all(is_usual)) {
      const Batch by_others = xsimd::min(logarithm_within(third, q + 1), logarithm_within(fourth, q));
      span = xsimd::select(is_usual, span, rough_exp2(xsimd::min(by_two, by_others)));
    }
    const Batch none(Number(0));
    is_told_ = first > none || second > none || third > none || fourth > none;
    for (int k = q - 1; k > order_ / 2 && !xsimd::all(is_told_); --k) {
      const Batch last = part(by_allowed, k);
      const Mask is_last = !is_told_ && last > none;
      span = xsimd::select(is_last, rough_exp2(logarithm_within(last, k)), span);
      is_told_ = is_told_ || is_last;
    }
    return span;
  }

  /// As SeriesControl has it.
  Batch size_within(const Batch& reach, std::size_t i) const {
    const Batch by_rate = reach * size_of(series_.values[1][i]);
    Batch size = xsimd::max(sizes_[i], by_rate);
    const Mask is_less = by_rate < sizes_[i];
    if (xsimd::all(is_less)) return size;
    Batch power = reach, largest = size;
    for (int k = 2; k <= last_of_size(); ++k) {
      power = power * reach;
      largest = xsimd::max(largest, power * size_of(series_.values[k][i]));
    }
    return xsimd::select(is_less, size, largest);
  }

  int last_of_size() const { return std::max(2, order_ / 2); }

  /// The largest term of an order for a step of 1, in units of what is allowed.
  Batch part(const Values& by_allowed, int order) const {
    Batch result(Number(0));
    for (std::size_t i = 0; i < Model::size; ++i)
      result = xsimd::max(result, size_of(series_.values[order][i]) * by_allowed[i]);
    return result;
  }

  /// To the base 2, of the longest step whose term of an order is allowed.
  static Batch logarithm_within(const Batch& part, int order) {
    return rough_log2(xsimd::max(part, least())) * (Number(-1) / static_cast<Number>(order));
  }

  /// What starts from 0 has the size of its own first terms. In logarithms: powers of all pairs of terms would take as long as some steps do.
  Batch first_reach(const Batch& most) const {
    const Batch none(-std::numeric_limits<Number>::infinity());
    Batch reach = rough_log2(most);
    for (std::size_t i = 0; i < Model::size; ++i) {
      Batch sizes[Series::most / 2 + 1];
      for (int k = 1; k <= last_of_size(); ++k) {
        const Batch size = settings_.tolerance * size_of(series_.values[k][i]);
        sizes[k] = xsimd::select(size > Batch(Number(0)), rough_log2(xsimd::max(size, least())), none);
      }
      for (const int p : {order_, order_ - 1}) {
        const Batch last = size_of(series_.values[p][i]), log_last = rough_log2(xsimd::max(last, least()));
        const Mask is_there = last > Batch(Number(0));
        Batch longest = none;
        for (int k = 1; k <= last_of_size() && k < p; ++k) {
          const Batch by_it = (sizes[k] - log_last) * (Number(1) / static_cast<Number>(p - k));
          const Batch shorter = xsimd::select(is_there, xsimd::min(reach, by_it), reach);
          longest = xsimd::select(sizes[k] > none, xsimd::max(longest, shorter), longest);
        }
        reach = xsimd::select(longest > none, longest, reach);
      }
    }
    return rough_exp2(reach);
  }

  static Batch last_places() { return Number(4) * Math<Batch>::epsilon(); }
  static Batch least() { return Batch(std::numeric_limits<Number>::min() / std::numeric_limits<Number>::epsilon()); }

  // As TaylorSimulation has them.
  static constexpr double k_stiff = 10'000, k_stiff_at_jumps = 100, k_jump = 0.001, k_of_rates = 0.1;
  static constexpr double k_lost = 4, k_recent = 0.9;
  static constexpr int k_noise = 10;
  static constexpr double k_usual = 10'000;     ///< as SeriesControl has it

  Model model_;
  simulate::Settings<Number> settings_;
  integrate::UnitGroups<Model> groups_{model_};
  int order_;
  State state_, before_{};
  Batch t_, t_before_ = Batch(Number(0)), span_ = Batch(Number(0));
  Batch reach_ = Batch(Number(0));  ///< the last step that went on
  Batch most_ = Batch(std::numeric_limits<Number>::infinity());
  Batch refused_ = Batch(Number(0)), refusals_ = Batch(Number(0));  ///< as TaylorSimulation has them
  Batch taken_ = Batch(Number(0));
  Values sizes_ = zeros(), allowed_ = zeros(), expected_ = zeros();
  Values largest_rates_ = zeros(), noise_ = zeros();
  Mask lost_ = Mask(false);
  Mask is_told_ = Mask(true);  ///< as SeriesControl has it
  Status status_{};
  Series series_{};
  long steps_ = 0;

  static Values zeros() {
    Values values;
    values.fill(Batch(Number(0)));
    return values;
  }
};

}  // namespace gauss::batch

#endif  // GAUSS_BATCH_TAYLOR_LANES_HPP
