#pragma once
// The row of a table that belongs to a state.

#include <algorithm>
#include <cstddef>
#include <functional>
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
      : columns_(std::move(columns)) {
    together_ = engine.find(samples_name(names_of(columns_.functions)), scalar_name<S>());
    for (const SampledFunction& one : columns_.functions) {
      calls_.push_back(callable<S>(engine, model, one.function));
      calls_.back().bind(const_cast<S*>(functions.prepared.data()), const_cast<S*>(functions.inputs.data()));
      results_.emplace_back(one.size);
      rows_of_all_.push_back(row_of_all(results_.size() - 1));
    }
    for (const Column& column : columns_.columns) {
      if (column.is_state) state_.resize(std::max(state_.size(), column.source + 1));
    }
    std::size_t place = 0;
    for (const Column& column : columns_.columns) {
      const std::vector<S>& all = column.is_state ? state_ : results_[column.source];
      if (column.is_state || !rows_of_all_[column.source])
        add(all, column.is_state ? column.source : column.slot, place);
      ++place;
    }
  }
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  std::size_t size() const { return columns_.columns.size(); }
  const std::vector<Column>& columns() const { return columns_.columns; }

  /// What an integrator may find at once, of `count` times from `first` on.
  Samples<S> expected(long first, long count, std::function<S(long)> at) const {
    std::size_t size = 0;
    for (const auto& result : results_) size += result.size();
    return {first, count, std::move(at), size, together_};
  }

  /// Fills as many numbers as there are columns. `found`: those of the functions, one after another, where they are known. Not ok: the first status of a function
  /// that is not, and its numbers are as they came.
  gauss::Status operator()(const S& t, const S* state, S* row, const S* found = nullptr) {
    gauss::Status status = gauss::Status::ok;
    for (std::size_t i = 0; i < calls_.size(); ++i) {
      S* const result = rows_of_all_[i] ? row + *rows_of_all_[i] : results_[i].data();
      if (found != nullptr) {
        std::copy_n(found, results_[i].size(), result);
        found += results_[i].size();
        continue;
      }
      const gauss::Status now = calls_[i](t, state, result);
      if (status == gauss::Status::ok) status = now;
    }
    if (!state_.empty()) std::copy_n(state, state_.size(), state_.begin());
    for (const Piece& piece : pieces_) std::copy_n(piece.all + piece.first, piece.size, row + piece.place);
    return status;
  }

 private:
  /// Numbers beside each other here as in a row.
  struct Piece {
    const S* all;
    std::size_t first, size, place;
  };

  void add(const std::vector<S>& all, std::size_t first, std::size_t place) {
    Piece* const last = pieces_.empty() ? nullptr : &pieces_.back();
    if (last != nullptr && last->all == all.data() && last->first + last->size == first &&
        last->place + last->size == place) {
      ++last->size;
    } else {
      pieces_.push_back({all.data(), first, 1, place});
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
    return found == results_[function].size() ? begin : std::nullopt;
  }

  Columns columns_;
  Entry together_;
  std::vector<Callable<S>> calls_;
  std::vector<std::vector<S>> results_;
  std::vector<std::optional<std::size_t>> rows_of_all_;
  std::vector<S> state_;       ///< as far as there are columns of it
  std::vector<Piece> pieces_;  ///< of these, column by column
};

}  // namespace gausssim
