#include "sim/run/lost_digits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "sim/output/sampler.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

using Values = std::vector<long double>;

/// Of components of states: what rests has no size of its own.
class Sizes {
 public:
  /// `resolved`: of sizes; what moves by less is at rest, for all that the run knows. Of outputs, the yardstick knows it.
  Sizes(const std::vector<std::string>& units, const std::vector<PassedStates::One>& states, double resolved,
        const std::vector<Column>& columns, const Yardstick& yardstick)
      : units_(units), rests_(units.size()) {
    const std::size_t n = units.size();
    range_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      long double least = std::numeric_limits<long double>::infinity(), most = -least;
      for (const auto& [t, state] : states) {
        least = std::min(least, state[i]);
        most = std::max(most, state[i]);
      }
      range_[i] = most - least;
      long double& size = by_unit_[units[i]];
      size = std::max({size, std::abs(least), std::abs(most)});
    }
    for (std::size_t i = 0; i < n; ++i) rests_[i] = !(range_[i] > resolved * size(i));
    for (std::size_t place = 0; place < columns.size(); ++place)
      if (columns[place].is_state) rests_[columns[place].source] = yardstick.is_constant(place);
  }

  std::size_t count() const { return units_.size(); }
  const std::string& unit(std::size_t i) const { return units_[i]; }
  bool rests(std::size_t i) const { return rests_[i]; }
  long double size(std::size_t i) const { return by_unit_.at(units_[i]); }
  long double scale(std::size_t i) const { return rests_[i] ? size(i) : range_[i]; }

 private:
  std::vector<std::string> units_;
  std::vector<bool> rests_;
  Values range_;
  std::map<std::string, long double> by_unit_;
};

/// What is 0 is so in both.
double share(long double difference, long double whole) {
  if (difference == 0 || std::isnan(difference)) return 0;
  return static_cast<double>(difference / whole);
}

/// The model in one number type.
template <class S>
class InOne {
 public:
  InOne(const PreparedModel& prepared, const Engine& engine)
      : engine_(engine.another()),
        model_(prepared.model),
        functions_(gausssim::bind<S>(*engine_, model_)),
        sampler_(*engine_, model_, prepared.columns, *functions_) {}

  const std::vector<std::string>& units() const { return functions_->units; }

  /// Empty: none is known.
  Values start() const {
    Numbers<S> start;
    const gauss::Status status = initial_state(*engine_, model_, *functions_, start);
    return gauss::integrate::is_motion_known(status) ? widened(start) : Values{};
  }
  Values rates(const PassedStates::One& one) const {
    const Numbers<S> state = narrowed(one);
    Numbers<S> rates(state.size(), S(0));
    return functions_->rates(S(one.t), state.data(), rates.data()) == gauss::Status::ok ? widened(rates) : Values{};
  }
  Values outputs(const PassedStates::One& one) {
    const Numbers<S> state = narrowed(one);
    Numbers<S> row(sampler_.size(), S(0));
    return sampler_(S(one.t), state.data(), row.data()) == gauss::Status::ok ? widened(row) : Values{};
  }

 private:
  static Numbers<S> narrowed(const PassedStates::One& one) {
    Numbers<S> result;
    for (const long double value : one.state) result.push_back(static_cast<S>(value));
    return result;
  }
  static Values widened(const Numbers<S>& values) {
    Values result;
    for (const S& value : values) result.push_back(static_cast<long double>(value));
    return result;
  }

  std::unique_ptr<const Engine> engine_;
  const Described& model_;
  std::shared_ptr<Functions<S>> functions_;
  Sampler<S> sampler_;
};

/// The largest of what the model differs by, in parts of what matters.
template <class S, class W>
class Comparison {
 public:
  Comparison(const PreparedModel& prepared, const Engine& engine, const PassedStates& states,
             const Yardstick& yardstick, double resolved)
      : model_(prepared.model),
        columns_(prepared.columns),
        yardstick_(yardstick),
        states_(states.all()),
        duration_(prepared.span.duration),
        narrow_(prepared, engine),
        wide_(prepared, engine),
        sizes_(narrow_.units(), states_, resolved, prepared.columns.columns, yardstick) {}

  /// Of one state out of `stride`.
  Lost lost(std::size_t stride) {
    if (states_.empty()) return {};
    const Values start = narrow_.start(), start_in_wide = wide_.start();
    const bool is_start_known = !start.empty() && !start_in_wide.empty();
    for (std::size_t i = 0; is_start_known && i < start.size(); ++i)
      add(share(std::abs(start[i] - start_in_wide[i]), sizes_.scale(i)), model_.component(i));
    look_at_rates(stride);
    look_at_outputs(stride);
    return lost_;
  }

 private:
  void add(double share, const std::string& name) {
    if (share > lost_.value) lost_.value = share, lost_.output = name;
  }

  void look_at_rates(std::size_t stride) {
    const std::size_t n = sizes_.count();
    Values differ(n, 0), largest(n, 0);
    std::map<std::string, long double> by_unit;
    for (std::size_t k = 0; k < states_.size(); k += stride) {
      const Values rates = narrow_.rates(states_[k]), in_wide = wide_.rates(states_[k]);
      if (rates.empty() || in_wide.empty()) continue;
      for (std::size_t i = 0; i < n; ++i) {
        differ[i] = std::max(differ[i], std::abs(rates[i] - in_wide[i]));
        largest[i] = std::max(largest[i], std::abs(in_wide[i]));
        long double& size = by_unit[sizes_.unit(i)];
        size = std::max(size, largest[i]);
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      const long double others = by_unit[sizes_.unit(i)];
      const double in_time = share(differ[i] * duration_, sizes_.scale(i));
      if (!sizes_.rests(i)) {
        add(share(differ[i], largest[i]), model_.component(i));
        lost_.in_time = std::max(lost_.in_time, in_time);
      } else if (differ[i] > k_rounded * std::numeric_limits<S>::epsilon() * others) {
        // It would not rest.
        add(share(differ[i], largest[i]), model_.component(i));
      } else {
        // Rates of what rests are rounding, all of them; as little comes of it.
        add(std::min(share(differ[i], others), in_time), model_.component(i));
      }
    }
  }

  void look_at_outputs(std::size_t stride) {
    for (std::size_t k = 0; k < states_.size(); k += stride) {
      const Values row = narrow_.outputs(states_[k]), in_wide = wide_.outputs(states_[k]);
      if (row.empty() || in_wide.empty()) continue;
      for (std::size_t i = 0; i < row.size(); ++i)
        add(share(std::abs(row[i] - in_wide[i]), yardstick_.scale(i)), columns_.columns[i].name);
    }
  }

  static constexpr long double k_rounded = 1e4L;  ///< units in the last place, of what is only that

  const Described& model_;
  const Columns& columns_;
  const Yardstick& yardstick_;
  const std::vector<PassedStates::One>& states_;
  long double duration_;
  InOne<S> narrow_;
  InOne<W> wide_;
  Sizes sizes_;
  Lost lost_;
};

}  // namespace

PassedStates::PassedStates(long samples) {
  constexpr long k_many = 512;
  every_ = std::max(1L, (samples + k_many - 1) / k_many);
}

void PassedStates::note(long sample, long double t, const std::vector<long double>& state) {
  if (sample % every_ == 0) states_.push_back({t, state});
}

LostDigits::LostDigits(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                       const PassedStates& states, const Yardstick& yardstick)
    : prepared_(prepared), engine_(engine), states_(states), yardstick_(yardstick) {
  constexpr double k_least = 1e-12, k_clear = 10;
  resolved_ = std::max(k_least, k_clear * setting.tolerance);
}

Lost LostDigits::in(const std::string& number) const {
  constexpr double k_operations = 5e6, k_operations_in_quads = 2e4;  ///< of rates: some hundredths of a second
  const std::size_t stride = stride_for(k_operations_in_quads);
  if (number == "long-double")
    return Comparison<long double, Quad>(prepared_, engine_, states_, yardstick_, resolved_).lost(stride);
  Lost first = Comparison<double, long double>(prepared_, engine_, states_, yardstick_, resolved_)
                   .lost(stride_for(k_operations));
  Lost second = Comparison<double, Quad>(prepared_, engine_, states_, yardstick_, resolved_).lost(stride);
  const double in_time = std::max(first.in_time, second.in_time);
  if (first.value < second.value) first = second;
  first.in_time = in_time;
  return first;
}

std::size_t LostDigits::stride_for(double operations) const {
  constexpr double k_fewest = 8;
  const double states = std::max(operations / std::max(prepared_.operations, 1), k_fewest);
  return 1 + static_cast<std::size_t>(static_cast<double>(states_.all().size()) / states);
}

Passage passage(const PreparedModel& prepared, const Engine& engine, const Setting& setting, double seconds) {
  const TimeLimit limit(seconds);
  PreparedModel close = prepared;
  close.span.samples = std::max(prepared.span.samples, k_close_samples);
  Passage result{PassedStates(close.span.samples), Rows(close.columns.columns.size(), close.span.samples)};
  Listeners listeners;
  listeners.measures_drift = false;
  listeners.on_state = [&](long k, long double t, const std::vector<long double>& state) {
    result.states.note(k, t, state);
  };
  listeners.on_numbers = [&](long k, const std::vector<long double>& row) { result.rows.set(k, row); };
  (void)simulate(close, engine, setting, listeners);
  return result;
}

Yardstick of_themselves(const Rows& rows, const PreparedModel& prepared, const Setting& setting) {
  const double least = least_tolerance(setting.number);
  return Yardstick(rows, rows, prepared.columns.columns, least, least);
}

}  // namespace gausssim
