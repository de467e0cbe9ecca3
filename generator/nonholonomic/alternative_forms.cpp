#include "nonholonomic/alternative_forms.hpp"

#include "gauss/appell.hpp"

namespace gaussgen::nonholonomic {

namespace {

class Multipliers {
 public:
  Multipliers(const ConstraintRows& rows, gauss::System& system) : rows_(rows), system_(system), chart_(*system.chart) {
    for (const FreeIndex a : chart_.free()) {
      ex sum = system.connection.bias[chart_.full(a)] - system.Q[chart_.full(a)];
      for (const HeldIndex i : chart_.held()) sum += system.metric.G_qx[a][i] * chart_[i].acceleration;
      f_.push_back(sum);
    }
  }

  MultiplierForm solve() {
    const symbolic::Matrix inverse = system_.bindings.invert("gram_up", rows_.names, rows_.names, gram(), true);
    MultiplierForm form;
    for (const ConstraintIndex mu : rows_.indices()) {
      ex sum = 0;
      for (const ConstraintIndex nu : rows_.indices()) sum += inverse[mu.value][nu.value] * required(nu);
      form.lambda.push_back(system_.bindings.define("multiplier_" + rows_.names[mu.value], sum));
    }
    for (const FreeIndex a : chart_.free()) {
      ex sum = 0;
      for (const FreeIndex b : chart_.free()) sum += system_.metric.g_up[a][b] * driving(b, form.lambda);
      form.accelerations.push_back(sum);
    }
    return form;
  }

 private:
  const ex& beta(ConstraintIndex mu, FreeIndex a) const { return rows_.beta[mu][chart_.full(a)]; }

  /// β_μα g^αβ v_β
  template <class F>
  ex along(ConstraintIndex mu, F v) const {
    ex sum = 0;
    for (const FreeIndex a : chart_.free()) {
      for (const FreeIndex b : chart_.free()) sum += beta(mu, a) * system_.metric.g_up[a][b] * v(b);
    }
    return sum;
  }

  symbolic::Matrix gram() const {
    symbolic::Matrix matrix;
    for (const ConstraintIndex mu : rows_.indices()) {
      std::vector<ex> row;
      for (const ConstraintIndex nu : rows_.indices()) {
        row.push_back(nu < mu ? matrix[nu.value][mu.value] : along(mu, [&](FreeIndex b) { return beta(nu, b); }));
      }
      matrix.push_back(std::move(row));
    }
    return matrix;
  }

  ex required(ConstraintIndex mu) const {
    ex sum = along(mu, [&](FreeIndex b) { return f_[b]; }) - rows_.beta_drift[mu];
    for (const HeldIndex i : chart_.held()) sum -= rows_.beta[mu][chart_.full(i)] * chart_[i].acceleration;
    return sum;
  }

  ex driving(FreeIndex a, const Row<ConstraintIndex>& lambda) const {
    ex sum = -f_[a];
    for (const ConstraintIndex mu : rows_.indices()) sum += lambda[mu] * beta(mu, a);
    return sum;
  }

  const ConstraintRows& rows_;
  gauss::System& system_;
  const Chart& chart_;
  Row<FreeIndex> f_;
};

}  // namespace

MultiplierForm multiplier_form(const ConstraintRows& rows, gauss::System& system) {
  return Multipliers(rows, system).solve();
}

Row<IndependentIndex> appell_residual(const PaperSystem& paper) {
  const Chart& chart = paper.chart();
  const ex S = gauss::gibbs_appell(paper.system.bodies, chart);
  const auto unbalanced = [&](FreeIndex a) -> ex {
    return S.diff(chart[a].acceleration) - paper.system.Q[chart.full(a)];
  };
  Row<IndependentIndex> residual;
  for (const IndependentIndex p : paper.partition.independent.indices()) {
    ex sum = unbalanced(paper.partition.independent[p]);
    for (const DependentIndex mu : paper.partition.dependent.indices()) {
      sum += paper.elimination.c_dep[mu][p] * unbalanced(paper.partition.dependent[mu]);
    }
    residual.push_back(sum);
  }
  return residual;
}

}  // namespace gaussgen::nonholonomic
