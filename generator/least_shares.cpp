#include "least_shares.hpp"

#include <algorithm>

#include "strategy/inner.hpp"
#include "usual_rank.hpp"

namespace gaussgen {

using ir::Expr;
using strategy::Matrix;
using strategy::Vector;

namespace {

/// As if constraints that follow from those of `base` were not there: no pivot of theirs can be taken for more than rounding.
Vector multipliers_of(Mechanics& mechanics, const std::vector<std::size_t>& base) {
  const strategy::Dynamics& all = mechanics.dynamics;
  strategy::Dynamics some = all;
  some.names.prefix = "base_";
  some.constraints.clear();
  some.b.clear();
  some.b_drift.clear();
  for (const std::size_t mu : base) {
    some.constraints.push_back(all.constraints[mu]);
    some.b.push_back(all.b[mu]);
    some.b_drift.push_back(all.b_drift[mu]);
  }
  const strategy::Solution solution = solved_again(mechanics, some, mechanics.steps);
  Vector result(all.l(), mechanics.expressions.number(0));
  for (std::size_t k = 0; k < base.size(); ++k) result[base[k]] = solution.multipliers[k];
  return result;
}

class LeastShares {
 public:
  LeastShares(Mechanics& mechanics, const std::vector<std::size_t>& base)
      : dynamics_(mechanics.dynamics),
        graph_(mechanics.graph),
        steps_(mechanics.steps),
        base_(base),
        inverse_inertias_(strategy::inertias(dynamics_)) {
    steps_.begin("constraints that follow from each other share their load: least multipliers (theory.md, section 10)");
    // What has no inertia has no part in lengths, unless it is all there is.
    for (Expr& inertia : inverse_inertias_) inertia = inertia.is_zero() ? number(1) : ir::pow(inertia, -1);
    find_unloaded(mechanics.epsilon());
  }

  // λ - N (Nᵀ W N)⁻¹ Nᵀ W λ, with W of squares of lengths.
  Vector operator()(Vector lambda, Expr epsilon) const {
    const Matrix weighted = of_weights();
    Matrix together;
    Vector right;
    std::vector<std::string> labels;
    for (std::size_t k = 0; k < unloaded_.size(); ++k) {
      together.emplace_back();
      for (const Vector& other : unloaded_) together.back().push_back(product(weighted[k], other));
      right.push_back(product(weighted[k], lambda));
      labels.push_back(dynamics_.constraints[rest_[k]]);
    }
    const strategy::Ldl factors(together, labels, "shares", epsilon, steps_);
    const Vector parts = factors.solve(right, "beside_least", steps_);
    for (std::size_t mu = 0; mu < lambda.size(); ++mu) {
      for (std::size_t k = 0; k < parts.size(); ++k) lambda[mu] -= unloaded_[k][mu] * parts[k];
      lambda[mu] = steps_.name(lambda[mu], "least_lambda_" + dynamics_.constraints[mu]);
    }
    return lambda;
  }

 private:
  // A row that follows from the base is Σ c_k b_k: then 1 of it and -c_k of these do nothing together.
  void find_unloaded(Expr epsilon) {
    Matrix among;
    std::vector<std::string> labels;
    for (const std::size_t mu : base_) {
      among.emplace_back();
      for (const std::size_t nu : base_) among.back().push_back(product_of_rows(mu, nu));
      labels.push_back(dynamics_.constraints[mu]);
    }
    const strategy::Ldl factors(among, labels, "base", epsilon, steps_);
    for (std::size_t mu = 0; mu < dynamics_.l(); ++mu) {
      if (std::binary_search(base_.begin(), base_.end(), mu)) continue;
      Vector along, unloaded(dynamics_.l(), number(0));
      for (const std::size_t nu : base_) along.push_back(product_of_rows(mu, nu));
      const Vector parts = factors.solve(along, "follows_" + dynamics_.constraints[mu], steps_);
      for (std::size_t k = 0; k < base_.size(); ++k) unloaded[base_[k]] = -parts[k];
      unloaded[mu] = number(1);
      rest_.push_back(mu);
      unloaded_.push_back(std::move(unloaded));
    }
  }

  Matrix of_weights() const {
    Matrix weighted = unloaded_;
    for (Vector& one : weighted) {
      for (std::size_t mu = 0; mu < one.size(); ++mu) one[mu] = one[mu] * product_of_rows(mu, mu);
    }
    return weighted;
  }

  Expr product_of_rows(std::size_t mu, std::size_t nu) const {
    Vector weighted = dynamics_.b[mu];
    for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i] = weighted[i] * inverse_inertias_[i];
    return product(weighted, dynamics_.b[nu]);
  }

  Expr product(const Vector& a, const Vector& b) const { return strategy::inner(graph_, a, b); }
  Expr number(int value) const { return {graph_, graph_.constant(value)}; }

  const strategy::Dynamics& dynamics_;
  ir::Graph& graph_;
  strategy::Steps& steps_;
  std::vector<std::size_t> base_, rest_;  ///< constraints
  Vector inverse_inertias_;
  Matrix unloaded_;  ///< multipliers that do nothing together, for each of `rest_`
};

}  // namespace

Vector shared_multipliers(Mechanics& mechanics) {
  const std::size_t l = mechanics.dynamics.l();
  if (l < 2 || mechanics.dynamics.n() == 0 || usual_rank(mechanics) == l) return mechanics.solution.multipliers;
  std::vector<std::size_t> base = usual_base(mechanics);
  std::sort(base.begin(), base.end());
  return LeastShares(mechanics, base)(multipliers_of(mechanics, base), mechanics.epsilon());
}

}  // namespace gaussgen
