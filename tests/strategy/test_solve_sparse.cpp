// Linear equations as expressions, with values for which single pivots are small.

#include <cmath>
#include <optional>
#include <vector>

#include "catch_shim.hpp"
#include "evaluate/arithmetic_double.hpp"
#include "evaluate/evaluator.hpp"
#include "kinematics/solve_sparse.hpp"

using gaussgen::ir::Expr;
using gaussgen::kinematics::LargeBlocks;
using gaussgen::kinematics::solve_sparse;

namespace {

using Entries = std::vector<std::vector<double>>;

/// The matrix of unknowns x_k = k + 1, each entry a symbol unless it is 0.
class System {
 public:
  explicit System(Entries numbers) : numbers_(std::move(numbers)) {
    const std::size_t n = numbers_.size();
    for (std::size_t i = 0; i < n; ++i) {
      matrix_.emplace_back();
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) {
        matrix_.back().push_back(symbol(numbers_[i][j]));
        sum += numbers_[i][j] * static_cast<double>(j + 1);
      }
      right_.push_back(symbol(sum));
    }
  }

  std::optional<std::vector<double>> solve(LargeBlocks large) {
    const auto found = solve_sparse(matrix_, right_, large);
    if (!found) return std::nullopt;
    gaussgen::evaluate::Evaluator<double> values(graph_, gaussgen::evaluate::Arithmetic<double>());
    for (const auto& [id, value] : bound_) values.bind(id, value);
    std::vector<double> result;
    for (const Expr x : *found) result.push_back(values(x.id()).value_or(std::nan("")));
    return result;
  }

 private:
  Expr symbol(double value) {
    if (value == 0) return {graph_, graph_.constant(0)};
    const auto id = graph_.declare(gaussgen::ir::SymbolClass::parameter, "s" + std::to_string(bound_.size()));
    bound_.emplace_back(id, value);
    return {graph_, graph_.use(id)};
  }

  gaussgen::ir::Graph graph_;
  Entries numbers_;
  std::vector<std::vector<Expr>> matrix_;
  std::vector<Expr> right_;
  std::vector<std::pair<gaussgen::ir::SymbolId, double>> bound_;
};

/// 1 on the diagonal, and less beside it.
Entries coupled(std::size_t n) {
  Entries numbers(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      numbers[i][j] = i == j ? 1 : 0.3 * std::sin(static_cast<double>(7 * i + 3 * j + 1));
  }
  return numbers;
}

void check(const std::optional<std::vector<double>>& found, double tolerance) {
  REQUIRE(found);
  for (std::size_t k = 0; k < found->size(); ++k)
    CHECK((*found)[k] == Approx(static_cast<double>(k + 1)).epsilon(tolerance));
}

}  // namespace

TEST_CASE("equations that couple up to four unknowns, and more where these are wanted") {
  for (const std::size_t n : {1, 2, 3, 4}) check(System(coupled(n)).solve(LargeBlocks::refuse), 1e-14);
  for (const std::size_t n : {5, 6, 9}) {
    CHECK_FALSE(System(coupled(n)).solve(LargeBlocks::refuse));
    check(System(coupled(n)).solve(LargeBlocks::eliminate), 1e-13);
  }
}

TEST_CASE("a pivot that happens to be small takes no digits") {
  Entries numbers = coupled(6);
  numbers[0][0] = 1e-7;
  check(System(numbers).solve(LargeBlocks::eliminate), 1e-13);
  numbers[2][2] = -1e-6;
  check(System(numbers).solve(LargeBlocks::eliminate), 1e-13);
}

TEST_CASE("rows are exchanged where there is nothing on the diagonal") {
  Entries numbers = coupled(6);
  numbers[0][0] = numbers[1][1] = numbers[4][4] = 0;
  numbers[0][1] = 0;
  check(System(numbers).solve(LargeBlocks::eliminate), 1e-12);
}

TEST_CASE("what is solved row by row is as before, and a column of zeros has no solution") {
  Entries ring(6, std::vector<double>(6));
  for (std::size_t i = 0; i < 6; ++i) {
    ring[i][i] = 2;
    if (i > 0) ring[i][i - 1] = 1;
  }
  check(System(ring).solve(LargeBlocks::refuse), 1e-14);
  ring[0][5] = 0.5;
  check(System(ring).solve(LargeBlocks::eliminate), 1e-14);
  Entries singular = coupled(6);
  for (std::size_t i = 0; i < 6; ++i) singular[i][3] = 0;
  CHECK_FALSE(System(singular).solve(LargeBlocks::eliminate));
}
