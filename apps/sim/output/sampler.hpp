#pragma once
// The row of a table that belongs to a state.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/engine/binding.hpp"
#include "sim/output/columns.hpp"

namespace gausssim {

template <class S>
class Sampler {
 public:
  /// Columns, functions and the model's description are those of one model. `functions` outlives the sampler.
  Sampler(const Engine& engine, const Described& model, Columns columns, const Functions<S>& functions)
      : columns_(std::move(columns)) {
    for (const SampledFunction& one : columns_.functions) {
      calls_.push_back(callable<S>(engine, model, one.function));
      calls_.back().bind(const_cast<S*>(functions.prepared.data()), const_cast<S*>(functions.inputs.data()));
      results_.emplace_back(one.size);
    }
    for (const Column& column : columns_.columns) {
      if (column.is_state) state_.resize(std::max(state_.size(), column.source + 1));
    }
    for (const Column& column : columns_.columns)
      places_.push_back(column.is_state ? &state_[column.source] : &results_[column.source][column.slot]);
  }
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  std::size_t size() const { return columns_.columns.size(); }
  const std::vector<Column>& columns() const { return columns_.columns; }

  /// Fills as many numbers as there are columns. Not ok: the first status of a function that is not, and its numbers are as they came.
  gauss::Status operator()(const S& t, const S* state, S* row) {
    gauss::Status status = gauss::Status::ok;
    for (std::size_t i = 0; i < calls_.size(); ++i) {
      const gauss::Status now = calls_[i](t, state, results_[i].data());
      if (status == gauss::Status::ok) status = now;
    }
    std::copy_n(state, state_.size(), state_.begin());
    const std::size_t count = places_.size();
    const S* const* const places = places_.data();
    for (std::size_t i = 0; i < count; ++i) row[i] = *places[i];
    return status;
  }

 private:
  Columns columns_;
  std::vector<Callable<S>> calls_;
  std::vector<std::vector<S>> results_;
  std::vector<S> state_;          ///< as far as there are columns of it
  std::vector<const S*> places_;  ///< of columns, in these
};

}  // namespace gausssim
