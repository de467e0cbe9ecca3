// Models of any size, as the tree solves them: what comes out satisfies the equations over all speeds, which are formed apart.

#include <cstdio>
#include <memory>

#include "catch_shim.hpp"
#include "evaluate/decimal.hpp"
#include "generic_point.hpp"
#include "mechanics.hpp"
#include "models.hpp"

namespace {

using agreement::State;
using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::Strategy;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;
using gaussgen::evaluate::Scaled;
using gaussgen::ir::Expr;
using gaussgen::ir::SymbolId;

constexpr int k_digits = 50;
constexpr double k_eps = 2.220446049250313e-16;
constexpr double k_most = 64;  ///< eps of the sum of the absolute terms

struct Size {
  std::string name;
  int states;
  std::string folder = "families/";
};

/// Residuals of g a = f + bᵀ λ and b a + drift = 0 where a and λ are numbers.
class Residuals {
 public:
  explicit Residuals(Mechanics& mechanics)
      : mechanics_(mechanics), evaluator_(mechanics.graph, Arithmetic<Scaled<cl_F>>(Arithmetic<cl_F>(k_digits))) {
    const auto& dynamics = mechanics.dynamics;
    for (std::size_t i = 0; i < dynamics.n(); ++i) a_.push_back(unknown("a_", i));
    for (std::size_t i = 0; i < dynamics.l(); ++i) lambda_.push_back(unknown("lambda_", i));
    for (std::size_t i = 0; i < dynamics.n(); ++i) {
      Expr row = -dynamics.f[i];
      for (std::size_t j = 0; j < dynamics.n(); ++j) row += dynamics.g[i][j] * symbol(a_[j]);
      for (std::size_t mu = 0; mu < dynamics.l(); ++mu) row -= dynamics.b[mu][i] * symbol(lambda_[mu]);
      rows_.push_back(row);
    }
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
      Expr row = dynamics.b_drift[mu];
      for (std::size_t j = 0; j < dynamics.n(); ++j) row += dynamics.b[mu][j] * symbol(a_[j]);
      rows_.push_back(row);
    }
    gaussgen::bind_parameters(mechanics, evaluator_);
  }

  /// The largest one, in eps of the sum of its absolute terms.
  double at(const State& state, const std::vector<double>& a, const std::vector<double>& lambda) {
    agreement::bind(mechanics_.symbols, state, evaluator_);
    for (std::size_t i = 0; i < a.size(); ++i) bind(a_[i], a[i]);
    for (std::size_t i = 0; i < lambda.size(); ++i) bind(lambda_[i], lambda[i]);
    double worst = 0;
    for (const Expr& row : rows_) {
      const auto found = evaluator_(row.id());
      REQUIRE(found);
      const double scale = gaussgen::evaluate::to_double(found->scale);
      // A row that nothing but its own zero enters.
      if (scale < 1e-20) continue;
      worst = std::max(worst, gaussgen::evaluate::to_double(cln::abs(found->value)) / scale / k_eps);
    }
    return worst;
  }

 private:
  SymbolId unknown(const char* name, std::size_t i) {
    return mechanics_.graph.declare(gaussgen::ir::SymbolClass::opaque, name + std::to_string(i));
  }
  Expr symbol(SymbolId id) { return mechanics_.expressions.symbol(id); }
  void bind(SymbolId symbol, double value) {
    evaluator_.bind(symbol, evaluator_.arithmetic().input(Arithmetic<cl_F>(k_digits).number(value)));
  }

  Mechanics& mechanics_;
  Evaluator<Scaled<cl_F>> evaluator_;
  std::vector<SymbolId> a_, lambda_;
  std::vector<Expr> rows_;
};

std::vector<double> values(Evaluator<double>& evaluator, const gaussgen::strategy::Vector& expressions) {
  std::vector<double> result;
  for (const Expr e : expressions) result.push_back(evaluator(e.id()).value());
  return result;
}

double worst_residual(const Size& size, bool fold) {
  const gaussgen::model::Model model = agreement::load(size.folder + size.name);
  Mechanics mechanics(model, {fold, Strategy::tree});
  INFO(mechanics.no_tree);
  REQUIRE(mechanics.no_tree.empty());
  REQUIRE_FALSE(mechanics.solution.is_of_metric);
  Residuals residuals(mechanics);
  Evaluator<double> evaluator(mechanics.graph, Arithmetic<double>());
  gaussgen::bind_parameters(mechanics, evaluator);
  agreement::RandomStates states(mechanics.symbols, 20261123);
  double worst = 0;
  for (int i = 0; i < size.states; ++i) {
    const State state = states.next();
    agreement::bind(mechanics.symbols, state, evaluator);
    CHECK(evaluator(mechanics.solution.singular_mass_matrix.id()).value() == 0);
    worst = std::max(worst, residuals.at(state, values(evaluator, mechanics.solution.accelerations),
                                         values(evaluator, mechanics.solution.multipliers)));
  }
  return worst;
}

TEST_CASE("accelerations and multipliers of trees satisfy the equations over all speeds to 64 eps of their terms") {
  const std::vector<Size> sizes{{"planar_chain_relative", 100},
                                {"planar_chain_absolute", 100},
                                {"planar_chain_maximal", 50},
                                {"planar_pendulum", 100},
                                {"spatial_chain", 100},
                                {"tree", 50},
                                {"floating_chain", 50},
                                {"n_four_bar", 100},
                                {"road_train", 50},
                                {"balls_in_cylinder_euler", 50},
                                {"quadruped", 10},
                                {"uneven_bars", 100, "../tests/agreement/"},
                                {"slanted_arm", 10, "../tests/agreement/"},
                                {"loops_on_arm", 30, "../tests/agreement/"}};
  std::printf("%-26s %12s %12s\n", "model", "residual/eps", "folded");
  for (const Size& size : sizes) {
    INFO(size.name);
    const double plain = worst_residual(size, false), folded = worst_residual(size, true);
    std::printf("%-26s %12.3g %12.3g\n", size.name.c_str(), plain, folded);
    CHECK(plain <= k_most);
    CHECK(folded <= k_most);
  }
}

}  // namespace
