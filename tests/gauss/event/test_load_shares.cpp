// Loads that more reactions share than the motion needs: against a search over all choices, and closed forms.

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "catch_shim.hpp"
#include "gauss/event/load_shares.hpp"
#include "random_metric.hpp"

using gauss::event::DenseMatrix;
using gauss::event::JudgedLoad;
using gauss::event::LoadProblem;
using gauss::event::LoadShares;
using gauss::event::solve_dense;

namespace {

using Numbers = std::vector<double>;

LoadProblem<double> problem_of(std::size_t speeds, Numbers rows, Numbers reactions) {
  LoadProblem<double> problem;
  problem.speeds = speeds;
  problem.metric.assign(speeds * speeds, 0);
  for (std::size_t i = 0; i < speeds; ++i) problem.metric[i * speeds + i] = 1;
  problem.rows = std::move(rows);
  problem.is_fixed.assign(reactions.size(), 0);
  problem.reactions = std::move(reactions);
  return problem;
}

JudgedLoad<double>& add_contact(LoadProblem<double>& problem, std::size_t row) {
  problem.judged.push_back({{row}, false, 0, Numbers(problem.count(), 0)});
  return problem.judged.back();
}

JudgedLoad<double>& add_limited(LoadProblem<double>& problem, std::vector<std::size_t> rows, double limit,
                                const std::vector<std::pair<std::size_t, double>>& per_reaction = {}) {
  problem.judged.push_back({std::move(rows), true, limit, Numbers(problem.count(), 0)});
  for (const auto& [row, part] : per_reaction) problem.judged.back().per_reaction[row] = part;
  return problem.judged.back();
}

/// row metric^-1 row, from which margins of different kinds are compared.
double norm(const LoadProblem<double>& problem, std::size_t row) {
  const std::size_t n = problem.speeds;
  DenseMatrix<double> metric(n, n);
  metric.entries = problem.metric;
  const Numbers own(problem.rows.begin() + static_cast<long>(row * n),
                    problem.rows.begin() + static_cast<long>((row + 1) * n));
  const Numbers response = solve_dense(metric, own);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += own[i] * response[i];
  return std::sqrt(sum);
}

double least_margin(const LoadProblem<double>& problem, const Numbers& norms, const Numbers& reactions) {
  double least = 1e300;
  for (const JudgedLoad<double>& one : problem.judged) {
    double margin = one.has_limit ? one.limit : reactions[one.rows[0]];
    if (one.has_limit) {
      double square = 0;
      for (const std::size_t row : one.rows) square += reactions[row] * reactions[row];
      for (std::size_t k = 0; k < problem.count(); ++k) margin += one.per_reaction[k] * reactions[k];
      margin -= std::sqrt(square);
    }
    least = std::min(least, margin * norms[one.rows[0]]);
  }
  return least;
}

/// The largest value of a concave function on [-size, size], and where.
std::pair<double, double> highest(const std::function<double(double)>& of, double size) {
  double low = -size, high = size;
  while (high - low > 1e-11 * size) {
    const double third = (high - low) / 3;
    (of(low + third) < of(high - third) ? low : high) = of(low + third) < of(high - third) ? low + third : high - third;
  }
  return {of((low + high) / 2), (low + high) / 2};
}

struct Best {
  double margin = 0;
  bool is_inside = true;  ///< of the reactions that were looked at
};

/// Reactions from `speeds` on are chosen, and the others follow: a concave function of those chosen.
Best by_search(const LoadProblem<double>& problem) {
  const std::size_t n = problem.speeds, l = problem.count();
  Numbers norms;
  for (std::size_t k = 0; k < l; ++k) norms.push_back(norm(problem, k));
  Numbers sum(n, 0);
  DenseMatrix<double> first(n, n);
  for (std::size_t k = 0; k < l; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      sum[i] += problem.rows[k * n + i] * problem.reactions[k];
      if (k < n) first(i, k) = problem.rows[k * n + i];
    }
  }
  constexpr double k_size = 300;
  Best best;
  Numbers reactions(l, 0);
  std::function<double(std::size_t)> search = [&](std::size_t k) {
    if (k == l) {
      Numbers right = sum;
      for (std::size_t j = n; j < l; ++j)
        for (std::size_t i = 0; i < n; ++i) right[i] -= problem.rows[j * n + i] * reactions[j];
      const Numbers found = solve_dense(first, right);
      std::copy(found.begin(), found.end(), reactions.begin());
      return least_margin(problem, norms, reactions);
    }
    const auto [value, at] = highest(
        [&](double x) {
          reactions[k] = x;
          return search(k + 1);
        },
        k_size);
    if (k == n) best.is_inside = std::abs(at) < 0.99 * k_size;
    return value;
  };
  best.margin = search(n);
  return best;
}

class RandomLoads {
 public:
  explicit RandomLoads(unsigned seed) : random_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// Contacts, and friction in one or two directions that each has with a share of some contact.
  LoadProblem<double> next(std::size_t speeds, std::size_t open, bool has_cones) {
    const std::size_t l = speeds + open;
    Numbers rows, reactions;
    for (std::size_t i = 0; i < l * speeds; ++i) rows.push_back(number(-1, 1));
    for (std::size_t k = 0; k < l; ++k) reactions.push_back(number(-1, 4));
    LoadProblem<double> problem = problem_of(speeds, rows, reactions);
    problem.metric = random_metric(random_, speeds);
    const std::size_t contacts = 1 + l / 3;
    for (std::size_t k = 0; k < contacts; ++k) add_contact(problem, k);
    for (std::size_t k = contacts; k < l;) {
      const std::size_t count = has_cones && k + 1 < l && number(0, 1) < 0.6 ? 2 : 1;
      std::vector<std::size_t> own{k};
      if (count == 2) own.push_back(k + 1);
      const std::size_t of = static_cast<std::size_t>(number(0, static_cast<double>(contacts) - 1e-9));
      add_limited(problem, own, number(0, 1), {{of, number(0, 0.8)}});
      k += count;
    }
    return problem;
  }

 private:
  std::mt19937 random_;
};

/// Of all that are open, in one unit.
double least_of(const LoadProblem<double>& problem, const std::vector<std::optional<double>>& margins) {
  double least = 1e300;
  for (std::size_t i = 0; i < margins.size(); ++i)
    if (margins[i]) least = std::min(least, *margins[i] * norm(problem, problem.judged[i].rows[0]));
  return least;
}

int compared(unsigned seed, int count, std::size_t open, bool has_cones, double nearness) {
  RandomLoads loads(seed);
  int seen = 0;
  for (int trial = 0; trial < count; ++trial) {
    CAPTURE(seed, trial);
    const LoadProblem<double> problem = loads.next(2 + static_cast<std::size_t>(trial % 3), open, has_cones);
    const Best best = by_search(problem);
    const double found = least_of(problem, LoadShares<double>(problem).margins());
    // Where they can press each other hard, or as hard as one likes, it is of no matter how hard.
    if (!best.is_inside || best.margin > 10) {
      CHECK(found > 0);
      continue;
    }
    CHECK(std::abs(found - best.margin) < nearness * std::max(1.0, std::abs(best.margin)));
    seen += best.margin < 0 ? 1 : 0;
  }
  return seen;
}

}  // namespace

TEST_CASE("The margin is the largest that any choice of reactions leaves to all", "[load_shares]") {
  CHECK(compared(1, 150, 1, false, 1e-8) > 20);
  CHECK(compared(2, 30, 2, false, 1e-8) > 5);
}

TEST_CASE("Likewise where friction has two directions", "[load_shares]") {
  CHECK(compared(3, 150, 1, true, 1e-7) > 20);
  CHECK(compared(4, 30, 2, true, 1e-7) > 5);
}

// A box on two feet that is pulled with F: friction of both, F = f_1 + f_2.
TEST_CASE("Two feet hold as much as both of them bear together", "[load_shares]") {
  for (const double pull : {1.0, 2.9, 3.1}) {
    LoadProblem<double> problem = problem_of(1, {1, 1}, {pull, 0});
    add_limited(problem, {0}, 1);
    add_limited(problem, {1}, 2);
    const auto margins = LoadShares<double>(problem).margins();
    CAPTURE(pull);
    CHECK((*margins[0] > 0) == (pull < 3));
    CHECK((*margins[1] > 0) == (pull < 3));
    if (pull > 2.5) CHECK(std::abs(*margins[0] - (3 - pull) / 2) < 1e-14);
    if (pull > 2.5) CHECK(*margins[0] == *margins[1]);
  }
}

// A ladder on two feet against a wall, that is pulled along the wall: nearly all is symmetric.
TEST_CASE("What a ladder has left changes by as much as its load does", "[load_shares]") {
  const auto left = [](double pull) {
    constexpr double width = 0.1, weight = 9.81, friction = 0.5;
    const double feet[4][3] = {{0.15, width, -0.2}, {0.15, -width, -0.2}, {-0.15, width, 0.2}, {-0.15, -width, 0.2}};
    Numbers rows;
    const auto add_row = [&](const double(&at)[3], int axis) {
      Numbers way(3, 0);
      way[static_cast<std::size_t>(axis)] = 1;
      for (const double one : way) rows.push_back(one);
      for (std::size_t i = 0; i < 3; ++i)
        rows.push_back(at[(i + 1) % 3] * way[(i + 2) % 3] - at[(i + 2) % 3] * way[(i + 1) % 3]);
    };
    for (int foot = 0; foot < 4; ++foot) add_row(feet[foot], foot < 2 ? 2 : 0);
    for (int foot = 0; foot < 4; ++foot) {
      add_row(feet[foot], foot < 2 ? 0 : 1);
      add_row(feet[foot], foot < 2 ? 1 : 2);
    }
    // Reactions bear the weight, and the pull at the feet, with some share.
    const Numbers load{0, -pull, weight, -0.2 * pull, 0, -0.15 * pull};
    DenseMatrix<double> normal(6, 6);
    for (std::size_t k = 0; k < 12; ++k)
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) normal(i, j) += rows[k * 6 + i] * rows[k * 6 + j];
    const Numbers parts = solve_dense(normal, load);
    Numbers reactions(12, 0);
    for (std::size_t k = 0; k < 12; ++k)
      for (std::size_t i = 0; i < 6; ++i) reactions[k] += rows[k * 6 + i] * parts[i];
    LoadProblem<double> problem = problem_of(6, rows, reactions);
    for (std::size_t i = 3; i < 6; ++i) problem.metric[i * 6 + i] = 0.02;
    for (std::size_t foot = 0; foot < 4; ++foot) add_contact(problem, foot);
    for (std::size_t foot = 0; foot < 4; ++foot)
      add_limited(problem, {4 + 2 * foot, 5 + 2 * foot}, 0, {{foot, friction}});
    return least_of(problem, LoadShares<double>(problem).margins());
  };
  const double alone = left(0);
  CHECK(alone > 0.1);
  for (int k = 0; k <= 200; ++k) {
    const double pull = std::pow(10.0, -6 + k * 0.03);
    CAPTURE(pull);
    if (pull < 0.5) CHECK(std::abs(left(pull) - alone) < 10 * pull);
  }
}

TEST_CASE("Links that break have the parts of equal stiffness, in any order", "[load_shares]") {
  LoadProblem<double> problem = problem_of(1, {1, 1}, {0, 3});
  add_limited(problem, {0}, 1).is_brittle = true;
  add_limited(problem, {1}, 9).is_brittle = true;
  const auto margins = LoadShares<double>(problem).margins();
  CHECK(std::abs(*margins[0] + 0.5) < 1e-15);
  CHECK(std::abs(*margins[1] - 7.5) < 1e-14);
}

TEST_CASE("What is overloaded in one place says nothing of another", "[load_shares]") {
  LoadProblem<double> problem = problem_of(2, {1, 0, 1, 0, 0, 1, 0, 1}, {5, 0, 5, 0});
  for (std::size_t k = 0; k < 4; ++k) add_limited(problem, {k}, k < 2 ? 2 : 4);
  const auto margins = LoadShares<double>(problem).margins();
  for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(*margins[k] - (k < 2 ? -0.5 : 1.5)) < 1e-14);
}

// Walls at both sides of a box that gravity pulls down between them.
TEST_CASE("Walls that nothing presses a body against do not hold it", "[load_shares]") {
  const auto margins_of = [](double weight, bool is_unloaded) {
    LoadProblem<double> problem = problem_of(2, {1, 0, -1, 0, 0, 1, 0, 1}, {0, 0, weight, 0});
    add_contact(problem, 0);
    add_contact(problem, 1);
    problem.is_unloaded = [is_unloaded](std::size_t) { return is_unloaded; };
    add_limited(problem, {2}, 0, {{0, 0.5}});
    add_limited(problem, {3}, 0, {{1, 0.5}});
    return LoadShares<double>(problem).margins();
  };
  const auto falls = margins_of(2, true);
  CHECK(*falls[0] > 0);
  CHECK(std::abs(*falls[2] + 1) < 1e-14);
  CHECK(*margins_of(2, false)[2] > 0);
  for (const auto& margin : margins_of(0, true)) CHECK(*margin > 0);
}

TEST_CASE("Reactions that are unique, or that forces contain, are left to their own guards", "[load_shares]") {
  LoadProblem<double> unique = problem_of(2, {1, 0, 0.5, 1}, {1, 2});
  add_contact(unique, 0);
  add_limited(unique, {1}, 1);
  for (const auto& margin : LoadShares<double>(unique).margins()) CHECK_FALSE(margin);
  LoadProblem<double> of_force = problem_of(1, {1, 1}, {1, 2});
  add_contact(of_force, 0);
  add_contact(of_force, 1);
  of_force.is_fixed[0] = 1;
  for (const auto& margin : LoadShares<double>(of_force).margins()) CHECK_FALSE(margin);
}
