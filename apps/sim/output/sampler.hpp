#pragma once
// The row of a table that belongs to a state.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/drive/integrator.hpp"
#include "sim/engine/binding.hpp"
#include "sim/engine/samples_text.hpp"
#include "sim/output/columns.hpp"

namespace gausssim {

template <class S>
class Sampler {
 public:
  /// Columns, functions and the model's description are those of one model. `functions` outlives the sampler.
  Sampler(const Engine& engine, const Described& model, Columns columns, const Functions<S>& functions)
      : columns_(std::move(columns)),
        together_(engine.find(samples_name(names_of(columns_.functions)), scalar_name<S>())) {
    std::size_t first = 0;
    for (const SampledFunction& one : columns_.functions) {
      calls_.push_back({callable<S>(engine, model, one.function), first, row_of_all(calls_.size())});
      calls_.back().function.bind(const_cast<S*>(functions.prepared.data()), const_cast<S*>(functions.inputs.data()));
      first += one.size;
    }
    results_.resize(first);
    for (std::size_t place = 0; place < columns_.columns.size(); ++place) add(columns_.columns[place], place);
  }
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  std::size_t size() const { return columns_.columns.size(); }
  const std::vector<Column>& columns() const { return columns_.columns; }

  /// What an integrator may find at once, of the times from `first` on.
  Samples<S> expected(const Grid<S>& grid, long first) const { return {grid, first, results_.size(), together_}; }

  /// Fills as many numbers as there are columns. `found`: what the functions fill, one after another, where it is known. Not ok: the first status of a function
  /// that is not, and its numbers are as they came.
  gauss::Status operator()(const S& t, const S* state, S* row, const S* found = nullptr) {
    const gauss::Status status = found == nullptr ? call_all(t, state, row) : gauss::Status::ok;
    copy(of_state_, state, row);
    if (found != nullptr) {
      copy(of_functions_, found, row);
    } else {
      copy(of_others_, results_.data(), row);
    }
    return status;
  }

 private:
  struct Call {
    Callable<S> function;
    std::size_t first;                  ///< of its results among those of all
    std::optional<std::size_t> in_row;  ///< it fills a row from here on
  };
  /// Numbers beside each other there as in a row.
  struct Piece {
    std::size_t first, size, place;
  };
  using Pieces = std::vector<Piece>;

  gauss::Status call_all(const S& t, const S* state, S* row) {
    gauss::Status status = gauss::Status::ok;
    for (const Call& call : calls_) {
      S* const result = call.in_row ? row + *call.in_row : results_.data() + call.first;
      const gauss::Status now = call.function(t, state, result);
      if (status == gauss::Status::ok) status = now;
    }
    return status;
  }

  /// Number by number: what was just written so cannot be read several at a time yet.
  static void copy(const Pieces& pieces, const S* from, S* row) {
    for (const Piece& piece : pieces)
      for (std::size_t i = 0; i < piece.size; ++i) row[piece.place + i] = from[piece.first + i];
  }

  void add(const Column& column, std::size_t place) {
    if (column.is_state) return add(column.source, place, of_state_);
    const Call& call = calls_[column.source];
    add(call.first + column.slot, place, of_functions_);
    if (!call.in_row) add(call.first + column.slot, place, of_others_);
  }

  static void add(std::size_t first, std::size_t place, Pieces& pieces) {
    Piece* const last = pieces.empty() ? nullptr : &pieces.back();
    if (last != nullptr && last->first + last->size == first && last->place + last->size == place) {
      ++last->size;
    } else {
      pieces.push_back({first, 1, place});
    }
  }

  /// Where all numbers of a function are beside each other in a row, so that it may fill them there.
  std::optional<std::size_t> row_of_all(std::size_t function) const {
    std::optional<std::size_t> begin;
    std::size_t found = 0;
    for (std::size_t place = 0; place < columns_.columns.size(); ++place) {
      const Column& column = columns_.columns[place];
      if (column.is_state || column.source != function) continue;
      if (!begin) begin = place;
      if (column.slot != found || place != *begin + found) return std::nullopt;
      ++found;
    }
    return found == columns_.functions[function].size ? begin : std::nullopt;
  }

  Columns columns_;
  Entry together_;
  std::vector<Call> calls_;
  std::vector<S> results_;                      ///< of all functions
  Pieces of_state_, of_functions_, of_others_;  ///< of_others_: of functions that do not fill a row themselves
};

}  // namespace gausssim
