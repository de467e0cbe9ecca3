#pragma once
// Difference quotients of what the graph computes, in so many digits that they are derivatives to twenty.

#include <map>
#include <vector>

#include "agreement/models.hpp"
#include "evaluate/decimal.hpp"
#include "mechanics.hpp"

namespace derivatives {

using cln::cl_F;
using gaussgen::ir::NodeId;
using gaussgen::ir::SymbolId;

inline constexpr int k_digits = 70;
inline constexpr int k_step_digits = 24;
inline constexpr double k_tolerance = 1e-20;  ///< of the largest of a column and 1; the quotient is good to 1e-40 or so

class Numbers {
 public:
  Numbers(gaussgen::Mechanics& mechanics, const agreement::State& state)
      : mechanics_(mechanics), arithmetic_(k_digits), values_(mechanics.graph, arithmetic_) {
    gaussgen::bind_parameters(mechanics, values_);
    const auto& symbols = mechanics.symbols;
    set(symbols.time, state.time);
    for (const auto i : symbols.configuration.indices())
      set(symbols.configuration[i].symbol, state.configuration[i.value]);
    for (const auto i : symbols.speeds.indices()) set(symbols.speeds[i].symbol, state.speeds[i.value]);
    // Defaults are often 0, where nothing is seen of a product with an input.
    for (std::size_t i = 0; i < symbols.inputs.size(); ++i) set(symbols.inputs[i], 0.7 + 0.1 * static_cast<double>(i));
    for (std::size_t i = 0; i < symbols.parameters.size(); ++i) {
      const auto& parameter = mechanics.model.parameters[i];
      if (!parameter.is_formula)
        base_.emplace(symbols.parameters[i].index, *values_(mechanics.expressions(parameter.value).id()));
    }
  }

  /// Empty where one has no value here.
  std::vector<cl_F> operator()(const std::vector<NodeId>& nodes) {
    std::vector<cl_F> result;
    for (const auto& value : values_.evaluate(nodes)) {
      if (!value) return {};
      result.push_back(*value);
    }
    return result;
  }

  /// (f(x + h) - f(x - h)) / 2h, with the formulas that follow from a parameter.
  std::vector<cl_F> quotient(const std::vector<NodeId>& nodes, SymbolId symbol) {
    const cl_F h = arithmetic_.number(cln::expt(gaussgen::support::Rational(10), -k_step_digits));
    const cl_F at = base_.at(symbol.index);
    bind(symbol, at + h);
    const std::vector<cl_F> ahead = (*this)(nodes);
    bind(symbol, at - h);
    const std::vector<cl_F> behind = (*this)(nodes);
    bind(symbol, at);
    std::vector<cl_F> result;
    for (std::size_t i = 0; i < ahead.size() && i < behind.size(); ++i)
      result.push_back((ahead[i] - behind[i]) / (h + h));
    return result;
  }

 private:
  void set(SymbolId symbol, double value) {
    base_.emplace(symbol.index, arithmetic_.number(value));
    values_.bind(symbol, arithmetic_.number(value));
  }

  void bind(SymbolId symbol, const cl_F& value) {
    values_.bind(symbol, value);
    // Formulas in any order: after as many rounds as there are, the last one has its value.
    const auto& parameters = mechanics_.model.parameters;
    if (mechanics_.graph.symbol(symbol).symbol_class != gaussgen::ir::SymbolClass::parameter) return;
    for (std::size_t round = 0; round < parameters.size(); ++round) {
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!parameters[i].is_formula) continue;
        values_.bind(mechanics_.symbols.parameters[i], *values_(mechanics_.expressions(parameters[i].value).id()));
      }
    }
  }

  gaussgen::Mechanics& mechanics_;
  gaussgen::evaluate::Arithmetic<cl_F> arithmetic_;
  gaussgen::evaluate::Evaluator<cl_F> values_;
  std::map<std::uint32_t, cl_F> base_;
};

/// The largest difference, relative to the largest of what is expected and 1.
inline double deviation(const std::vector<cl_F>& found, const std::vector<cl_F>& expected) {
  double largest = 0, size = 1;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    size = std::max(size, std::abs(gaussgen::evaluate::to_double(expected[i])));
    largest = std::max(largest, std::abs(gaussgen::evaluate::to_double(found[i] - expected[i])));
  }
  return largest / size;
}

}  // namespace derivatives
