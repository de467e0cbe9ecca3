#include "nonholonomic/reduction.hpp"

namespace gaussgen::nonholonomic {

namespace {

class Reduction {
 public:
  explicit Reduction(PaperSystem& paper) : paper_(paper), chart_(paper.chart()), partition_(paper.partition) {}

  void run() {
    for (const IndependentIndex p : partition_.independent.indices()) paper_.motion.push_back(projected(p));
    paper_.accelerations = solved();
    for (const ConstraintIndex rho : paper_.rows.indices()) paper_.lambda.push_back(multiplier(rho));
    for (const HeldIndex i : chart_.held()) {
      paper_.R_x.push_back(covariant_reaction(i));
      paper_.R_x_up.push_back(dual_reaction(i));
    }
  }

 private:
  /// A_α - Q_α = ∂Z/∂a^α at a motion: g_αβ (a^β - Q^β) with the index lowered.
  ex unbalanced(FullIndex A) const { return paper_.system.invariant.A[A] - paper_.system.Q[A]; }
  ex unbalanced(FreeIndex a) const { return unbalanced(chart_.full(a)); }

  /// v_p + c_p^μ v_μ
  template <class F>
  ex project(IndependentIndex p, F v) const {
    ex sum = v(partition_.independent[p]);
    for (const DependentIndex mu : partition_.dependent.indices()) {
      sum += paper_.elimination.c_dep[mu][p] * v(partition_.dependent[mu]);
    }
    return sum;
  }

  ex projected(IndependentIndex p) const {
    return project(p, [&](FreeIndex a) { return unbalanced(a); });
  }

  /// (g C)_αp
  ex g_times_C(FreeIndex a, IndependentIndex p) const {
    return project(p, [&](FreeIndex b) { return paper_.system.metric.G_qq[a][b]; });
  }

  /// What A_α - Q_α is with the independent accelerations zero.
  ex remainder(FreeIndex a) const {
    const gauss::System& system = paper_.system;
    ex sum = system.connection.bias[chart_.full(a)] - system.Q[chart_.full(a)];
    for (const DependentIndex mu : partition_.dependent.indices()) {
      sum += system.metric.G_qq[a][partition_.dependent[mu]] * paper_.elimination.drift[mu];
    }
    for (const HeldIndex i : chart_.held()) sum += system.metric.G_qx[a][i] * chart_[i].acceleration;
    return sum;
  }

  symbolic::Matrix reduced_inverse() const {
    symbolic::Matrix reduced;
    std::vector<std::string> labels;
    for (const IndependentIndex p : partition_.independent.indices()) {
      std::vector<ex> row;
      for (const IndependentIndex r : partition_.independent.indices()) {
        row.push_back(r < p ? reduced[r.value][p.value] : project(p, [&](FreeIndex a) { return g_times_C(a, r); }));
      }
      reduced.push_back(std::move(row));
      labels.push_back(chart_[partition_.independent[p]].label);
    }
    return paper_.system.bindings.invert("reduced_up", labels, labels, reduced, true);
  }

  Row<FreeIndex> solved() const {
    const symbolic::Matrix inverse = reduced_inverse();
    Row<IndependentIndex> right;
    for (const IndependentIndex p : partition_.independent.indices()) {
      right.push_back(-project(p, [&](FreeIndex a) { return remainder(a); }));
    }
    Row<FreeIndex> result(chart_.free_count(), ex(0));
    for (const IndependentIndex p : right.indices()) {
      ex& acceleration = result[partition_.independent[p]];
      for (const IndependentIndex r : right.indices()) acceleration += inverse[p.value][r.value] * right[r];
    }
    for (const DependentIndex mu : partition_.dependent.indices()) {
      ex& acceleration = result[partition_.dependent[mu]];
      acceleration = paper_.elimination.drift[mu];
      for (const IndependentIndex p : right.indices()) {
        acceleration += paper_.elimination.c_dep[mu][p] * chart_[partition_.independent[p]].acceleration;
      }
    }
    return result;
  }

  ex multiplier(ConstraintIndex rho) const {
    ex sum = 0;
    for (const DependentIndex mu : partition_.dependent.indices()) {
      sum += unbalanced(partition_.dependent[mu]) * paper_.elimination.b_inv[mu][rho];
    }
    return paper_.system.bindings.define("lambda_" + paper_.rows.names[rho.value], sum);
  }

  ex covariant_reaction(HeldIndex i) const {
    ex sum = unbalanced(chart_.full(i));
    for (const ConstraintIndex mu : paper_.rows.indices()) {
      sum -= paper_.lambda[mu] * paper_.rows.beta[mu][chart_.full(i)];
    }
    return sum;
  }

  /// ∂Z_w/∂a_i of (1.18), which is э^ij (a_j - F_j), and the term that nonholonomic constraints add (3.8).
  ex dual_reaction(HeldIndex i) const {
    const gauss::System& system = paper_.system;
    ex sum = at_motion(system.compulsion.dZ_w_da_x[i], system.compulsion, system.invariant);
    for (const DependentIndex mu : partition_.dependent.indices()) {
      sum += paper_.elimination.b_x_up[mu][i] * unbalanced(partition_.dependent[mu]);
    }
    return sum;
  }

  PaperSystem& paper_;
  const Chart& chart_;
  const Partition& partition_;
};

}  // namespace

std::optional<PaperSystem> build_paper_system(const model::Model& model) {
  PaperSystem paper{gauss::build_system(model), {}, {}, {}, {}, {}, {}, {}, {}};
  paper.rows = constraint_rows(model, paper.system);
  const std::optional<Partition> partition = choose_partition(model, paper.system, paper.rows);
  if (!partition) return std::nullopt;
  paper.partition = *partition;
  paper.elimination = elimination(paper.rows, paper.partition, paper.system);
  Reduction(paper).run();
  return paper;
}

}  // namespace gaussgen::nonholonomic
