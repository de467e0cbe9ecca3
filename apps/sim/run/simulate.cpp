#include "sim/run/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <type_traits>

#include "gauss/integrate/step_result.hpp"
#include "sim/drive/gains.hpp"
#include "sim/drive/quad.hpp"
#include "sim/drive/stopwatch.hpp"
#include "sim/output/csv.hpp"
#include "sim/regimes/columns_of_regimes.hpp"
#include "sim/regimes/hybrid.hpp"
#include "sim/run/build_engine.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/nudge.hpp"
#include "sim/run/setting.hpp"

namespace gausssim {

namespace {

using gauss::simulate::Outcome;

template <class S>
S number_of(const std::string& text) {
  if constexpr (std::is_same_v<S, Quad>) {
    return quad_of(text);
  } else {
    return static_cast<S>(std::strtold(text.c_str(), nullptr));
  }
}
/// Not by way of more digits, which would round twice.
template <>
double number_of<double>(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

template <class S>
class Simulator {
 public:
  Simulator(const PreparedModel& prepared, const Engine& engine, const Setting& setting, const Listeners& listeners,
            const Simulated* earlier)
      : earlier_(earlier),
        prepared_(prepared),
        engine_(engine),
        setting_(setting),
        listeners_(listeners),
        functions_(bound(engine)),
        pulled_(setting.projection == Projection::gains && functions_->gains
                    ? std::make_unique<PulledRates<S>>(*functions_, S(setting.gain))
                    : nullptr),
        model_(functions_),
        grid_(grid_of<S>(prepared.span)),
        sampler_(engine, prepared.model, prepared.regimes ? Columns{} : prepared.columns, *functions_),
        meter_(*functions_, prepared.model),
        row_(prepared.columns.columns.size()) {}

  Simulated run() {
    Numbers<S> start;
    result_.status = initial_state(engine_, prepared_.model, *functions_, start);
    if (setting_.is_nudged) nudge_state(start, unit());
    if (earlier_ != nullptr) go_on(start);
    if (!gauss::integrate::is_motion_known(result_.status)) {
      result_.outcome = Outcome::model_failed;
      result_.why = fmt::format("the initial state cannot be found: {}", gauss::name(result_.status));
      return result_;
    }
    const Stopwatch watch;
    const MethodSettings<S> settings = method_settings<S>(setting_);
    const S from = earlier_ == nullptr ? grid_.start : grid_.at(earlier_->samples - 1);
    const bool keeps_energy =
        setting_.projection == Projection::energy && why_not_projected(*functions_, Projection::energy).empty();
    if (keeps_energy && earlier_ == nullptr) keep_energy(from, start);
    const auto integrator = prepared_.regimes
                                ? through_regimes(start, from, settings)
                                : make_integrator(setting_.method, model_, start, from, settings, result_.why);
    if (!integrator) {
      result_.outcome = Outcome::bad_settings;
      return result_;
    }
    shown_ = start;
    result_.samples = drive<S>(*integrator, sampler_.expected(grid_, earlier_ == nullptr ? 0 : earlier_->samples),
                               [&](const Sample<S>& sample) { return take(sample, *integrator); });
    const Seconds all = watch.seconds(), of_regimes = hybrid_ == nullptr ? Seconds{} : hybrid_->making();
    result_.cpu_seconds = all.cpu - of_regimes.cpu;
    result_.wall_seconds = all.wall - of_regimes.wall;
    result_.regime_seconds = of_regimes.wall;
    note(*integrator);
    if (earlier_ != nullptr) add_earlier();
    return result_;
  }

 private:
  S unit() const { return S(rounding_unit(setting_.number)); }

  std::shared_ptr<Functions<S>> bound(const Engine& engine) const {
    auto functions = gausssim::bind<S>(engine, prepared_.model, change());
    // Impacts and friction take some of it.
    if (prepared_.regimes) functions->energy_layout.is_conserved = false;
    // What holds at first may be broken later, or more may hold.
    if (prepared_.regimes) functions->residuals = {};
    return functions;
  }

  Change<S> change() const {
    if (!setting_.is_nudged) return nullptr;
    return [unit = unit()](std::vector<S>& values) { nudge_given(values, unit); };
  }

  std::unique_ptr<Integrator<S>> through_regimes(const Numbers<S>& start, const S& from,
                                                 const MethodSettings<S>& settings) {
    if (!find_method(setting_.method)->tells_steps) {
      result_.why = fmt::format(
          "'{}' does not tell its steps, within which contacts and friction change: take prince87, dopri5 or "
          "fehlberg78, or radau for stiff models",
          setting_.method);
      return nullptr;
    }
    const bool is_compiled = std::string(engine_.name()) == "compiled";
    const auto make = [is_compiled, scalar = scalar_of(setting_.number), &prepared = prepared_](
                          const Described& model, const Columns& columns) -> std::unique_ptr<const Engine> {
      PreparedModel regime;
      regime.model = model;
      regime.columns = columns;
      regime.span = prepared.span;
      regime.plugins = prepared.plugins;
      EngineTimes times;
      std::string why;
      return build_engine(regime, is_compiled ? EngineChoice::automatic : EngineChoice::interpreted, {scalar}, times,
                          why);
    };
    prepared_.regimes->prepare(prepared_.columns.columns, make, [] { return std::make_shared<LimitsOfRunsWait>(); });
    auto hybrid = std::make_unique<Hybrid<S>>(prepared_.regimes, start, from,
                                              typename Hybrid<S>::Setting{setting_.method, settings, change()});
    hybrid_ = hybrid.get();
    if (earlier_ != nullptr) hybrid->go_on_after(earlier_->events);
    return hybrid;
  }

  gauss::Status fill_row(const S& t, const S* state, const S* results) {
    if (hybrid_ == nullptr) return sampler_(t, state, row_.data(), results);
    std::fill(row_.begin(), row_.end(), S(0));
    const gauss::Status status = hybrid_->sample(t, state, row_.data());
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const std::string& name = switch_in_column(prepared_.columns.columns[i]);
      if (!name.empty()) row_[i] = S(number_of_mode(hybrid_->modes().at(name)));
    }
    return status;
  }

  void go_on(Numbers<S>& start) {
    for (std::size_t i = 0; i < start.size(); ++i) start[i] = number_of<S>(earlier_->last_state[i]);
    meter_.go_on_from(earlier_->drift, earlier_->start_energy.empty() ? S(0) : number_of<S>(earlier_->start_energy));
    result_.kept_energy = earlier_->kept_energy;
    if (!earlier_->kept_energy.empty()) model_ = model_.keeping(number_of<S>(earlier_->kept_energy));
  }

  void keep_energy(const S& t, const Numbers<S>& start) {
    const S level = model_.projecting(Projection::energy, t, start).level();
    result_.kept_energy = text_of(level);
    model_ = model_.keeping(level);
  }

  void add_earlier() {
    result_.steps += earlier_->steps;
    result_.rejected += earlier_->rejected;
    result_.calls += earlier_->calls;
    result_.jacobians += earlier_->jacobians;
    result_.with_fewer_constraints += earlier_->with_fewer_constraints;
    result_.crossings += earlier_->crossings;
    result_.untrusted_samples += earlier_->untrusted_samples;
    if (result_.sample_status == gauss::Status::ok) result_.sample_status = earlier_->sample_status;
    result_.start_moved = earlier_->start_moved;
    result_.start_component = earlier_->start_component;
    result_.wall_seconds += earlier_->wall_seconds;
    result_.cpu_seconds += earlier_->cpu_seconds;
  }

  bool take(const Sample<S>& sample, const Integrator<S>& integrator) {
    const auto& [k, t, state, results] = sample;
    const gauss::Status status = fill_row(t, state, results);
    if (status != gauss::Status::ok) {
      ++result_.untrusted_samples;
      result_.sample_status = status;
    }
    if (listeners_.measures_drift) look_at_drift(t, state);
    if (listeners_.on_drift) listeners_.on_drift(static_cast<double>(t), meter_.energy(), meter_.constraints());
    if (listeners_.on_numbers) listeners_.on_numbers(k, in_long_double(row_.data(), row_.size()));
    if (listeners_.on_state) listeners_.on_state(k, static_cast<long double>(t), in_long_double(state, shown_.size()));
    bool goes_on = true;
    if (listeners_.on_row) {
      text_.clear();
      append_csv_row(text_, t, row_.data(), row_.size());
      goes_on = listeners_.on_row(text_, static_cast<double>(k + 1) / static_cast<double>(grid_.samples));
      shown_.assign(state, state + shown_.size());
      until_shown_ = integrator.progress();
    }
    result_.was_interrupted = Interruption::is_asked_for() && k + 1 < grid_.samples;
    return goes_on && !result_.was_interrupted;
  }

  /// Of what the regime in force keeps.
  void look_at_drift(const S& t, const S* state) {
    if (hybrid_ == nullptr) return meter_.look(t, state);
    const Regime<S>& regime = hybrid_->regime();
    meters_of_regimes_.try_emplace(&regime, regime.functions(), regime.model()).first->second.look(t, state);
  }

  void add_drift_of_regimes() {
    for (const auto& [regime, meter] : meters_of_regimes_) {
      const Drift& drift = meter.drift();
      result_.drift.has_constraints = result_.drift.has_constraints || drift.has_constraints;
      result_.drift.positions = std::max(result_.drift.positions, drift.positions);
      result_.drift.velocities = std::max(result_.drift.velocities, drift.velocities);
    }
  }

  static std::vector<long double> in_long_double(const S* values, std::size_t count) {
    std::vector<long double> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(static_cast<long double>(values[i]));
    return result;
  }

  void note(const Integrator<S>& integrator) {
    Progress<S> progress = integrator.progress();
    if (progress.outcome == Outcome::interrupted) result_.was_interrupted = Interruption::is_asked_for();
    // --resume makes the steps after the last sample again: they count then.
    if (result_.was_interrupted) progress = until_shown_;
    result_.outcome = progress.outcome;
    if (!progress.why.empty()) result_.why = progress.why;
    if (progress.status != gauss::Status::ok) result_.status = progress.status;
    result_.reached = static_cast<double>(result_.was_interrupted ? grid_.at(result_.samples - 1) : integrator.time());
    result_.steps = progress.steps;
    result_.rejected = progress.rejected;
    result_.calls = progress.calls;
    result_.jacobians = progress.jacobians;
    result_.with_fewer_constraints = progress.with_fewer_constraints;
    result_.crossings = progress.crossings;
    result_.start_moved = static_cast<double>(progress.start_moved);
    result_.start_component = prepared_.model.component(progress.start_component);
    if (hybrid_ != nullptr) {
      result_.events = hybrid_->events();
      result_.regimes = prepared_.regimes->count();
    }
    result_.drift = meter_.drift();
    add_drift_of_regimes();
    if (result_.drift.has_energy) result_.start_energy = text_of(meter_.start_energy());
    const bool can_go_on = result_.was_interrupted || result_.outcome == Outcome::too_many_steps;
    const Numbers<S>& last = can_go_on ? shown_ : integrator.state();
    for (const S& value : last) result_.last_state.push_back(text_of(value));
    result_.last_row = text_.empty() && earlier_ != nullptr ? earlier_->last_row : text_;
  }

  const Simulated* earlier_;  ///< null: there is none
  const PreparedModel& prepared_;
  const Engine& engine_;
  const Setting& setting_;
  const Listeners& listeners_;
  std::shared_ptr<Functions<S>> functions_;
  std::unique_ptr<PulledRates<S>> pulled_;
  MotionModel<S> model_;
  Grid<S> grid_;
  Sampler<S> sampler_;
  DriftMeter<S> meter_;
  std::map<const Regime<S>*, DriftMeter<S>> meters_of_regimes_;
  Hybrid<S>* hybrid_ = nullptr;  ///< the integrator of a model with regimes
  std::vector<S> row_;
  Numbers<S> shown_;         ///< state of the last sample
  Progress<S> until_shown_;  ///< and how the run went until then
  std::string text_;
  Simulated result_;
};

}  // namespace

Simulated simulate(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                   const Listeners& listeners, const Simulated* earlier) {
  if (setting.number == "float") return Simulator<float>(prepared, engine, setting, listeners, earlier).run();
  if (setting.number == "long-double")
    return Simulator<long double>(prepared, engine, setting, listeners, earlier).run();
  if (setting.number == "float128") return Simulator<Quad>(prepared, engine, setting, listeners, earlier).run();
  return Simulator<double>(prepared, engine, setting, listeners, earlier).run();
}

}  // namespace gausssim
