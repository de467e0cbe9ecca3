#include "strategy/tree_choice.hpp"

#include <map>

#include "ir/cost.hpp"
#include "strategy/fixed_turns.hpp"

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
  return {Drift::by_link, length.value(), mass.value(), false};
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

}  // namespace

Candidate counted(Solution solution, Steps steps) {
  std::vector<ir::NodeId> results{solution.singular_mass_matrix.id(), solution.dependent_constraints.id()};
  for (const Expr a : solution.accelerations) results.push_back(a.id());
  for (const Expr lambda : solution.multipliers) results.push_back(lambda.id());
  const int operations = ir::operations(solution.singular_mass_matrix.graph(), results);
  return {std::move(solution), std::move(steps), operations};
}

std::optional<Candidate> cheapest_tree(const TreeProblem& problem, Expr epsilon) {
  std::optional<Candidate> best;
  for (const TreeForm& form : forms_of(problem.linkage)) {
    Steps steps;
    std::optional<Solution> solution = solve_tree(problem, form, epsilon, steps);
    if (!solution) return std::nullopt;
    Candidate candidate = counted(std::move(*solution), std::move(steps));
    if (!best || candidate.operations < best->operations) best = std::move(candidate);
  }
  return best;
}

}  // namespace gaussgen::strategy
