// Gauss's principle itself: Z is least at the accelerations found, and ideal reactions do no virtual work.

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "catch_shim.hpp"
#include "model_files.hpp"
#include "models.hpp"
#include "strategy/compulsion.hpp"

namespace {

using cln::cl_F;
using gaussgen::Mechanics;
using gaussgen::evaluate::Arithmetic;
using gaussgen::evaluate::Evaluator;
using gaussgen::evaluate::Scaled;

constexpr int k_variations = 1000;
constexpr int k_states = 20;
constexpr double k_eps = 2.220446049250313e-16;

using Number = long double;

/// Z at any accelerations of one state.
class Compulsion {
 public:
  explicit Compulsion(Mechanics& mechanics) : mechanics_(mechanics), evaluator_(mechanics.graph, Arithmetic<Number>()) {
    gaussgen::strategy::Vector candidate;
    for (const auto& speed : mechanics.symbols.speeds)
      candidate.push_back(mechanics.expressions.symbol(speed.acceleration));
    gaussgen::strategy::Steps steps;
    Z_ = gaussgen::strategy::compulsion(mechanics.dynamics, candidate, mechanics.epsilon(), steps)->Z.id();
    gaussgen::bind_parameters(mechanics, evaluator_);
  }

  Evaluator<Number>& evaluator() { return evaluator_; }

  Number operator()(const std::vector<Number>& a) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      evaluator_.bind(mechanics_.symbols.speeds.values()[i].acceleration, a[i]);
    }
    return *evaluator_(Z_);
  }

  std::vector<Number> solution() { return values(mechanics_.solution.accelerations); }

  std::vector<Number> values(const gaussgen::strategy::Vector& nodes) {
    std::vector<Number> result;
    for (const auto node : nodes) result.push_back(*evaluator_(node.id()));
    return result;
  }

 private:
  Mechanics& mechanics_;
  Evaluator<Number> evaluator_;
  gaussgen::ir::NodeId Z_;
};

void bind(const gaussgen::kinematics::Symbols& symbols, const agreement::State& state, Evaluator<Number>& evaluator) {
  evaluator.bind(symbols.time, state.time);
  for (const auto i : symbols.configuration.indices())
    evaluator.bind(symbols.configuration[i].symbol, state.configuration[i.value]);
  for (const auto i : symbols.speeds.indices()) evaluator.bind(symbols.speeds[i].symbol, state.speeds[i.value]);
}

/// Columns span the accelerations that the constraints leave free: b δ = 0.
Eigen::MatrixXd admissible(Compulsion& compulsion, const gaussgen::strategy::Dynamics& dynamics) {
  const auto n = static_cast<Eigen::Index>(dynamics.n());
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(1, static_cast<Eigen::Index>(dynamics.l())), n);
  for (std::size_t i = 0; i < dynamics.l(); ++i) {
    const auto row = compulsion.values(dynamics.b[i]);
    for (std::size_t j = 0; j < row.size(); ++j)
      b(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = static_cast<double>(row[j]);
  }
  const Eigen::MatrixXd kernel = Eigen::FullPivLU<Eigen::MatrixXd>(b).kernel();
  // Where nothing is free the kernel is one column of zeros, along which every law holds and none is tested.
  REQUIRE(kernel.norm() > 0);
  return kernel;
}

/// What moving by δ changes
struct Move {
  Number half_square = 0;  ///< half of δᵀ g δ
  Number size = 0;         ///< |δ|ᵀ |g| |a|: what a + δ is rounded at, and cancels in the rise of Z
};

Move move(Compulsion& compulsion, const gaussgen::strategy::Dynamics& dynamics, const std::vector<Number>& a,
          const Eigen::VectorXd& delta) {
  Move result;
  for (std::size_t i = 0; i < dynamics.n(); ++i) {
    const auto row = compulsion.values(dynamics.g[i]);
    const auto along = static_cast<Number>(delta[static_cast<Eigen::Index>(i)]);
    for (std::size_t j = 0; j < row.size(); ++j) {
      result.half_square += along * row[j] * static_cast<Number>(delta[static_cast<Eigen::Index>(j)]) / 2;
      result.size += std::fabs(along * row[j] * a[j]);
    }
  }
  return result;
}

}  // namespace

TEST_CASE("Z is lower than at 1000 random admissible accelerations, by exactly half the square of the variation") {
  for (const std::string& file : agreement::model_files()) {
    INFO(file);
    const auto model = agreement::load(file);
    Mechanics mechanics(model, {});
    Compulsion compulsion(mechanics);
    agreement::RandomStates states(mechanics.symbols, 7);
    for (int s = 0; s < k_states; ++s) {
      bind(mechanics.symbols, states.next(), compulsion.evaluator());
      const std::vector<Number> a = compulsion.solution();
      const Number least = compulsion(a);
      const Eigen::MatrixXd basis = admissible(compulsion, mechanics.dynamics);
      for (int i = 0; i < k_variations / k_states; ++i) {
        Eigen::VectorXd delta = Eigen::VectorXd::Zero(basis.rows());
        for (Eigen::Index j = 0; j < basis.cols(); ++j) delta += states.uniform(-2, 2) * basis.col(j);
        std::vector<Number> varied = a;
        for (std::size_t j = 0; j < a.size(); ++j)
          varied[j] += static_cast<Number>(delta[static_cast<Eigen::Index>(j)]);
        const Number rise = compulsion(varied) - least;
        const auto [expected, size] = move(compulsion, mechanics.dynamics, a, delta);
        // The kernel of b is found in double, so δ leaves it by a few eps of its size; sums of a and δ are of long double.
        const Number slack = 1000 * static_cast<Number>(k_eps) * (least + expected + 1);
        const Number rounding = 64 * std::numeric_limits<Number>::epsilon() * size;
        CHECK(rise > -(slack + rounding));
        CHECK(std::fabs(rise - expected) <= slack * 10 + rounding);
      }
    }
  }
}

TEST_CASE("ideal reactions do no work in admissible variations: |lambda b delta| <= 64 eps S") {
  for (const std::string& file : agreement::model_files()) {
    const auto model = agreement::load(file);
    Mechanics mechanics(model, {});
    // Without constraints on the velocities every variation is admissible: the equations of motion themselves.
    INFO(file);
    Compulsion compulsion(mechanics);
    agreement::RandomStates states(mechanics.symbols, 11);
    for (int s = 0; s < k_states; ++s) {
      bind(mechanics.symbols, states.next(), compulsion.evaluator());
      const auto a = compulsion.values(mechanics.solution.accelerations);
      const auto f = compulsion.values(mechanics.dynamics.f);
      const Eigen::MatrixXd basis = admissible(compulsion, mechanics.dynamics);
      // The reaction as the equations of motion see it, g a - f, not as λ b: then λ is not used to test itself.
      for (Eigen::Index j = 0; j < basis.cols(); ++j) {
        Number work = 0;
        Number scale = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
          const auto row = compulsion.values(mechanics.dynamics.g[i]);
          Number reaction = -f[i];
          Number size = std::fabs(f[i]);
          for (std::size_t k = 0; k < a.size(); ++k) {
            reaction += row[k] * a[k];
            size += std::fabs(row[k] * a[k]);
          }
          const auto delta = static_cast<Number>(basis(static_cast<Eigen::Index>(i), j));
          work += reaction * delta;
          scale += size * std::fabs(delta);
        }
        CHECK(std::fabs(work) <= 64 * static_cast<Number>(k_eps) * scale);
      }
    }
  }
}
