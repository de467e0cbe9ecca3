#include <random>

#include "catch_shim.hpp"
#include "gauss/oracle/evaluation.hpp"
#include "lower/factorise.hpp"

using namespace gaussgen;
using namespace gaussgen::oracle;

namespace {

struct Symbolic {
  ir::Graph graph;
  lower::ExprMatrix matrix;
  Values values;
  Mat numbers;
  lower::MatrixNames names{"M", {}, {}};

  Symbolic(std::size_t n, bool is_symmetric, unsigned seed) : numbers(n, Vec(n)) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    for (std::size_t i = 0; i < n; ++i) {
      names.rows.push_back(std::to_string(i));
      names.columns.push_back(std::to_string(i));
      std::vector<ir::Expr> row;
      for (std::size_t j = 0; j < n; ++j) {
        const bool is_mirrored = is_symmetric && j < i;
        const std::string name = "m" + std::to_string(is_mirrored ? j : i) + std::to_string(is_mirrored ? i : j);
        if (!is_mirrored) values[name] = any(engine) + (is_symmetric && i == j ? static_cast<double>(n) : 0);
        const bool is_zero = !is_symmetric && i == j;  // elimination has to find pivots elsewhere
        numbers[i][j] = is_zero ? Real(0) : values[name];
        row.push_back(is_mirrored
                          ? matrix[j][i]
                          : ir::Expr(graph, is_zero ? graph.constant(0)
                                                    : graph.use(graph.declare(ir::SymbolClass::configuration, name))));
      }
      matrix.push_back(std::move(row));
    }
  }

  double error(const lower::ExprMatrix& result) {
    const Mat expected = inverse(numbers);
    double largest = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      for (std::size_t j = 0; j < expected.size(); ++j) {
        largest = std::max(largest, deviation(evaluate(graph, result[i][j].id(), values), expected[i][j]));
      }
    }
    return largest;
  }
};

}  // namespace

TEST_CASE("the unrolled LDLᵀ inverts symmetric matrices of three to six rows", "[lower]") {
  for (std::size_t n = 3; n <= 6; ++n) {
    Symbolic s(n, true, static_cast<unsigned>(n));
    CHECK(s.error(lower::inverse_by_ldlt(s.matrix, s.names)) < 1e-30);
  }
}

TEST_CASE("elimination inverts matrices with zeros on the diagonal", "[lower]") {
  for (std::size_t n = 2; n <= 5; ++n) {
    Symbolic s(n, false, static_cast<unsigned>(n));
    CHECK(s.error(lower::inverse_by_elimination(s.matrix, s.names)) < 1e-30);
  }
}
