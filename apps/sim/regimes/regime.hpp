#pragma once
// A regime with the numbers of a run.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "gauss/event/dense.hpp"
#include "sim/output/sampler.hpp"
#include "sim/regimes/regime_source.hpp"
#include "sim/regimes/shared_loads.hpp"

namespace gausssim {

template <class S>
S largest_of(const S* values, std::size_t count) {
  S result = 0;
  for (std::size_t i = 0; i < count; ++i) result = std::max(result, gauss::event::magnitude_of(values[i]));
  return result;
}

/// A state a little later.
template <class S>
Numbers<S> moved(const Numbers<S>& x, const Numbers<S>& rates, const S& dt) {
  Numbers<S> result = x;
  for (std::size_t i = 0; i < x.size(); ++i) result[i] += dt * rates[i];
  return result;
}

/// Coordinates at their zero have none.
template <class S>
S size_of_places(const Numbers<S>& x, std::size_t coordinates) {
  return std::max(S(1e-3), largest_of(x.data(), coordinates));
}

template <class S>
class Regime {
 public:
  /// `change`: of values of parameters and inputs, as `bind` takes it.
  Regime(std::shared_ptr<const RegimeModel> model, const Change<S>& change)
      : model_(std::move(model)),
        engine_(model_->engine->another()),
        functions_(bind<S>(*engine_, model_->model, change)),
        motion_(functions_),
        guards_(bound("guards")),
        impact_system_(bound("impact_system")),
        shared_loads_(bound("load_system"), functions_->n_v, model_->guards, model_->fixed_reactions),
        sampler_(*engine_, model_->model, model_->columns, *functions_),
        row_(sampler_.size()) {
    // Others may take some of it.
    functions_->energy_layout.is_conserved = false;
  }

  const std::vector<GuardOf>& guards() const { return model_->guards; }
  const Functions<S>& functions() const { return *functions_; }
  const MotionModel<S>& motion() const { return motion_; }
  const Engine& engine() const { return *engine_; }
  const Described& model() const { return model_->model; }

  /// In the order of guards().
  void fill_guards(const S& t, const Numbers<S>& x, std::vector<S>& values) const {
    values.resize(model_->guards.size());
    if (!guards_ || values.empty()) return;
    guards_(t, x.data(), values.data());
    shared_loads_.judge(t, x, values);
  }
  std::vector<S> guard_values(const S& t, const Numbers<S>& x) const {
    std::vector<S> values;
    fill_guards(t, x, values);
    return values;
  }

  /// Of each guard, about as large as what it is the difference of: Σ |∂guard/∂q| |q|, with 1e-3 for coordinates that are less. What it has no digits for, and what touches,
  /// is told by this, whatever unit it has, and however far away the rest of the model is.
  std::vector<S> reaches(const S& t, const Numbers<S>& x) const {
    std::vector<S> before(model_->guards.size()), after(before.size()), result(before.size(), S(0));
    if (!guards_ || before.empty()) return result;
    guards_(t, x.data(), before.data());
    for (std::size_t i = 0; i < functions_->n_q; ++i) {
      const S size = std::max(S(1e-3), gauss::event::magnitude_of(x[i])),
              part = gauss::Math<S>::sqrt(gauss::Math<S>::epsilon());
      Numbers<S> beside = x;
      beside[i] += part * size;
      guards_(t, beside.data(), after.data());
      for (std::size_t g = 0; g < before.size(); ++g) {
        const S change = gauss::event::magnitude_of(S(after[g] - before[g])) / part;
        if (change == change) result[g] += change;
      }
    }
    return result;
  }

  /// How guards that are `now` change, `rates` being those of the state: by a look a little later.
  std::vector<S> guard_rates(const S& t, const Numbers<S>& x, const Numbers<S>& rates, const std::vector<S>& now,
                             const S& dt) const {
    std::vector<S> result = guard_values(t + dt, moved(x, rates, dt));
    for (std::size_t g = 0; g < now.size(); ++g) result[g] = (result[g] - now[g]) / dt;
    return result;
  }

  Numbers<S> rates(const S& t, const Numbers<S>& x) const {
    Numbers<S> result(x.size(), S(0));
    functions_->rates(t, x.data(), result.data());
    return result;
  }

  /// Onto what holds in it. False: there is no such state near.
  bool project(const S& t, Numbers<S>& x) const {
    if (!functions_->projection || !functions_->is_constrained) return true;
    Numbers<S> found = x;
    const gauss::Status status = functions_->projection(t, x.data(), found.data());
    if (!gauss::integrate::is_motion_known(status)) return false;
    x = found;
    return true;
  }

  SharedLoads<S>& shared_loads() { return shared_loads_; }

  /// As the generator's `impact_system` fills it; false without one.
  bool impact_system(const S& t, const Numbers<S>& x, std::vector<S>& filled) const {
    return impact_system_ && gauss::integrate::is_motion_known(impact_system_(t, x.data(), filled.data()));
  }

  /// Into the columns of the run that it has; the others are as they were.
  gauss::Status sample(const S& t, const S* x, S* row) {
    const gauss::Status status = sampler_(t, x, row_.data());
    for (std::size_t i = 0; i < row_.size(); ++i) row[model_->in_row[i]] = row_[i];
    return status;
  }

 private:
  Callable<S> bound(const char* function) {
    Callable<S> found = callable<S>(*engine_, model_->model, function);
    if (found) found.bind(functions_->prepared.data(), functions_->inputs.data());
    return found;
  }

  std::shared_ptr<const RegimeModel> model_;
  std::unique_ptr<const Engine> engine_;
  std::shared_ptr<Functions<S>> functions_;
  MotionModel<S> motion_;
  Callable<S> guards_, impact_system_;
  SharedLoads<S> shared_loads_;
  Sampler<S> sampler_;
  std::vector<S> row_;
};

}  // namespace gausssim
