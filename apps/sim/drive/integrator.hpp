#pragma once
// A method that carries a state forward: what the driver sees of all of them.

#include <functional>
#include <memory>
#include <string>

#include "gauss/simulate/report.hpp"
#include "sim/drive/grid.hpp"
#include "sim/drive/motion_model.hpp"

namespace gausssim {

/// How a run went so far.
template <class S>
struct Progress {
  gauss::simulate::Outcome outcome = gauss::simulate::Outcome::running;
  gauss::Status status = gauss::Status::ok;  ///< of the model, the last one that was not ok
  std::string why;                           ///< it stopped, where the method knows more than the outcome says
  long steps = 0, rejected = 0, calls = 0, jacobians = 0;
  long with_fewer_constraints = 0, crossings = 0;
  S start_moved = 0;  ///< by projection
  std::size_t start_component = 0;
};

/// As simulations of src/gauss/ tell it.
template <class S, class Report>
Progress<S> progress_of(const Report& report) {
  Progress<S> progress;
  progress.outcome = report.outcome;
  progress.status = report.status;
  progress.steps = report.steps;
  progress.rejected = report.rejected;
  progress.calls = report.calls;
  progress.jacobians = report.jacobians;
  progress.with_fewer_constraints = report.with_fewer_constraints;
  progress.crossings = report.crossings;
  progress.start_moved = static_cast<S>(report.start_moved);
  progress.start_component = report.start_component;
  return progress;
}

/// Times that will be asked for one after another, with functions of the states there.
template <class S>
struct Samples {
  Grid<S> grid{};
  long next = 0;            ///< the one that will be asked for first
  std::size_t results = 0;  ///< numbers that the functions fill
  Entry together;           ///< of a plugin that finds several at once (engine/taylor_glue.hpp); empty: there is none
};

/// States one after another, and what the functions fill there. Of one, neither its time nor results: the functions are still to be called.
template <class S>
struct Found {
  long count;
  const S* states;
  std::size_t size = 0;
  const S *times = nullptr, *results = nullptr;
  std::size_t result_size = 0;
};

template <class S>
class Integrator {
 public:
  using Array = Numbers<S>;

  virtual ~Integrator() = default;

  /// False: it did not get there, and `progress` says why.
  virtual bool advance_to(const S& end) = 0;
  /// One step, not beyond `end`, where the method tells its steps; else all the way there.
  virtual bool step_towards(const S& end) { return advance_to(end); }
  virtual S time() const = 0;
  /// Until it advances.
  virtual const Array& state() const = 0;
  /// How large components were before it began: what errors of them are relative to, at least.
  virtual void know_sizes(const Array&) {}
  /// What rounding of forces that cancel makes of rates, at least: no error of a step is told below that.
  virtual void know_rounding(const Array&) {}
  /// What comes next, for methods that know the motion within a step: advance_to may go on to times after the one that it was asked for.
  virtual void expect(const Samples<S>&) {}
  /// At that time and those after it, until it advances: where the method has these numbers.
  virtual Found<S> found() const { return {1, state().data()}; }
  virtual Progress<S> progress() const = 0;
};

}  // namespace gausssim
