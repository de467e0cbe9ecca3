#pragma once
// Runs a model in a scalar type: all functions that a simulation needs.

#include <algorithm>
#include <type_traits>

#include "answers.hpp"
#include "tested_model.hpp"

namespace headertest {

/// One state in S, and what S makes of it.
template <class M, class S>
struct Point {
  S t{};
  typename M::template State<S> state{};
  typename M::template Inputs<S> inputs{};
  typename M::template Parameters<S> parameters{};
};

template <class M, class S>
struct Results {
  typename M::template Derivative<S> derivative{};
  typename M::template ReactionsOrNone<S> reactions{};
  typename M::template EnergyOf<S> energies{};
  typename M::template State<S> projected{};
  typename M::template State<S> initial{};
  std::vector<gauss::StatusOf<S>> statuses;
};

template <class M>
inline constexpr bool has_reactions = !std::is_empty_v<typename M::template ReactionsOrNone<double>>;

// Unqualified calls: each model's functions are found in the namespace of its structs.
template <class M, class S>
Results<M, S> results(const Point<M, S>& at) {
  Results<M, S> found;
  const auto prepared = prepare(at.parameters);
  if constexpr (has_reactions<M>) {
    found.statuses.push_back(
        rhs_and_reactions(at.t, at.state, at.inputs, prepared, found.derivative, found.reactions));
  } else {
    found.statuses.push_back(rhs(at.t, at.state, at.inputs, prepared, found.derivative));
  }
  found.statuses.push_back(energy(at.t, at.state, prepared, found.energies));
  found.statuses.push_back(project(at.t, at.state, prepared, found.projected));
  found.statuses.push_back(initial_state(prepared, found.initial));
  return found;
}

/// A struct of scalars as an array of them.
template <class S, class Struct>
std::vector<S> scalars(const Struct& result) {
  if constexpr (std::is_empty_v<Struct>) return {};
  static_assert(std::is_empty_v<Struct> || sizeof(Struct) % sizeof(S) == 0, "a result struct holds scalars only");
  const S* first = reinterpret_cast<const S*>(&result);
  return std::vector<S>(first, first + sizeof(Struct) / sizeof(S));
}

template <class M, class S>
std::array<std::vector<S>, k_parts.size()> parts(const Results<M, S>& found) {
  const std::vector<S> rates = scalars<S>(found.derivative);
  return {std::vector<S>(rates.begin(), rates.begin() + M::n_q),
          std::vector<S>(rates.begin() + M::n_q, rates.end()),
          scalars<S>(found.reactions),
          scalars<S>(found.energies),
          scalars<S>(found.projected),
          scalars<S>(found.initial)};
}

/// Exact for every type whose digits fit into three doubles, up to the range of double.
template <class S>
Wide widened(S value) {
  Wide sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double part = static_cast<double>(value);
    sum += part;
    if (!(part - part == 0)) break;
    value = value - static_cast<S>(part);
  }
  return sum;
}
inline Wide widened(const Wide& value) { return value; }

template <class M, class S>
Point<M, S> point(const Sample& sample) {
  Point<M, S> at;
  at.t = static_cast<S>(sample.t);
  for (std::size_t i = 0; i < sample.y.size(); ++i) at.state.values[i] = static_cast<S>(sample.y[i]);
  return at;
}

template <class M, class S>
Answer answer(const Point<M, S>& at) {
  const Results<M, S> found = results<M, S>(at);
  Answer result;
  result.statuses = found.statuses;
  const auto values = parts<M, S>(found);
  for (std::size_t p = 0; p < values.size(); ++p) {
    for (const S& value : values[p]) result.parts[p].push_back(widened(value));
  }
  return result;
}

template <class M, class S>
Computed computed() {
  return {M::name, M::n_q, M::n_v, [](const std::vector<Sample>& samples) {
            std::vector<Answer> answers;
            for (const Sample& sample : samples) answers.push_back(answer<M, S>(point<M, S>(sample)));
            return answers;
          }};
}

}  // namespace headertest
