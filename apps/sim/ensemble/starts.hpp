#pragma once
// Where each trajectory begins, and with which parameters.

#include <memory>
#include <vector>

#include "sim/engine/binding.hpp"
#include "sim/ensemble/plan.hpp"
#include "sim/ensemble/vary.hpp"

namespace gausssim {

/// One thread's hold on a model, whose values change from one trajectory to the next.
template <class S>
struct Bound {
  Bound(const Engine& with, const Described& of);

  const Engine& engine;
  const Described& model;
  std::shared_ptr<Functions<S>> functions;
  std::vector<S> parameters, usual_inputs;
  Entry prepare;
  Callable<S> initial_state;
};

/// What makes trajectories differ. Any number of threads may ask it.
template <class S>
class Starts {
 public:
  virtual ~Starts() = default;

  /// Gives `bound` the values of a trajectory. Where the status says that there is no such motion, `state` has no meaning.
  virtual gauss::Status begin(long trajectory, Bound<S>& bound, Numbers<S>& state) const = 0;
};

/// As an ensemble says.
template <class S>
class PlannedStarts final : public Starts<S> {
 public:
  PlannedStarts(const Plan& plan, const std::vector<Placed>& places, const Described& model);

  gauss::Status begin(long trajectory, Bound<S>& bound, Numbers<S>& state) const override;

 private:
  const Plan& plan_;
  const std::vector<Placed>& places_;
  std::vector<std::size_t> slots_;  ///< of each place in its struct
};

/// The start of the model's file, each component changed by a small part of its size: trajectories that stay alike, for measurements.
template <class S>
class PerturbedStarts final : public Starts<S> {
 public:
  explicit PerturbedStarts(double part) : part_(part) {}

  gauss::Status begin(long trajectory, Bound<S>& bound, Numbers<S>& state) const override;

 private:
  double part_;
};

/// Where trajectories come from: a plan, or a measurement.
struct Source {
  const Plan* plan = nullptr;
  const std::vector<Placed>* places = nullptr;
  long count = 0;   ///< without a plan
  double part = 0;  ///< likewise, of the size of each component

  long size() const { return plan == nullptr ? count : plan->count(); }
};

template <class S>
std::unique_ptr<const Starts<S>> make_starts(const Source& source, const Described& model) {
  if (source.plan == nullptr) return std::make_unique<PerturbedStarts<S>>(source.part);
  return std::make_unique<PlannedStarts<S>>(*source.plan, *source.places, model);
}

}  // namespace gausssim
