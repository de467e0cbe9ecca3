#pragma once
// A model at run time, in the form that integrators of src/gauss/ take.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gauss/math.hpp"
#include "sim/drive/numbers.hpp"
#include "sim/engine/entry.hpp"

namespace gausssim {

/// A function with what it reads besides the state and what it is to fill.
template <class S>
class Callable {
 public:
  Callable() = default;
  /// `places`: what each argument is.
  enum class Place { time, state, inputs, prepared, accelerations, first_result, second_result };
  Callable(Entry entry, std::vector<Place> places) : entry_(entry), places_(std::move(places)) {}

  explicit operator bool() const { return static_cast<bool>(entry_); }

  void bind(S* prepared, S* inputs) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i] == Place::prepared) bound_[i] = prepared;
      if (places_[i] == Place::inputs) bound_[i] = inputs;
      if (places_[i] == Place::time) time_ = i;
      if (places_[i] == Place::state) state_ = i;
      if (places_[i] == Place::accelerations) accelerations_ = i;
      if (places_[i] == Place::first_result) first_ = i;
      if (places_[i] == Place::second_result) second_ = i;
    }
  }

  gauss::Status operator()(const S& t, const S* state, S* first, S* second = nullptr,
                           const S* accelerations = nullptr) const {
    void* arguments[k_most];
    for (std::size_t i = 0; i < k_most; ++i) arguments[i] = bound_[i];
    // What has no place goes behind all that the function reads.
    arguments[time_] = const_cast<S*>(&t);
    arguments[state_] = const_cast<S*>(state);
    arguments[accelerations_] = const_cast<S*>(accelerations);
    arguments[first_] = first;
    arguments[second_] = second;
    return static_cast<gauss::Status>(entry_(arguments));
  }

 private:
  static constexpr std::size_t k_most = 8;  ///< no function has so many

  Entry entry_;
  std::vector<Place> places_;
  void* bound_[k_most] = {};
  std::size_t time_ = k_most - 1, state_ = k_most - 1, accelerations_ = k_most - 1, first_ = k_most - 1,
              second_ = k_most - 1;
};

/// The four functions of a plugin that steps by power series (engine/taylor_glue.hpp).
struct SeriesEntries {
  Entry begin, advance, tell, end;

  explicit operator bool() const { return begin && advance && tell && end; }
};

/// What integrators call, with all that it needs. Shared by their copies of a model.
template <class S>
struct Functions {
  std::size_t n_q = 0, n_v = 0;
  std::vector<S> prepared, inputs;
  std::vector<std::string> units;  ///< of the components of a state
  SeriesEntries series;
  Callable<S> rates, projection, positions, speeds, energy, residuals, jacobian;

  Functions() = default;
  Functions(const Functions&) = delete;
  Functions& operator=(const Functions&) = delete;

  std::size_t size() const { return n_q + n_v; }
};

/// A model in the sense of gauss/integrate/state_arrays.hpp.
template <class S>
class MotionModel {
 public:
  using Scalar = S;
  using Status = gauss::Status;
  using Array = Numbers<S>;
  template <class T>
  using Of = boost::container::small_vector<T, k_in_place>;
  struct State {
    Array values;
  };
  struct Derivative {
    Array values;
  };

  explicit MotionModel(std::shared_ptr<const Functions<S>> functions) : functions_(std::move(functions)) {}

  std::size_t size() const { return functions_->size(); }
  std::size_t coordinates() const { return functions_->n_q; }
  const char* unit(std::size_t component) const { return functions_->units[component].c_str(); }
  const Functions<S>& functions() const { return *functions_; }
  const std::shared_ptr<const Functions<S>>& shared_functions() const { return functions_; }

  Status rates(const S& t, const Array& x, Array& dxdt) const { return functions_->rates(t, x.data(), dxdt.data()); }
  Status derivative(const S& t, const State& state, Derivative& result) const {
    result.values.resize(size());
    return rates(t, state.values, result.values);
  }
  /// Onto all constraints; a model without any stays where it is.
  Status projection(const S& t, State& state) const { return onto(functions_->projection, t, state); }
  /// One step of Newton's method.
  Status position_step(const S& t, State& state) const { return onto(functions_->positions, t, state); }
  Status speed_step(const S& t, State& state) const { return onto(functions_->speeds, t, state); }

 private:
  static Status onto(const Callable<S>& function, const S& t, State& state) {
    return function ? function(t, state.values.data(), state.values.data()) : Status::ok;
  }

  std::shared_ptr<const Functions<S>> functions_;
};

}  // namespace gausssim
