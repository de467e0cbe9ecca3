#pragma once
// The functions of a model at run time.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gauss/math.hpp"
#include "sim/engine/entry.hpp"

namespace gausssim {

/// What an argument of a function is.
enum class ArgumentIs { time, state, inputs, prepared, accelerations, first_result, second_result };

/// A function with what it reads besides the state and what it is to fill.
template <class S>
class Callable {
 public:
  Callable() = default;
  /// `places`: what each argument is.
  Callable(Entry entry, std::vector<ArgumentIs> places) : entry_(entry), places_(std::move(places)) {}

  /// For numbers of another type that have the same bytes; to be bound.
  template <class Other>
  explicit Callable(const Callable<Other>& same) : entry_(same.entry_), places_(same.places_) {}

  explicit operator bool() const { return static_cast<bool>(entry_); }

  void bind(S* prepared, S* inputs) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i] == ArgumentIs::prepared) bound_[i] = prepared;
      if (places_[i] == ArgumentIs::inputs) bound_[i] = inputs;
      if (places_[i] == ArgumentIs::time) time_ = i;
      if (places_[i] == ArgumentIs::state) (state_ == k_most - 1 ? state_ : start_) = i;
      if (places_[i] == ArgumentIs::accelerations) accelerations_ = i;
      if (places_[i] == ArgumentIs::first_result) first_ = i;
      if (places_[i] == ArgumentIs::second_result) second_ = i;
    }
    is_usual_ = places_ == std::vector<ArgumentIs>{ArgumentIs::time, ArgumentIs::state, ArgumentIs::inputs,
                                                   ArgumentIs::prepared, ArgumentIs::first_result};
  }

  gauss::Status operator()(const S& t, const S* state, S* first, S* second = nullptr,
                           const S* accelerations = nullptr) const {
    // That of rates, which are called more often than all others together.
    return is_usual_ ? usual(t, state, first) : general(t, state, first, second, accelerations);
  }

 private:
  template <class>
  friend class Callable;

  static constexpr std::size_t k_most = 8;  ///< no function has so many

  gauss::Status usual(const S& t, const S* state, S* result) const {
    void* const arguments[] = {const_cast<S*>(&t), const_cast<S*>(state), bound_[2], bound_[3], result};
    return static_cast<gauss::Status>(entry_(arguments));
  }

  /// Apart, so that the usual one is written out where it is called.
  [[gnu::noinline]] gauss::Status general(const S& t, const S* state, S* first, S* second,
                                          const S* accelerations) const {
    void* arguments[k_most];
    for (std::size_t i = 0; i < k_most; ++i) arguments[i] = bound_[i];
    // What has no place goes behind all that the function reads.
    arguments[time_] = const_cast<S*>(&t);
    arguments[state_] = const_cast<S*>(state);
    arguments[start_] = const_cast<S*>(state);
    arguments[accelerations_] = const_cast<S*>(accelerations);
    arguments[first_] = first;
    arguments[second_] = second;
    return static_cast<gauss::Status>(entry_(arguments));
  }

  Entry entry_;
  std::vector<ArgumentIs> places_;
  bool is_usual_ = false;
  void* bound_[k_most] = {};
  /// start_: of functions that take the state before a first step, too.
  std::size_t time_ = k_most - 1, state_ = k_most - 1, start_ = k_most - 1, accelerations_ = k_most - 1,
              first_ = k_most - 1, second_ = k_most - 1;
};

/// Of what the function `energy` fills.
struct EnergyLayout {
  std::size_t size = 0, kinetic = 0, total = 0;
  bool is_conserved = false;  ///< the same in every motion of the model
};

/// Derivatives of rates by the state, in what the function `jacobian` fills: row i has the entries row_begin[i] to row_begin[i + 1] - 1, and entry k is in column[k].
struct JacobianLayout {
  std::size_t size = 0, first = 0;  ///< of all numbers; the first entry
  std::vector<std::size_t> row_begin, column;
};

/// The four functions of a plugin that steps by power series (engine/taylor_glue.hpp).
struct SeriesEntries {
  Entry begin, advance, tell, end;

  explicit operator bool() const { return begin && advance && tell && end; }
};

/// Rates whose constraints pull themselves back to zero, of a plugin (engine/gains_glue.hpp).
struct GainsEntries {
  Entry begin, rates, end;

  explicit operator bool() const { return begin && rates && end; }
};

/// What integrators call, with all that it needs. Shared by their copies of a model.
template <class S>
struct Functions {
  std::size_t n_q = 0, n_v = 0;
  std::vector<S> parameters, prepared, inputs;
  std::vector<std::string> units;  ///< of the components of a state
  SeriesEntries series;
  GainsEntries gains;
  Callable<S> rates, projection, positions, speeds, energy, residuals, jacobian;
  EnergyLayout energy_layout;
  JacobianLayout jacobian_layout;
  bool is_constrained = true;  ///< else projection leaves every state where it is

  Functions() = default;
  Functions(const Functions&) = delete;
  Functions& operator=(const Functions&) = delete;

  std::size_t size() const { return n_q + n_v; }
};

}  // namespace gausssim
