#include "gauss/connection.hpp"

#include "symbolic/rational.hpp"

namespace gaussgen::gauss {

namespace {

/// ∂_C G_AB, each derivative taken once.
class MetricDerivatives {
 public:
  MetricDerivatives(const KineticForm& form, const Chart& chart) {
    for (const FullIndex C : chart.all()) {
      auto table = symbolic::zero_table<FullIndex, FullIndex>(chart.full_count(), chart.full_count());
      for (const FullIndex A : chart.all()) {
        for (const FullIndex B : chart.all()) {
          table[A][B] = B < A ? table[B][A] : chart.at_attitude(form.G[A][B].diff(chart[C].y));
        }
      }
      by_.push_back(std::move(table));
    }
  }

  const ex& operator()(FullIndex C, FullIndex A, FullIndex B) const { return by_[C][A][B]; }

 private:
  support::Indexed<FullIndex, Table<FullIndex, FullIndex>> by_;
};

/// Terms of the bias that come from explicit time: (∂_t G_AB + ∂_B B_A - ∂_A B_B) ẏ^B + ∂_t B_A - ∂_A T_0.
ex rheonomic_terms(const KineticForm& form, const Chart& chart, FullIndex A) {
  GiNaC::exvector terms{form.B[A].diff(chart.time()), -form.T_0.diff(chart[A].y)};
  for (const FullIndex B : chart.all()) {
    const ex factor = form.G[A][B].diff(chart.time()) + form.B[A].diff(chart[B].y) - form.B[B].diff(chart[A].y);
    terms.push_back(factor * chart[B].rate);
  }
  return chart.at_attitude(GiNaC::add(terms));
}

ex christoffel_terms(const Table<FullIndex, FullIndex>& gamma_first, const Chart& chart) {
  GiNaC::exvector terms;
  for (const FullIndex B : chart.all()) {
    for (const FullIndex C : chart.all()) {
      if (C < B || gamma_first[B][C].is_zero()) continue;
      const int both_orders = B == C ? 1 : 2;
      terms.push_back(both_orders * gamma_first[B][C] * chart[B].rate * chart[C].rate);
    }
  }
  return GiNaC::add(terms);
}

}  // namespace

Connection connection(const KineticForm& form, const Chart& chart, symbolic::Bindings& bindings) {
  const MetricDerivatives dG(form, chart);
  const ex half = symbolic::number(support::Rational(1) / 2);
  Connection result;
  for (const FullIndex A : chart.all()) {
    auto gamma = symbolic::zero_table<FullIndex, FullIndex>(chart.full_count(), chart.full_count());
    for (const FullIndex B : chart.all()) {
      for (const FullIndex C : chart.all()) {
        gamma[B][C] = C < B ? gamma[C][B] : half * (dG(C, A, B) + dG(B, A, C) - dG(A, B, C));
      }
    }
    const ex bias = christoffel_terms(gamma, chart) + rheonomic_terms(form, chart, A);
    result.bias.push_back(bindings.define("bias_" + chart[A].label, bias));
    result.gamma_first.push_back(std::move(gamma));
  }
  return result;
}

ex Gamma_q(const Connection& connection, const Metric& metric, const Chart& chart, FreeIndex a, FreeIndex b,
           FreeIndex c) {
  ex sum = 0;
  for (const FreeIndex d : chart.free()) {
    sum += metric.g_up[a][d] * connection.gamma_first[chart.full(d)][chart.full(b)][chart.full(c)];
  }
  return sum;
}

ex Gamma_y(const Connection& connection, const Metric& metric, const Chart& chart, FullIndex A, FullIndex B,
           FullIndex C) {
  ex sum = 0;
  for (const FullIndex D : chart.all()) sum += metric.G_up[A][D] * connection.gamma_first[D][B][C];
  return sum;
}

}  // namespace gaussgen::gauss
