// Integration in time by power series, with projection: of models that were generated with `taylor`.
// SPDX-License-Identifier: MIT
#ifndef GAUSS_SIMULATE_TAYLOR_SIMULATION_HPP
#define GAUSS_SIMULATE_TAYLOR_SIMULATION_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gauss/integrate/projection_near.hpp"
#include "gauss/integrate/taylor.hpp"
#include "gauss/integrate/unit_groups.hpp"
#include "gauss/simulate/report.hpp"
#include "gauss/simulate/rounding.hpp"

namespace gauss::simulate {

/// What a step by a series may miss each component by, and how long a step keeps to that.
///
/// Each component is allowed the tolerance of the largest size that it had so far or is about to get, and some units in the last place of the largest component of the same
/// unit (StepControl has more to say of these).
template <class Model, class Series>
class SeriesControl {
 public:
  using Scalar = typename Model::Scalar;
  using Array = std::array<Scalar, Model::size>;

  SeriesControl(const Model& model, const Settings<Scalar>& settings) : tolerance_(settings.tolerance), groups_(model) {
    for (std::size_t i = 0; i < Model::size; ++i)
      sizes_[i] = i < Model::n_q ? settings.smallest_scale : settings.least_speed();
  }

  template <class State>
  void grow(const State& state) {
    for (std::size_t i = 0; i < Model::size; ++i) sizes_[i] = std::max(sizes_[i], size_of(state.values[i]));
  }

  /// The longest step whose last terms are allowed, and no longer than `most`; 0 where they have no value.
  Scalar span(const Series& series, const Scalar& most) {
    if (reach_ > Scalar(0)) return span_within(series, reach_, most);
    // How far a first step is to get is known when its length is.
    constexpr Scalar k_alike = Scalar(0.125);
    constexpr int k_most_times = 30;
    Scalar reach = first_reach(series, most), span = span_within(series, reach, most);
    for (int k = 0; k < k_most_times && span < k_alike * reach; ++k) {
      reach = span;
      span = span_within(series, reach, most);
    }
    return span;
  }

  /// A step that is shorter than it was to be gets less far.
  void shorten(const Series& series, const Scalar& span) { allow(series, span); }

  void took(const Scalar& span) { reach_ = span; }

  /// Whether terms of the series say how far it holds: a motion from rest may have none in its upper half, and be a polynomial or not.
  bool is_told() const { return is_told_; }

  const Array& allowed() const { return allowed_; }

  static Scalar size_of(const Scalar& x) { return x < Scalar(0) ? -x : x; }

 private:
  static Scalar last_places() { return 4 * Math<Scalar>::epsilon(); }

  Scalar span_within(const Series& series, const Scalar& reach, const Scalar& most) {
    allow(series, reach);
    const int p = series.order;
    if (!is_number(series)) return Scalar(0);
    const Scalar by_last = within(part(series, p), p, most);
    const Scalar by_two = within(part(series, p - 1), p - 1, by_last);
    is_told_ = true;
    return p > 4 ? by_those_before(series, by_two) : by_two;
  }

  /// std::max forgets a NaN.
  static bool is_number(const Series& series) {
    Scalar sum = 0;
    for (std::size_t i = 0; i < Model::size; ++i)
      sum += series.values[series.order][i] + series.values[series.order - 1][i];
    return sum - sum == Scalar(0);
  }

  /// The largest term of an order for a step of 1, in units of what is allowed.
  Scalar part(const Series& series, int order) const {
    Scalar result = 0;
    for (std::size_t i = 0; i < Model::size; ++i)
      result = std::max(result, size_of(series.values[order][i]) * by_allowed_[i]);
    return result;
  }

  /// From rest, motions are even in time, and may have a term in each fourth order only: the last two are 0 then. Terms of one order after another are
  /// e^2 apart where a step is as long as it should be. Where forces are powers, even fewer orders have one: then it is the last of them that is allowed.
  Scalar by_those_before(const Series& series, const Scalar& span) {
    constexpr Scalar k_usual = Scalar(10'000);
    const int q = series.order - 3;
    const Scalar power = integrate::power(span, q);
    const Scalar third = part(series, q + 1), fourth = part(series, q);
    if (!(third > Scalar(0) || fourth > Scalar(0) || part(series, q + 2) > Scalar(0) ||
          part(series, q + 3) > Scalar(0)))
      return by_last_there(series, q - 1, span);
    if (third * power * span <= k_usual && fourth * power <= k_usual) return span;
    return within(fourth, q, within(third, q + 1, span));
  }

  Scalar by_last_there(const Series& series, int order, const Scalar& span) {
    const int half = series.order / 2;
    while (order > half && !(part(series, order) > Scalar(0))) --order;
    is_told_ = order > half;
    return is_told_ ? within(part(series, order), order, span) : span;
  }

  /// part^(-1/order), or `most`. Whether it is `most` takes a few products to tell, where these are numbers with all of their digits.
  Scalar within(const Scalar& part, int order, const Scalar& most) const {
    if (!(part > Scalar(0))) return most;
    const Scalar power = integrate::power(most, order);
    if (power > least_ && part * power <= Scalar(1)) return most;
    return std::min(most, Math<Scalar>::pow(part, Scalar(-1) / Scalar(order)));
  }

  /// Terms up to this order say how far a component is about to get.
  static int last_of_size(const Series& series) { return std::max(2, series.order / 2); }

  /// What starts from 0 has the size of its own first terms: nothing is known of others. Which of them is the largest depends on the step: a force that begins with 0 has a rate from
  /// rounding alone.
  Scalar first_reach(const Series& series, const Scalar& most) const {
    Scalar least = most;
    for (std::size_t i = 0; i < Model::size; ++i) {
      for (const int p : {series.order, series.order - 1}) {
        const Scalar last = size_of(series.values[p][i]);
        Scalar reach = 0;
        for (int k = 1; k <= last_of_size(series) && k < p; ++k) {
          const Scalar size = size_of(series.values[k][i]);
          if (size > Scalar(0)) reach = std::max(reach, within(last / (tolerance_ * size), p - k, least));
        }
        if (reach > Scalar(0)) least = reach;
      }
    }
    return least;
  }

  /// By its rate, as long as that is less than it has been.
  Scalar size_within(const Series& series, const Scalar& reach, std::size_t i) const {
    const Scalar by_rate = reach * size_of(series.values[1][i]);
    if (by_rate < sizes_[i]) return sizes_[i];
    Scalar size = std::max(sizes_[i], by_rate), power = reach;
    for (int k = 2; k <= last_of_size(series); ++k) {
      power *= reach;
      size = std::max(size, power * size_of(series.values[k][i]));
    }
    return size;
  }

  void allow(const Series& series, const Scalar& reach) {
    Array sizes;
    for (std::size_t i = 0; i < Model::size; ++i) sizes[i] = size_within(series, reach, i);
    // What others with the same unit get to in this step counts too: at the start all of them may be 0.
    const Array places = groups_.largest(sizes);
    for (std::size_t i = 0; i < Model::size; ++i) {
      allowed_[i] = least_ + tolerance_ * sizes[i] + last_places() * places[i];
      by_allowed_[i] = Scalar(1) / allowed_[i];
    }
  }

  Scalar tolerance_;
  integrate::UnitGroups<Model> groups_;
  Array sizes_{}, allowed_{}, by_allowed_{};
  /// Below it, numbers have not all of their digits.
  Scalar least_ = std::numeric_limits<Scalar>::is_specialized
                      ? Scalar(std::numeric_limits<Scalar>::min() / Math<Scalar>::epsilon())
                      : Scalar(1e-290);
  Scalar reach_ = 0;  ///< the step before
  bool is_told_ = true;
};

namespace detail {

/// Of models that write elsewhere, and of others.
template <class Model, class Scalar, class State, class IsNear>
auto project_into(int, const Model& model, const Scalar& t, const State& from, State& to, const IsNear&)
    -> decltype(model.projection(t, from, to)) {
  return model.projection(t, from, to);
}
template <class Model, class Scalar, class State, class IsNear>
auto project_into(long, const Model& model, const Scalar& t, const State& from, State& to, const IsNear& is_near) {
  to = from;
  return integrate::projection_near(model, t, from, to, is_near);
}

}  // namespace detail

/// One series after another, each from the projected end of the one before. Within a step the motion is that of its series, so requested times cost no steps.
///
/// A step is accepted when its last two terms are allowed, and when the rates at its end are those of its series there: what the series did not see is found then. Inputs are
/// those at the beginning of each step; `restart()` takes others in.
template <class Model, class Series>
class TaylorSimulation {
 public:
  using Scalar = typename Model::Scalar;
  using State = typename Model::State;
  using Status = typename Model::Status;

  /// `order` 0: by the tolerance.
  TaylorSimulation(const Model& model, const State& start, const Scalar& start_time = 0,
                   const Settings<Scalar>& settings = {}, int order = 0)
      : model_(model), settings_(settings), t_(start_time), states_{start, start} {
    if (!settings_.are_usable() || !(start_time - start_time == Scalar(0))) {
      report_.outcome = Outcome::bad_settings;
      return;
    }
    order_ = order > 0 ? std::max(order, 2)
                       : integrate::taylor_order(static_cast<double>(settings_.tolerance), Series::most);
    project_start();
  }

  /// To `end`, which may lie within the step that was taken last. False: it did not get there, see report(); or `end` is no time from here on.
  bool advance_to(const Scalar& end) {
    if (!(t_ < end)) return t_ == end && report_.outcome == Outcome::running;
    return step_to(end) && look_at(end);
  }

  /// Steps until `end` lies within the last one, where nothing is looked at yet. False: it did not get there.
  bool step_to(const Scalar& end) {
    if (report_.outcome != Outcome::running) return false;
    if (!has_series_) begin();
    while (report_.outcome == Outcome::running && begin_ + span_ < end) step(end);
    return report_.outcome == Outcome::running;
  }

  /// As if it had advanced to `t`, within the last step, and found `value(component)` there.
  template <class Value>
  void take(const Scalar& t, const Value& value) {
    t_ = t;
    here_ = 1 - here_;
    for (std::size_t i = 0; i < Model::size; ++i) states_[here_].values[i] = value(i);
  }

  bool projects() const { return settings_.project; }
  /// By how much projection may move a component of a state within the last step.
  Scalar most_moved(std::size_t component) const { return settings_.most_projected * control_.allowed()[component]; }

  /// The next step begins at the state that was asked for last, with the inputs that there are now.
  void restart() { has_series_ = false; }

  const Scalar& time() const { return t_; }
  /// Until it advances.
  const State& state() const { return states_[here_]; }
  int order() const { return order_; }
  const Report<Status, Scalar>& report() const { return report_; }

  /// The step that has been taken last, and when it began: its series holds for `span()` from there.
  const Series& series() const { return series_[now_]; }
  const Scalar& begin_of_step() const { return begin_; }
  const Scalar& span() const { return span_; }

 private:
  Series& next() { return series_[1 - now_]; }

  void project_start() {
    if (!settings_.project) return;
    State& there = states_[1 - here_];
    const auto is_near_enough = [] { return true; };
    if (!integrate::is_motion_known(detail::project_into(0, model_, t_, state(), there, is_near_enough))) return;
    report_.compare_start(state(), there, Model::size);
    here_ = 1 - here_;
  }

  Status fill(const Scalar& t, const State& state, Series& series) {
    ++report_.calls;
    return model_.series(t, state, order_, series);
  }

  void begin() {
    begin_ = t_;
    span_ = 0;
    last_ = state();
    control_.grow(last_);
    const Status status = fill(begin_, last_, next());
    has_series_ = status == Status::ok;
    if (has_series_) return;
    report_.outcome = Outcome::model_failed;
    report_.status = status;
  }

  /// `next()` is the series from the end of the last step on: how far it holds, and the one after it.
  void step(const Scalar& end) {
    report_.outcome = settings_.before_step(report_.steps);
    if (report_.outcome != Outcome::running) return;
    now_ = 1 - now_;
    begin_ = begin_ + span_;
    Scalar span = control_.span(series(), longest(end));
    least_ = 4 * Math<Scalar>::epsilon() * std::max({begin_, -begin_, end - begin_});
    refusals_ = 0;
    for (jumped_ = false; span > least_ && !holds(span); ++report_.rejected) {
      ++refusals_;
      if (!(refused_ > Scalar(0))) rates_then_ = largest_rates_;
      refused_ = std::max(refused_, span);
      span = span / 2;
      control_.shorten(series(), span);
    }
    const bool is_short = !(span > least_);
    if (is_short && refused_ > Scalar(0)) span = hop();
    hops_ = is_short ? hops_ + 1 : 0;
    if (!(span > least_)) {
      report_.outcome = jumped_ ? Outcome::constraints_lost : Outcome::step_too_small;
      span_ = 0;
      return;
    }
    if (!(span < refused_)) refused_ = 0;
    span_ = span;
    ++report_.steps;
    control_.took(span);
    control_.grow(last_);
  }

  /// Where a jump is so near that terms hold for less than times have digits, or are beyond all numbers: towards it, each time twice as far, and over it, by few terms, which tell all of so short a step.
  /// 0: not there, or not again and again, as where a motion sticks.
  Scalar hop() {
    constexpr int k_most_hops = 24;
    if (hops_ >= k_most_hops || !is_bounded()) return 0;
    series_[now_].order = std::min(series().order, 2);
    const Scalar shortest = k_least * least_;
    Scalar span = shortest;
    for (int k = 0; k < hops_; ++k) span = 2 * span;
    for (; !(span < shortest); span = span / 2)
      if (holds(span)) return span;
    return 0;
  }

  /// Rates are about as large as before the jump came near; where they grow beyond all bounds, as at the end of a fall into a centre, nothing is behind.
  bool is_bounded() const {
    constexpr int k_alike = 16;
    for (std::size_t i = 0; i < Model::size; ++i) {
      const Scalar now = control_.size_of(series().values[1][i]);
      if (rates_then_[i] > Scalar(0) && !(now <= k_alike * rates_then_[i])) return false;
    }
    return true;
  }

  Scalar longest(const Scalar& end) const {
    Scalar most = std::max(end - begin_, 4 * span_);
    if (settings_.longest_step > Scalar(0)) most = std::min(most, settings_.longest_step);
    return report_.steps == 0 && settings_.first_step > Scalar(0) ? std::min(most, settings_.first_step) : most;
  }

  /// Goes to the end of a step and makes the series from there.
  bool holds(const Scalar& span) {
    State arrived;
    integrate::state_of_series(series(), span, arrived);
    last_ = arrived;
    jumped_ = false;
    const auto is_near_enough = [&] { return is_near(arrived, last_); };
    Status status = settings_.project
                        ? integrate::projection_near(model_, begin_ + span, arrived, last_, is_near_enough)
                        : Status::ok;
    if (integrate::is_motion_known(status)) {
      jumped_ = settings_.project && !is_near_enough();
      if (jumped_) return false;
      status = fill(begin_ + span, last_, next());
    }
    if (status != Status::ok) {
      report_.status = status;
      return false;
    }
    return agrees(span);
  }

  bool is_near(const State& a, const State& b) const {
    for (std::size_t i = 0; i < Model::size; ++i) {
      const Scalar off = a.values[i] - b.values[i], most = most_moved(i);
      if (!(off <= most && -most <= off)) return false;
    }
    return true;
  }

  using Array = typename SeriesControl<Model, Series>::Array;

  /// The rates that the model has at the end are those that the series has there, but for rounding.
  bool agrees(const Scalar& span) {
    constexpr int k_noise = 10;  ///< refusals in a row: behind a jump, there are not so many
    constexpr Scalar k_recent = Scalar(0.9);
    Array rates, off;
    integrate::rate_of_series(series(), span, rates);
    bool is_near = true;
    for (std::size_t i = 0; i < Model::size; ++i) {
      off[i] = control_.size_of(rates[i] - next().values[1][i]);
      if (refusals_ == 0) {
        largest_rates_[i] = std::max(k_recent * largest_rates_[i], control_.size_of(series().values[1][i]));
        noise_[i] = k_recent * noise_[i];
      }
      if (refusals_ >= k_noise) noise_[i] = std::max(noise_[i], off[i]);
      is_near = is_near && span * off[i] <= most_off(span, off[i], i) * control_.allowed()[i];
    }
    return is_near || is_rounding(span, off);
  }

  /// Where forces cancel each other, as those on a pendulum that stands upright, nothing is left of them but rounding.
  bool is_rounding(const Scalar& span, const Array& off) {
    Array x, rates, changes;
    std::copy_n(last_.values, x.size(), x.begin());
    std::copy_n(next().values[1], rates.size(), rates.begin());
    Series near;
    const auto rates_at = [&](const Array& moved, Array& result) {
      State state;
      std::copy_n(moved.begin(), moved.size(), state.values);
      ++report_.calls;
      if (model_.series(begin_ + span, state, 2, near) != Status::ok) return false;
      std::copy_n(near.values[1], result.size(), result.begin());
      return true;
    };
    if (!changes_by_rounding(x, rates, rates_at, changes)) return false;
    for (std::size_t i = 0; i < Model::size; ++i) {
      if (!(span * (off[i] - changes[i]) <= most_off(span, off[i], i) * control_.allowed()[i])) return false;
    }
    return true;
  }

  /// Numbers that are written one by one cannot be read several at a time right after that, so that states are not copied here.
  bool look_at(const Scalar& end) {
    State &there = states_[1 - here_], found;
    if (!settings_.project) {
      integrate::state_of_series(series(), end - begin_, there);
    } else {
      integrate::state_of_series(series(), end - begin_, found);
      const auto is_near_enough = [&] { return is_near(found, there); };
      const Status status = detail::project_into(0, model_, end, found, there, is_near_enough);
      jumped_ = integrate::is_motion_known(status) && !is_near_enough();
      if (!integrate::is_motion_known(status) || jumped_) {
        report_.status = status;
        report_.outcome = jumped_ ? Outcome::constraints_lost : Outcome::model_failed;
        return false;
      }
    }
    t_ = end;
    here_ = 1 - here_;
    return true;
  }

  /// In parts of what is allowed. Errors of rates are those of the step, times its order and more where forces are stiff, but no large part of the rates. What a series did not see is far beyond; where none of its
  /// terms say how far it holds, rates alone do. So they do after a refusal, until steps are as long again: half of a step has a far smaller error, unless there is a jump, and then the step that ends behind it has to be the
  /// shorter, as long as times have the digits for that. Rates that are off by a small part have lost digits, as have those that are off however short the step is: none is so short that they would agree.
  Scalar most_off(const Scalar& span, const Scalar& off, std::size_t component) const {
    constexpr Scalar k_stiff = Scalar(10'000), k_stiff_at_jumps = Scalar(100), k_jump = Scalar(0.001),
                     k_of_rates = Scalar(0.1);
    constexpr Scalar k_lost = 4;
    if (!control_.is_told()) return 1;
    const bool is_jump = off > k_jump * largest_rates_[component] && off > k_lost * noise_[component];
    if (is_jump && refused_ > Scalar(0))
      return span > k_least * least_ || !is_bounded() ? Scalar(1) : std::numeric_limits<Scalar>::infinity();
    return std::min(is_jump ? k_stiff_at_jumps : k_stiff, Scalar(k_of_rates / settings_.tolerance));
  }

  Model model_;
  Settings<Scalar> settings_;
  SeriesControl<Model, Series> control_{model_, settings_};
  int order_ = 2;
  Scalar t_;                     ///< asked for last
  std::array<State, 2> states_;  ///< then, and room for the next one
  std::size_t here_ = 0;
  Scalar begin_ = 0, span_ = 0;     ///< of the step
  State last_;                      ///< at its end
  std::array<Series, 2> series_{};  ///< of the step, and of the next one
  std::size_t now_ = 0;
  Array largest_rates_{};             ///< of steps not long ago, at their beginning
  Array rates_then_{};                ///< when a step was refused, since steps were as long again
  Array noise_{};                     ///< of rates not long ago: what they were off by, however short a step was
  Scalar least_ = 0;                  ///< steps are longer
  int refusals_ = 0;                  ///< of the step
  int hops_ = 0;                      ///< in a row
  static constexpr int k_least = 64;  ///< of least_: so short a step is taken over a jump, whatever it is
  Scalar refused_ = 0;                ///< the longest step that was, until one is as long again
  bool has_series_ = false, jumped_ = false;
  Report<Status, Scalar> report_;
};

}  // namespace gauss::simulate

#endif  // GAUSS_SIMULATE_TAYLOR_SIMULATION_HPP
