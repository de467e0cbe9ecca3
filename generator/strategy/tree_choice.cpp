#include "strategy/tree_choice.hpp"

#include <map>

#include <fmt/format.h>

#include "ir/cost.hpp"
#include "ir/latency.hpp"
#include "strategy/fixed_turns.hpp"
#include "strategy/mass_properties.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Rational;
using kinematics::Link;
using kinematics::Linkage;

namespace {

/// The number that most expressions are, up to its sign; 1 where one is no number.
class MostFrequent {
 public:
  void add(Expr e) {
    const ir::Node& node = e.graph()[e.id()];
    if (node.kind != ir::Kind::constant) {
      has_others_ = true;
    } else if (node.value != 0) {
      ++counts_[support::to_text(cln::abs(node.value))];
      values_.emplace(support::to_text(cln::abs(node.value)), cln::abs(node.value));
    }
  }

  Rational value() const {
    Rational best = 1;
    int most = 0;
    for (const auto& [text, count] : counts_) {
      if (count <= most) continue;
      most = count;
      best = values_.at(text);
    }
    return has_others_ ? Rational(1) : best;
  }

 private:
  bool has_others_ = false;
  std::map<std::string, int> counts_;
  std::map<std::string, Rational> values_;
};

TreeForm natural_units(const Linkage& linkage) {
  MostFrequent length, mass;
  for (const Link& link : linkage.links) {
    if (link.kind != Link::Kind::shift) continue;
    for (const Expr e : link.offset) length.add(e);
  }
  for (const kinematics::Part& part : linkage.parts) mass.add(part.mass);
  return {Drift::by_link, length.value(), mass.value(), false, false};
}

std::vector<TreeForm> forms_of(const Linkage& linkage) {
  std::vector<TreeForm> forms{{}};
  const TreeForm natural = natural_units(linkage);
  if (natural.length != 1 || natural.mass != 1) forms.push_back(natural);
  const auto with_each = [&](auto change) {
    const std::vector<TreeForm> before = forms;
    for (TreeForm form : before) {
      change(form);
      forms.push_back(form);
    }
  };
  with_each([](TreeForm& form) { form.drift = Drift::accumulated; });
  if (has_fixed_turns(linkage)) with_each([](TreeForm& form) { form.chooses_axes = true; });
  return forms;
}

/// The mass with which most bars of unit length have unit inertia, once their masses are at their ends: then their Schur complements take
/// fewest products.
Rational mass_of_bars(const Linkage& linkage, const TreeForm& form, ir::Graph& graph) {
  const Linkage in_form = in_units(linkage, form.length, form.mass);
  std::vector<MassProperties> properties = mass_properties(in_form, graph);
  move_masses_to_ends(in_form.links, properties);
  MostFrequent inertia;
  for (const Link& link : in_form.links) {
    if (link.kind != Link::Kind::shift || link.parent == kinematics::k_ground) continue;
    const Link& bar = in_form.links[link.parent];
    if (bar.kind == Link::Kind::turn) inertia.add(properties[link.parent].inertia[bar.axis][bar.axis]);
  }
  return inertia.value();
}

/// The same form with divisions postponed, also in such units.
std::vector<TreeForm> postponed(const Linkage& linkage, TreeForm form) {
  if (linkage.links.empty()) return {};
  form.postpones = true;
  std::vector<TreeForm> forms{form};
  const Rational mass = mass_of_bars(linkage, form, linkage.links[0].offset[0].graph());
  if (mass != 1) {
    form.mass = form.mass * mass;
    forms.push_back(form);
  }
  return forms;
}

std::optional<Candidate> solved(const TreeProblem& problem, const TreeForm& form, Expr epsilon) {
  Steps steps;
  std::optional<Solution> solution = solve_tree(problem, form, epsilon, steps);
  if (!solution) return std::nullopt;
  return counted(std::move(*solution), std::move(steps));
}

}  // namespace

Candidate counted(Solution solution, Steps steps) {
  std::vector<ir::NodeId> results{solution.singular_mass_matrix.id(), solution.dependent_constraints.id()};
  for (const Expr a : solution.accelerations) results.push_back(a.id());
  for (const Expr lambda : solution.multipliers) results.push_back(lambda.id());
  const ir::Graph& graph = solution.singular_mass_matrix.graph();
  const int operations = ir::operations(graph, results);
  const int latency = ir::latency(graph, results);
  return {std::move(solution), std::move(steps), operations, latency, ""};
}

std::optional<Candidate> cheapest_tree(const TreeProblem& problem, Expr epsilon) {
  std::optional<Candidate> best;
  TreeForm chosen;
  for (const TreeForm& form : forms_of(problem.linkage)) {
    std::optional<Candidate> candidate = solved(problem, form, epsilon);
    if (!candidate) return std::nullopt;
    if (best && candidate->operations >= best->operations) continue;
    best = std::move(candidate);
    chosen = form;
  }
  const TreeForm along_speeds = chosen;
  if (!problem.loads.empty()) {
    chosen.puts_loads_on_links = true;
    std::optional<Candidate> on_links = solved(problem, chosen, epsilon);
    if (on_links && on_links->operations < best->operations) {
      on_links->about = ", forces at places on the links that carry them";
      return on_links;
    }
  }
  const int waiting = best->latency;
  for (const TreeForm& form : postponed(problem.linkage, along_speeds)) {
    std::optional<Candidate> candidate = solved(problem, form, epsilon);
    if (!candidate || candidate->cycles() >= best->cycles()) continue;
    candidate->about = fmt::format(
        ", divisions by the inertia of bars postponed so that results wait for each other for some {} cycles and not "
        "{}",
        candidate->latency, waiting);
    best = std::move(candidate);
  }
  return best;
}

}  // namespace gaussgen::strategy
