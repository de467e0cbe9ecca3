// Sections 1 and 2 of the paper for a model: coordinates, metric, connection, Gauss's function; then section 3.

#include "lower/derivation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lower/derivation_sections.hpp"
#include "lower/paper_route.hpp"

namespace gaussgen::lower {

using nonholonomic::PaperSystem;
using symbolic::FreeIndex;
using symbolic::FullIndex;
using symbolic::HeldIndex;

namespace {

/// Christoffel symbols beyond this number are left out of the text: they are not needed to follow it.
constexpr std::size_t k_most_symbols = 60;

/// Characters of LaTeX source: two printed lines.
constexpr std::size_t k_longest_term = 300;

class SystemSections {
 public:
  SystemSections(const PaperSystem& paper, FormulaWriter& write)
      : system_(paper.system), chart_(paper.chart()), write_(write) {}

  Section metric_of_free() {
    Section section{"Metric of the free coordinates",
                    "(1.10)",
                    "Entries that are not shown vanish or follow by symmetry.",
                    {"g_{\\alpha\\beta} = \\sum_\\nu m_\\nu\\, \\frac{\\partial r_\\nu}{\\partial q^\\alpha} \\cdot "
                     "\\frac{\\partial r_\\nu}{\\partial q^\\beta}"},
                    {},
                    {}};
    upper_triangle("g", system_.metric.G_qq, chart_.free(), section);
    return section;
  }

  Section metric_of_held() {
    Section section{"Coupling and normal block",
                    "(1.11)",
                    "The coupling of free and held coordinates, and the block of the held ones. The latter is not yet "
                    "the metric of the dual vectors.",
                    {},
                    {},
                    {}};
    for (const FreeIndex a : chart_.free()) {
      for (const HeldIndex i : chart_.held()) add({"g", {label(a), label(i)}, {}}, system_.metric.G_qx[a][i], section);
    }
    upper_triangle("G", system_.metric.G_xx, chart_.held(), section);
    return section;
  }

  Section dual_metric() {
    Section section{"Metric of the dual vectors",
                    "(1.12)",
                    "The Schur complement, written with a Cyrillic letter in the paper; its inverse is the block of "
                    "the inverse of the whole metric.",
                    {"E_{ij} = G_{ij} - g_{i\\alpha}\\, g^{\\alpha\\beta}\\, g_{\\beta j}"},
                    {},
                    {}};
    upper_triangle("E", system_.metric.E_xx, chart_.held(), section);
    for (const HeldIndex i : chart_.held()) {
      for (const HeldIndex j : chart_.held()) {
        if (!(j < i)) add({"E", {}, {label(i), label(j)}}, system_.metric.E_xx_up[i][j], section);
      }
    }
    return section;
  }

  Section christoffel_symbols() {
    Section section{"Christoffel symbols",
                    "",
                    "Those of the induced metric that do not vanish. For an angular velocity the coordinate is a "
                    "rotation about the present attitude, whose rate is that angular velocity.",
                    {"\\Gamma^\\alpha{}_{\\beta\\gamma} = g^{\\alpha\\delta}\\, [\\beta\\gamma, \\delta], \\qquad "
                     "[\\beta\\gamma, \\delta] = \\tfrac{1}{2}\\,(\\partial_\\gamma g_{\\delta\\beta} + "
                     "\\partial_\\beta g_{\\delta\\gamma} - \\partial_\\delta g_{\\beta\\gamma})"},
                    {},
                    {}};
    for (const FreeIndex a : chart_.free()) {
      for (const FreeIndex b : chart_.free()) {
        for (const FreeIndex c : chart_.free()) {
          if (c < b) continue;
          const GiNaC::ex gamma = Gamma_q(system_.connection, system_.metric, chart_, a, b, c);
          add({"\\Gamma", {label(b), label(c)}, {label(a)}}, gamma, section);
        }
      }
    }
    if (section.formulas.size() > k_most_symbols) {
      section.words += fmt::format(" There are {} of them; they are not listed.", section.formulas.size());
      section.formulas.clear();
    }
    if (section.formulas.empty()) section.words += " None is shown here.";
    return section;
  }

  Section accelerations() {
    Section section{"Accelerations and active forces",
                    "",
                    "Covariant components over all coordinates, held ones with $x^i$ free.",
                    {"a^\\alpha = g^{\\alpha\\beta} A_\\beta, \\qquad Q^\\alpha = g^{\\alpha\\beta} Q_\\beta"},
                    {},
                    {}};
    if (chart_.held_count() > 0) {
      section.general.emplace_back(
          "a_i = A_i - g_{i\\alpha}\\, g^{\\alpha\\beta} A_\\beta, \\qquad "
          "F_i = Q_i - g_{i\\alpha}\\, g^{\\alpha\\beta} Q_\\beta");
    }
    for (const FullIndex A : chart_.all())
      section.formulas.push_back(write_({"A", {label(A)}, {}}, system_.invariant.A[A]));
    for (const FullIndex A : chart_.all()) section.formulas.push_back(write_({"Q", {label(A)}, {}}, system_.Q[A]));
    return section;
  }

  Section gauss_function() {
    Section section{"Gauss's function",
                    "(1.13)",
                    "It is least among all accelerations that the constraints admit; $R_i$ are the reactions of the "
                    "held coordinates.",
                    {"2Z = g_{\\alpha\\beta}\\,(a^\\alpha - Q^\\alpha)(a^\\beta - Q^\\beta) + "
                     "E^{ij}\\,(a_i - F_i - R_i)(a_j - F_j - R_j)"},
                    {},
                    {}};
    section.formulas.push_back(write_({"Z", {}, {}}, system_.compulsion.Z));
    if (longest_term(section.formulas[0]) > k_longest_term) {
      section.formulas[0] = write_({"Z", {}, {}}, compulsion(formal_forces(), system_.metric, chart_).Z);
    }
    return section;
  }

 private:
  template <class Index>
  std::string label(Index i) const {
    return chart_[i].label;
  }

  static std::size_t longest_term(const Formula& formula) {
    std::size_t longest = 0;
    for (const std::string& term : formula.right) longest = std::max(longest, term.size());
    return longest;
  }

  // Q^α and F_i as symbols: written out over the inverse of a large metric they hide what Z is.
  gauss::InvariantAccelerations formal_forces() const {
    gauss::InvariantAccelerations formal = system_.invariant;
    for (const FreeIndex a : chart_.free()) formal.Q_q_up[a] = GiNaC::realsymbol("Q__up_" + label(a));
    for (const HeldIndex i : chart_.held()) formal.F_x[i] = GiNaC::realsymbol("F__" + label(i));
    return formal;
  }

  void add(const Left& left, const GiNaC::ex& f, Section& section) {
    if (!write_.is_zero(f)) section.formulas.push_back(write_(left, f));
  }

  template <class Index>
  void upper_triangle(const std::string& letter, const symbolic::Table<Index, Index>& table,
                      const std::vector<Index>& indices, Section& section) {
    for (const Index i : indices) {
      for (const Index j : indices) {
        if (!(j < i)) add({letter, {label(i), label(j)}, {}}, table[i][j], section);
      }
    }
  }

  const gauss::System& system_;
  const symbolic::Chart& chart_;
  FormulaWriter& write_;
};

std::string with_unit(const std::string& about, const std::string& unit) {
  return about + (unit.empty() ? "" : (about.empty() ? "[" : " [") + unit + "]");
}

void add_constants(const model::Model& model, const PaperSystem& paper, FormulaWriter& write, Derivation& derivation) {
  if (model.parameters.empty() && model.inputs.empty()) return;
  Section section{
      "Parameters and inputs", "", "What the formulas below hold besides coordinates and time.", {}, {}, {}};
  const auto add = [&](const std::string& name, const std::string& about, const std::string& unit, const char* kind) {
    section.items.push_back({latex_indices({name}), name, with_unit(about.empty() ? kind : about, unit)});
  };
  for (const model::Parameter& parameter : model.parameters) {
    const std::string& name = parameter.name.text;
    add(name, parameter.about, parameter.unit, "parameter");
    const auto formula = paper.chart().formulas().find(name);
    if (formula == paper.chart().formulas().end()) continue;
    section.formulas.push_back(write({latex_indices({name}), {}, {}}, formula->second));
    std::string& plain = section.formulas.back().plain;
    plain.replace(0, plain.find(" = "), name);
  }
  for (const model::Input& input : model.inputs) add(input.name.text, input.about, input.unit, "input");
  derivation.sections.push_back(std::move(section));
}

void add_user_items(const model::Model& model, const PaperSystem& paper, FormulaWriter& write, Derivation& derivation) {
  Section section{
      "Coordinates", "", "Free coordinates $q^\\alpha$, then the held ones with their values $x^i = c^i$.", {}, {}, {}};
  for (const model::Coordinate& coordinate : model.coordinates) {
    const std::string held = coordinate.held_at ? " (held)" : "";
    section.items.push_back(
        {latex_indices({coordinate.name.text}), coordinate.name.text,
         with_unit(coordinate.about.empty() ? "coordinate" : coordinate.about, coordinate.unit) + held});
  }
  for (const model::Orientation& orientation : model.orientations) {
    const char* frame = orientation.axes == model::Axes::space ? "space" : "body";
    for (const model::Name& name : orientation.angular_velocity) {
      section.items.push_back({latex_indices({name.text}), name.text,
                               fmt::format("angular velocity of {}, resolved in {}", orientation.name.text, frame)});
    }
  }
  for (const HeldIndex i : paper.chart().held()) {
    const symbolic::ChartCoordinate& coordinate = paper.chart()[i];
    Formula formula = write({latex_indices({coordinate.label}), {}, {}}, *coordinate.held_at);
    formula.plain.replace(0, formula.plain.find(" = "), coordinate.label);
    section.formulas.push_back(std::move(formula));
  }
  derivation.sections.push_back(std::move(section));
}

void add_speeds(const model::Model& model, const PaperSystem& paper, FormulaWriter& write, Derivation& derivation) {
  if (model.speeds.empty()) return;
  Section section{
      "Speeds",
      "",
      "The model has these in the place of rates. Z does not depend on that choice; the derivation keeps to "
      "the rates, from which the speeds follow.",
      {},
      {},
      {}};
  for (const model::Speed& speed : model.speeds) {
    section.items.push_back({latex_indices({speed.name.text}), speed.name.text,
                             with_unit(speed.about.empty() ? "speed" : speed.about, speed.unit)});
  }
  for (const FreeIndex a : paper.chart().free()) {
    const std::optional<symbolic::ChartSpeed>& speed = paper.chart().speed_instead(a);
    if (!speed) continue;
    Formula formula = write({latex_indices({speed->name}), {}, {}}, paper.chart().at_attitude(speed->is));
    formula.plain.replace(0, formula.plain.find(" = "), speed->name);
    section.formulas.push_back(std::move(formula));
  }
  derivation.sections.push_back(std::move(section));
}

}  // namespace

Derivation derive(const model::Model& model) {
  Derivation derivation;
  derivation.obstacle = paper_route_obstacle(model);
  if (!derivation.obstacle.empty()) return derivation;
  const std::optional<PaperSystem> paper = nonholonomic::build_paper_system(model);
  if (!paper) {
    derivation.obstacle = k_dependent_constraints;
    return derivation;
  }
  FormulaWriter write(model, *paper);
  derivation.title = "Equations of motion of " + model.name.text;
  derivation.about = model.about;
  add_constants(model, *paper, write, derivation);
  add_user_items(model, *paper, write, derivation);
  add_speeds(model, *paper, write, derivation);
  SystemSections system(*paper, write);
  derivation.sections.push_back(system.metric_of_free());
  if (paper->chart().held_count() > 0) {
    derivation.sections.push_back(system.metric_of_held());
    derivation.sections.push_back(system.dual_metric());
  }
  derivation.sections.push_back(system.christoffel_symbols());
  derivation.sections.push_back(system.accelerations());
  derivation.sections.push_back(system.gauss_function());
  add_equation_sections(*paper, write, derivation);
  return derivation;
}

}  // namespace gaussgen::lower
