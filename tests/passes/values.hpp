#pragma once
// Values of outputs before and after a pass, in a hundred digits at random points.

#include <cln/float.h>
#include <cln/rational.h>

#include <random>
#include <string>
#include <vector>

#include "evaluate/arithmetic_cln.hpp"
#include "evaluate/evaluator.hpp"
#include "fixture.hpp"

namespace gausstest {

/// The largest relative difference of outputs that both have values at a random point.
inline double difference(const Graph& graph, const std::vector<NodeId>& before, const std::vector<NodeId>& after,
                         unsigned seed) {
  using cln::cl_F;
  gaussgen::evaluate::Evaluator<cl_F> values(graph, gaussgen::evaluate::Arithmetic<cl_F>(100));
  std::mt19937 source(seed);
  std::uniform_int_distribution<int> thousandths(250, 1250);
  for (std::size_t i = 0; i < graph.symbol_count(); ++i) {
    const gaussgen::ir::SymbolId symbol{static_cast<std::uint32_t>(i)};
    values.bind(symbol, cln::cl_float(cln::cl_RA(thousandths(source)) / 1000, cln::float_format(100)));
  }
  double worst = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto a = values(before[i]);
    const auto b = values(after[i]);
    if (a.has_value() != b.has_value()) return 1;
    if (!a) continue;
    const double size = cln::double_approx(cln::abs(*a));
    worst = std::max(worst, cln::double_approx(cln::abs(*a - *b)) / std::max(size, 1e-30));
  }
  return worst;
}

}  // namespace gausstest
