#pragma once
// One simulation of a prepared model, in one number type.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/methods/methods.hpp"
#include "sim/regimes/event.hpp"
#include "sim/run/drive.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/prepare.hpp"

namespace gausssim {

struct Setting {
  std::string method, number = "double";
  int order = 0;                   ///< of series; 0: by the tolerance
  double tolerance = 0, step = 0;  ///< one of the two, as the method takes it; 0: the other
  double longest_step = 0;         ///< 0: any
  long most_steps = 0;             ///< 0: as methods have it
  Projection projection = Projection::full;
  double gain = 10;        ///< 1/s, of projection `gains`
  bool is_nudged = false;  ///< parameters, inputs and start differ by their rounding
};

/// What a setting leaves open is as methods have it.
template <class S>
MethodSettings<S> method_settings(const Setting& setting) {
  MethodSettings<S> settings;
  if (setting.tolerance > 0) settings.tolerance = S(setting.tolerance);
  if (setting.step > 0) settings.step = S(setting.step);
  settings.projection = setting.projection;
  settings.order = setting.order;
  settings.longest_step = S(setting.longest_step);
  if (setting.most_steps > 0) settings.most_steps = setting.most_steps;
  settings.ends = ends_steps;
  return settings;
}

struct Simulated {
  gauss::simulate::Outcome outcome = gauss::simulate::Outcome::running;
  std::string why;  ///< there was no motion at all
  gauss::Status status = gauss::Status::ok;
  bool was_interrupted = false;
  long samples = 0;
  double reached = 0;  ///< time
  long steps = 0, rejected = 0, calls = 0, jacobians = 0, with_fewer_constraints = 0, crossings = 0;
  double start_moved = 0;
  std::string start_component;
  long untrusted_samples = 0;  ///< an output had a status that is not ok
  gauss::Status sample_status = gauss::Status::ok;
  Drift drift;
  std::vector<Event> events;                 ///< of a model with regimes
  std::size_t regimes = 0;                   ///< that were come to
  double regime_seconds = 0;                 ///< in which they were derived and compiled
  double wall_seconds = 0, cpu_seconds = 0;  ///< of the integration, samples included
  std::vector<std::string> last_state;       ///< all digits; of the last sample, where a run can go on from it
  std::string last_row;                      ///< of the table that somebody writes
  std::string start_energy,
      kept_energy;  ///< likewise; that which drift is counted from, and that which projection keeps
};

/// Takes rows as text, with their share of the whole; false ends the run.
using OnRow = std::function<bool(const std::string& row, double share)>;
/// The same as numbers.
using OnNumbers = std::function<void(long k, const std::vector<long double>& row)>;

/// Of a sample.
using OnState = std::function<void(long k, long double t, const std::vector<long double>& state)>;

/// Of one sample: the change of the energy over the largest kinetic energy so far, and the largest residual of a constraint.
using OnDrift = std::function<void(double t, double energy, double constraints)>;

struct Listeners {
  OnRow on_row = nullptr;          ///< may be empty
  OnNumbers on_numbers = nullptr;  ///< likewise
  OnState on_state = nullptr;      ///< likewise
  OnDrift on_drift = nullptr;      ///< likewise
  bool measures_drift = true;
};

/// `earlier`: an interrupted run of the same, which goes on from its last sample; what is counted is counted for both.
Simulated simulate(const PreparedModel& prepared, const Engine& engine, const Setting& setting,
                   const Listeners& listeners, const Simulated* earlier = nullptr);

}  // namespace gausssim
