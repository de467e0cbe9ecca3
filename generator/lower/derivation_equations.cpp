#include "lower/derivation_sections.hpp"

namespace gaussgen::lower {

using nonholonomic::ConstraintIndex;
using nonholonomic::DependentIndex;
using nonholonomic::IndependentIndex;
using nonholonomic::PaperSystem;
using symbolic::FreeIndex;
using symbolic::FullIndex;
using symbolic::HeldIndex;

namespace {

class EquationSections {
 public:
  EquationSections(const PaperSystem& paper, FormulaWriter& write)
      : paper_(paper), chart_(paper.chart()), write_(write) {}

  Section constraints() {
    Section section{
        "Nonholonomic constraints",
        "(3.1), (3.3)",
        "Each constraint, its coefficients before the accelerations, and what is left of its time "
        "derivative. Coefficients that are not shown vanish.",
        {"\\dot\\varphi_\\mu = \\beta_{\\mu A}\\, \\ddot y^A + \\Theta_\\mu, \\qquad b_{\\mu\\alpha} = "
         "\\beta_{\\mu\\alpha}, "
         "\\qquad b_\\mu{}^i = (\\beta_{\\mu j} - \\beta_{\\mu\\alpha}\\, g^{\\alpha\\beta} g_{\\beta j})\\, E^{ji}"},
        {},
        {}};
    for (const ConstraintIndex mu : paper_.rows.indices()) {
      section.items.push_back({"\\varphi_{" + number(mu) + "}", "phi_" + number(mu), paper_.rows.names[mu.value]});
      section.formulas.push_back(write_({"\\varphi", {number(mu)}, {}}, paper_.rows.phi[mu]));
      for (const FullIndex A : chart_.all())
        add({"\\beta", {number(mu), chart_[A].label}, {}}, paper_.rows.beta[mu][A], section);
      add({"\\Theta", {number(mu)}, {}}, paper_.rows.beta_drift[mu], section);
      for (const HeldIndex i : chart_.held())
        add({"b", {number(mu)}, {chart_[i].label}}, paper_.rows.b_x[mu][i], section);
    }
    return section;
  }

  Section elimination() {
    Section section{
        "Elimination",
        "(3.6)",
        "Dependent accelerations through the others. Both coefficients carry a minus, which the paper "
        "leaves out in print. Coefficients that are not shown vanish.",
        {"\\delta a^\\mu = c_p^\\mu\\, \\delta a^p + b^{\\mu i}\\, \\delta a_i, \\qquad "
         "c_p^\\mu = -(b^{-1})^{\\mu\\rho}\\, b_{\\rho p}, \\qquad b^{\\mu i} = -(b^{-1})^{\\mu\\rho}\\, b_\\rho{}^i"},
        {},
        {}};
    for (const DependentIndex mu : paper_.partition.dependent.indices()) {
      for (const IndependentIndex p : paper_.partition.independent.indices()) {
        add({"c", {label(p)}, {label(mu)}}, paper_.elimination.c_dep[mu][p], section);
      }
      for (const HeldIndex i : chart_.held()) {
        add({"b", {}, {label(mu), chart_[i].label}}, paper_.elimination.b_x_up[mu][i], section);
      }
    }
    return section;
  }

  Section motion() {
    const bool is_holonomic = paper_.rows.size() == 0;
    Section section{
        "Equations of motion",
        is_holonomic ? "(1.15)" : "(3.7)",
        is_holonomic ? "With the held coordinates at their values."
                     : "With the held coordinates at their values. The constraints themselves complete them.",
        {is_holonomic ? "\\frac{\\partial Z}{\\partial a^\\alpha} = A_\\alpha - Q_\\alpha = 0"
                      : "\\frac{\\partial Z}{\\partial a^p} + c_p^\\mu \\frac{\\partial Z}{\\partial a^\\mu} = "
                        "A_p - Q_p + c_p^\\mu (A_\\mu - Q_\\mu) = 0"},
        {},
        {}};
    for (const IndependentIndex p : paper_.partition.independent.indices()) {
      section.formulas.push_back(write_.equation(label(p), paper_.motion[p]));
    }
    for (const ConstraintIndex mu : paper_.rows.indices()) {
      section.formulas.push_back(write_.equation(paper_.rows.names[mu.value], paper_.rows.phi[mu]));
    }
    return section;
  }

  Section multipliers() {
    Section section{"Multipliers",
                    "(3.4)",
                    "Reactions of the nonholonomic constraints.",
                    {"\\lambda_\\rho = (A_\\mu - Q_\\mu)\\,(b^{-1})^{\\mu\\rho}"},
                    {},
                    {}};
    for (const ConstraintIndex mu : paper_.rows.indices()) {
      section.formulas.push_back(write_.held({"\\lambda", {number(mu)}, {}}, paper_.lambda[mu]));
    }
    return section;
  }

  Section reactions() {
    Section section{"Reactions of the held coordinates",
                    "(3.8)",
                    "The first is how they are computed, the second what (3.8) says; they agree by "
                    "$R^i = E^{ij} R_j$.",
                    {"R_j = A_j - Q_j - \\lambda_\\mu\\, \\beta_{\\mu j}",
                     "R^i = E^{ij} (a_j - F_j) + b^{\\mu i} (A_\\mu - Q_\\mu)"},
                    {},
                    {}};
    for (const HeldIndex i : chart_.held()) {
      section.formulas.push_back(write_.held({"R", {chart_[i].label}, {}}, paper_.R_x[i]));
    }
    return section;
  }

 private:
  static std::string number(ConstraintIndex mu) { return std::to_string(mu.value + 1); }
  const std::string& label(DependentIndex mu) const { return chart_[paper_.partition.dependent[mu]].label; }
  const std::string& label(IndependentIndex p) const { return chart_[paper_.partition.independent[p]].label; }

  void add(const Left& left, const GiNaC::ex& f, Section& section) {
    if (!write_.is_zero(f)) section.formulas.push_back(write_(left, f));
  }

  const PaperSystem& paper_;
  const symbolic::Chart& chart_;
  FormulaWriter& write_;
};

}  // namespace

void add_equation_sections(const PaperSystem& paper, FormulaWriter& write, Derivation& derivation) {
  EquationSections sections(paper, write);
  if (paper.rows.size() > 0) {
    derivation.sections.push_back(sections.constraints());
    derivation.sections.push_back(sections.elimination());
  }
  derivation.sections.push_back(sections.motion());
  if (paper.rows.size() > 0) derivation.sections.push_back(sections.multipliers());
  if (paper.chart().held_count() > 0) derivation.sections.push_back(sections.reactions());
}

}  // namespace gaussgen::lower
