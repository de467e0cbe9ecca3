// The multiplier form (3.4): solves for the accelerations without the constraints, then for what the constraints add.

#include <algorithm>
#include <optional>

#include "strategy/accelerations.hpp"
#include "strategy/bounds.hpp"
#include "strategy/inner.hpp"
#include "strategy/margins.hpp"

namespace gaussgen::strategy {

using ir::Expr;

namespace {

Expr squares_of(const Vector& row) { return inner(row[0].graph(), row, row); }

// Σ g_ii b_i² / Σ b_i²: the mean inertia of what a constraint moves, which the heaviest part of it decides.
Expr inertia_along(const Dynamics& dynamics, std::size_t mu, Expr squares) {
  const Vector& row = dynamics.b[mu];
  Expr weighted(squares.graph(), squares.graph().constant(0));
  for (std::size_t i = 0; i < row.size(); ++i) weighted += dynamics.g[i][i] * pow(row[i], 2);
  return weighted / squares;
}

// Σ g_ii over the speeds in constraint mu; 1 if none of them has inertia.
Expr size_of_metric(const Dynamics& dynamics, std::size_t mu) {
  Expr size(dynamics.g[0][0].graph(), dynamics.g[0][0].graph().constant(0));
  for (std::size_t i = 0; i < dynamics.n(); ++i) {
    if (!dynamics.b[mu][i].is_zero()) size += dynamics.g[i][i];
  }
  return size.is_zero() ? Expr(size.graph(), size.graph().constant(1)) : size;
}

// Σ b_i²/g_ii over the speeds with inertia, whatever the units of speeds; nothing where it may vanish.
std::optional<Expr> response_of_massive(const Dynamics& dynamics, std::size_t mu) {
  const Vector& row = dynamics.b[mu];
  Expr sum(row[0].graph(), row[0].graph().constant(0));
  bool is_positive = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].is_zero() || dynamics.g[i][i].is_zero()) continue;
    sum += pow(row[i], 2) / dynamics.g[i][i];
    is_positive = is_positive || is_number(row[i]);
  }
  return is_positive ? std::optional(sum) : std::nullopt;
}

/// Brings b to the size of g.
Expr weight_of(const Dynamics& dynamics, std::size_t mu) {
  if (const std::optional<Expr> response = response_of_massive(dynamics, mu)) return pow(*response, -1);
  return size_of_metric(dynamics, mu) / squares_of(dynamics.b[mu]);
}

// g + bᵀ w b and f - bᵀ w drift: since b a + drift = 0, the same accelerations and multipliers, but an inverse exists as soon
// as they are determined (Golub & Greif, SIAM J. Sci. Comput. 24, 2003).
Dynamics completed(const Dynamics& dynamics, Steps& steps) {
  Dynamics result = dynamics;
  steps.begin("metric and forces completed by the constraints: g + b^T w b, f - b^T w drift");
  for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
    const Expr weight = steps.name(weight_of(dynamics, mu), dynamics.names.prefix + "w_" + dynamics.constraints[mu]);
    for (std::size_t i = 0; i < dynamics.n(); ++i) {
      const Expr weighted = weight * dynamics.b[mu][i];
      result.f[i] = result.f[i] - weighted * dynamics.b_drift[mu];
      for (std::size_t j = 0; j < dynamics.n(); ++j) {
        result.g[i][j] = result.g[i][j] + weight * (dynamics.b[mu][i] * dynamics.b[mu][j]);
      }
    }
  }
  return result;
}

/// λ and what it does to the accelerations, for a g that has an inverse.
class MultiplierForm {
 public:
  MultiplierForm(const Dynamics& dynamics, Expr epsilon, Steps& steps)
      : dynamics_(dynamics), epsilon_(epsilon), metric_(factorise_metric(steps)), response_(responses(steps)) {
    steps.begin("how the accelerations along the constraints respond: S = b g^-1 b^T");
    schur_.emplace(schur_matrix(steps), dynamics.constraints, dynamics.names.prefix + "S", epsilon, steps,
                   Dependent::drop);
  }

  /// g^-1 f
  Vector unconstrained(const std::string& name, Steps& steps) const { return metric_.solve(dynamics_.f, name, steps); }

  /// -(b a + drift)
  Vector defect(const Vector& a) const {
    Vector result;
    for (std::size_t mu = 0; mu < dynamics_.l(); ++mu) {
      result.push_back(-(inner(epsilon_.graph(), dynamics_.b[mu], a) + dynamics_.b_drift[mu]));
    }
    return result;
  }

  /// λ with S λ = defect
  Vector multipliers(const Vector& defect, const std::string& name, Steps& steps) const {
    return schur_->solve(defect, name, steps);
  }

  /// a + g^-1 bᵀ λ
  Vector moved(const Vector& a, const Vector& lambda, const std::string& name, Steps& steps) const {
    Vector result = a;
    for (std::size_t j = 0; j < result.size(); ++j) {
      for (std::size_t mu = 0; mu < lambda.size(); ++mu) result[j] += response_[mu][j] * lambda[mu];
      result[j] = steps.name(result[j], name + "_" + dynamics_.labels[j]);
    }
    return result;
  }

  // 1/S is the inertia of the lightest thing that a constraint moves. Correcting once leaves an error of eps² times the ratio
  // of the heaviest to it: rounding again, up to here.
  Expr lost_inertia(Steps& steps) const {
    steps.begin("inertia that each constraint moves, against the lightest part of it, 1/S");
    std::vector<Expr> conditions;
    for (std::size_t mu = 0; mu < dynamics_.l(); ++mu) {
      const Expr squares = squares_of(dynamics_.b[mu]);
      const Expr inertia = steps.name(inertia_along(dynamics_, mu, squares), name("inertia", mu));
      conditions.push_back(less(squares, epsilon_ * inertia * schur_diagonal_[mu]));
    }
    return any(epsilon_.graph(), conditions);
  }

  Expr singular_metric() const { return metric_.singular(); }

  // Where cubes of S or of b b leave the range of numbers, products of a factorisation do, too.
  Expr dependent_rows() const {
    ir::Graph& graph = epsilon_.graph();
    const Expr zero(graph, graph.constant(0));
    Margins margins(graph);
    for (std::size_t mu = 0; mu < dynamics_.l(); ++mu) {
      margins.require(pow(squares_of(dynamics_.b[mu]).kept_whole(name("squares", mu)), 3), zero);
      margins.require(pow(schur_diagonal_[mu].kept_whole(name("S", mu)), 3), zero);
    }
    return any(graph, {schur_->dependent(dynamics_.least_response),
                       margins.violated("least_" + dynamics_.names.prefix + "cube")});
  }

  std::vector<std::string> vanishing_rows() const { return schur_->vanishing(); }

 private:
  std::string name(const char* quantity, std::size_t mu) const {
    return dynamics_.names.prefix + quantity + "_" + dynamics_.constraints[mu];
  }

  Ldl factorise_metric(Steps& steps) const {
    steps.begin("g = L D L^T");
    return {dynamics_.g, dynamics_.labels, dynamics_.names.prefix + "g", epsilon_, steps};
  }

  Matrix responses(Steps& steps) const {
    steps.begin("what one unit of each multiplier adds: g^-1 b^T");
    Matrix result;
    for (std::size_t mu = 0; mu < dynamics_.l(); ++mu) {
      result.push_back(metric_.solve(dynamics_.b[mu], name("response", mu), steps));
    }
    return result;
  }

  Matrix schur_matrix(Steps& steps) {
    const std::size_t l = dynamics_.l();
    Matrix S(l, Vector(l, epsilon_));
    for (std::size_t i = 0; i < l; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const Expr entry = inner(epsilon_.graph(), dynamics_.b[i], response_[j]);
        S[i][j] = S[j][i] = steps.name_varying(entry, name("S", j) + "_" + dynamics_.constraints[i]);
      }
      schur_diagonal_.push_back(S[i][i]);
    }
    return S;
  }

  const Dynamics& dynamics_;
  Expr epsilon_;
  Ldl metric_;
  Matrix response_;
  Vector schur_diagonal_;
  std::optional<Ldl> schur_;
};

}  // namespace

Solution solve_with_multipliers(const Dynamics& given, Expr epsilon, Steps& steps) {
  std::vector<std::string> undetermined;
  for (const std::size_t row : given.dependent_rows(given.g)) undetermined.push_back(given.labels[row]);
  const Dynamics dynamics = undetermined.empty() ? given : completed(given, steps);
  MultiplierForm form(dynamics, epsilon, steps);
  const std::string acceleration = dynamics.names.prefix + dynamics.names.acceleration;
  const std::string multiplier = dynamics.names.prefix + dynamics.names.multiplier;
  const std::string rough = dynamics.names.prefix + "rough_";

  steps.begin("accelerations without the nonholonomic constraints");
  Vector a = form.unconstrained(acceleration + "_free", steps);
  steps.begin("multipliers from b g^-1 b^T lambda = -(b a_free + drift), accelerations (3.4)");
  Vector lambda = form.multipliers(form.defect(a), rough + dynamics.names.multiplier, steps);
  a = form.moved(a, lambda, rough + dynamics.names.acceleration, steps);

  // Accelerations without constraints may be large where something is light, and leave their rounding.
  steps.begin("corrected once, by what rounding has left of b a + drift");
  const Vector change = form.multipliers(form.defect(a), dynamics.names.prefix + "correction", steps);
  a = form.moved(a, change, acceleration, steps);
  for (std::size_t mu = 0; mu < lambda.size(); ++mu) {
    lambda[mu] = steps.name(lambda[mu] + change[mu], multiplier + "_" + dynamics.constraints[mu]);
  }
  // Without forces there are no large accelerations to begin with.
  const bool is_forced = std::any_of(given.f.begin(), given.f.end(), [](Expr f) { return !f.is_zero(); });
  const Expr is_lost = is_forced ? form.lost_inertia(steps) : Expr(epsilon.graph(), epsilon.graph().constant(0));
  return {a,
          lambda,
          any(epsilon.graph(), {form.singular_metric(), is_lost}),
          form.dependent_rows(),
          "multiplier form (3.4): no choice of dependent speeds is provably safe in every configuration",
          undetermined,
          form.vanishing_rows(),
          {}};
}

}  // namespace gaussgen::strategy
