#include "emit/plan.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <unordered_set>
#include <utility>

#include "emit/natural.hpp"
#include "emit/text.hpp"
#include "ir/cost.hpp"
#include "ir/traverse.hpp"
#include "passes/cancellation.hpp"
#include "passes/finite.hpp"
#include "passes/optimise.hpp"
#include "passes/prepare.hpp"
#include "passes/share.hpp"
#include "support/assert.hpp"

namespace gaussgen::emit {

namespace {

using IdSet = std::unordered_set<std::uint32_t>;

/// What a caller hands over at each call.
std::vector<SymbolId> arguments_of(const Artefact& artefact, const Unit& unit) {
  std::vector<SymbolId> symbols;
  const auto append = [&](const std::vector<Entry>& entries) {
    for (const Entry& entry : entries) symbols.push_back(entry.symbol);
  };
  if (artefact.takes_time) symbols.push_back(unit.time);
  if (artefact.takes_state) append(unit.configuration);
  if (artefact.takes_state) append(unit.speeds);
  if (artefact.takes_start) append(unit.start);
  if (artefact.takes_inputs) {
    for (const InputEntry& input : unit.inputs) symbols.push_back(input.entry.symbol);
  }
  if (artefact.takes_accelerations || artefact.takes_solution) append(unit.accelerations);
  if (artefact.takes_solution) append(unit.multipliers);
  return symbols;
}

/// Compilers limit the depth of fold expressions: clang++ 14 to 256 operands.
constexpr std::size_t k_most_operands = 128;

NodeId in_parts(ir::Graph& graph, const std::vector<NodeId>& values) {
  std::vector<NodeId> parts;
  for (std::size_t first = 0; first < values.size(); first += k_most_operands) {
    const std::size_t last = std::min(values.size(), first + k_most_operands);
    parts.push_back(graph.call(ir::Function::not_finite, {values.begin() + static_cast<std::ptrdiff_t>(first),
                                                          values.begin() + static_cast<std::ptrdiff_t>(last)}));
  }
  return parts.size() == 1 ? parts[0] : graph.call(ir::Function::any, parts);
}

/// A NaN in an argument is reported even where no result depends on it, such as a coordinate that only gets integrated.
/// Arguments come first: they are there early, so that the sum over all values does not wait for them.
NodeId not_finite(ir::Graph& graph, const Artefact& artefact, const Unit& unit) {
  const NodeId described = artefact.status.not_finite;
  const ir::Node node = graph[described];
  if (node.kind != ir::Kind::function || node.function != ir::Function::not_finite) return described;
  std::vector<NodeId> values;
  IdSet seen;
  const auto add = [&](NodeId value) {
    if (seen.insert(value.index).second) values.push_back(value);
  };
  for (const SymbolId symbol : arguments_of(artefact, unit)) add(graph.use(symbol));
  for (const NodeId value : node.children) add(value);
  return in_parts(graph, values);
}

std::vector<NodeId> checked_by(const ir::Graph& graph, NodeId condition) {
  const ir::Node& node = graph[condition];
  if (node.kind != ir::Kind::function) return {};
  if (node.function == ir::Function::not_finite) return listed(node.children);
  std::vector<NodeId> values;
  if (node.function != ir::Function::any) return values;
  for (const NodeId part : node.children) {
    const std::vector<NodeId> more = checked_by(graph, part);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

/// As `not_finite` has it, of the values that all others depend on; as code will compute them, since passes change what depends on what.
NodeId over_fewest_values(ir::Graph& graph, NodeId not_finite) {
  const std::vector<NodeId> values = passes::fewest_to_check(graph, checked_by(graph, not_finite));
  return values.empty() ? not_finite : in_parts(graph, values);
}

constexpr std::size_t k_outputs_from_not_finite = 2;

std::vector<NodeId> outputs_of(const Artefact& artefact, NodeId not_finite) {
  std::vector<NodeId> outputs = artefact.derivative;
  outputs.insert(outputs.end(), artefact.state.begin(), artefact.state.end());
  for (const Group& group : artefact.groups) {
    for (const Field& field : group.fields) outputs.insert(outputs.end(), field.values.begin(), field.values.end());
  }
  const StatusNodes& status = artefact.status;
  outputs.insert(outputs.end(),
                 {status.singular_mass_matrix, status.dependent_constraints, not_finite, status.violated_constraints});
  return outputs;
}

std::unordered_map<std::uint32_t, std::string> wanted_names(const Unit& unit) {
  std::unordered_map<std::uint32_t, std::string> names;
  for (const Artefact& artefact : unit.artefacts) {
    for (const Section& section : artefact.sections) {
      for (const auto& [node, name] : section.nodes) names.emplace(node.index, name);
    }
  }
  return names;
}

IdSet reached_from(const ir::Graph& graph, const std::vector<NodeId>& roots) {
  IdSet reached;
  for (const NodeId id : ir::post_order(graph, roots)) reached.insert(id.index);
  return reached;
}

/// What runs once needs no preparation of its own.
bool runs_once(const Artefact& artefact) {
  return !artefact.takes_state && !artefact.takes_time && !artefact.takes_inputs;
}

class Planner {
 public:
  explicit Planner(Plan& plan) : plan_(plan), split_(plan.graph, wanted_names(plan.unit)) {
    for (std::size_t i = 0; i < plan.unit.parameters.size(); ++i) {
      position_.emplace(plan.unit.parameters[i].entry.symbol.index, i);
    }
  }

  void run() {
    for (const Artefact& artefact : plan_.unit.artefacts) {
      if (artefact.is_caller()) continue;
      Task task{&artefact, {}, {}};
      task.request = runs_once(artefact) ? as_it_is(artefact) : over_prepared(artefact, task.effects);
      plan_.tasks.push_back(std::move(task));
    }
    // Plain parameters in the order of the model, formulas after what they need, then the rest as it came up.
    std::vector<NodeId> roots;
    for (const Task& task : plan_.tasks)
      roots.insert(roots.end(), task.request.outputs.begin(), task.request.outputs.end());
    const std::vector<passes::PreparedValue> values = split_.values_in(roots);
    IdSet used;
    for (const passes::PreparedValue& value : values) {
      used.insert(value.symbol.index);
      if (const auto parameter = parameter_in(value)) used.insert(parameter->index);
    }
    for (const ParameterEntry& parameter : plan_.unit.parameters) {
      if (!parameter.is_formula && used.count(parameter.entry.symbol.index) != 0) add_parameter(parameter);
    }
    for (const passes::PreparedValue& value : values) add_formulas_in(value.value);
    add_terms(values);
  }

 private:
  passes::Request as_it_is(const Artefact& artefact) {
    passes::Request request{outputs_of(artefact, not_finite(plan_.graph, artefact, plan_.unit)), {}, {}};
    for (const Section& section : artefact.sections) request.sections.push_back({section.comment, section.nodes});
    for (const NodeId output : request.outputs) split_.touch(output);
    return request;
  }

  passes::Request over_prepared(const Artefact& artefact, std::vector<passes::PassEffect>& effects) {
    passes::Request request{outputs_of(artefact, not_finite(plan_.graph, artefact, plan_.unit)), {}, {}};
    const IdSet needed = reached_from(plan_.graph, request.outputs);
    for (const Section& section : artefact.sections) {
      passes::Section kept{section.comment, {}};
      for (const auto& [node, name] : section.nodes) {
        if (needed.count(node.index) != 0) kept.nodes.emplace_back(node, name);
      }
      request.sections.push_back(std::move(kept));
    }
    if (!plan_.unit.optimised) return over_prepared(std::move(request));
    request = passes::apply_cancellation(plan_.graph, request, &effects, rules_left_out(artefact));
    request = passes::apply(plan_.graph, request, passes::identities(), &effects);
    // What `prepare` computes is no operation any more.
    request = prepared_again(std::move(request), effects);
    request = prepared_again(passes::apply_best_order(plan_.graph, request, &effects), effects);
    request = prepared_again(passes::apply_rotations(plan_.graph, request, &effects), effects);
    const auto begin = Clock::now();
    const std::vector<NodeId> before = request.outputs;
    NodeId& condition = request.outputs[request.outputs.size() - k_outputs_from_not_finite];
    condition = over_fewest_values(plan_.graph, condition);
    add_effect("checks", before, request.outputs, begin, effects);
    return request;
  }

  std::vector<std::string> rules_left_out(const Artefact& artefact) const {
    std::vector<std::string> rules = plan_.unit.as_written;
    const std::vector<std::string>& by_cases = passes::digit_rules_by_cases();
    if (artefact.is_series) rules.insert(rules.end(), by_cases.begin(), by_cases.end());
    return rules;
  }

  using Clock = std::chrono::steady_clock;

  passes::Request prepared_again(passes::Request request, std::vector<passes::PassEffect>& effects) {
    const auto begin = Clock::now();
    const std::vector<NodeId> before = request.outputs;
    passes::Request result = over_prepared(std::move(request));
    add_effect("prepare", before, result.outputs, begin, effects);
    return result;
  }

  void add_effect(const char* name, const std::vector<NodeId>& before, const std::vector<NodeId>& now,
                  Clock::time_point begin, std::vector<passes::PassEffect>& effects) const {
    const int operations = now == before ? effects.back().after : ir::operations(plan_.graph, now);
    const std::chrono::duration<double, std::milli> taken = Clock::now() - begin;
    effects.push_back({name, effects.back().after, operations, taken.count()});
  }

  // Passes bring together what depends on parameters alone, as the difference of two moments of inertia.
  passes::Request over_prepared(passes::Request request) {
    for (NodeId& output : request.outputs) output = split_(output);
    for (passes::Section& section : request.sections) {
      std::vector<std::pair<NodeId, std::string>> varying;
      for (const auto& [node, name] : section.nodes) {
        if (split_.varies(node)) varying.emplace_back(split_(node), name);
      }
      section.nodes = std::move(varying);
    }
    return request;
  }

  void add_parameter(const ParameterEntry& parameter) {
    const Entry& entry = parameter.entry;
    if (!added_.insert(entry.symbol.index).second) return;
    const NodeId value = parameter.is_formula ? parameter.value : plan_.graph.use(entry.symbol);
    plan_.prepared.push_back(
        {entry.symbol, {}, plan_.names.of(entry), entry.about, value, !parameter.is_formula, parameter.is_formula});
  }

  // Formulas do not depend on themselves (the model is checked), so this ends.
  void add_formulas_in(NodeId root) {
    for (const NodeId id : ir::post_order(plan_.graph, {root})) {
      const ir::Node& node = plan_.graph[id];
      if (node.kind != ir::Kind::symbol) continue;
      const auto place = position_.find(node.symbol.index);
      if (place == position_.end() || added_.count(node.symbol.index) != 0) continue;
      const ParameterEntry& parameter = plan_.unit.parameters[place->second];
      if (!parameter.is_formula) continue;
      add_formulas_in(parameter.value);
      add_parameter(parameter);
    }
  }

  /// The parameter of which a term is a copy under another name.
  std::optional<SymbolId> parameter_in(const passes::PreparedValue& value) const {
    const ir::Node& node = plan_.graph[passes::unwrapped(plan_.graph, value.value)];
    const bool is_copy = node.kind == ir::Kind::symbol && position_.count(node.symbol.index) != 0;
    return is_copy ? std::optional(node.symbol) : std::nullopt;
  }

  // Passes name parts of what functions compute, so that one value may have been prepared under several names.
  void add_terms(const std::vector<passes::PreparedValue>& values) {
    std::unordered_map<std::uint32_t, std::string> names;
    for (const passes::PreparedValue& value : values) {
      std::string& name = names[passes::unwrapped(plan_.graph, value.value).index];
      if (name.empty()) name = value.name;
    }
    std::unordered_map<std::uint32_t, std::size_t> members;
    for (std::size_t i = 0; i < plan_.prepared.size(); ++i)
      members.emplace(plan_.graph.use(plan_.prepared[i].symbol).index, i);
    for (const passes::PreparedValue& value : values) {
      if (position_.count(value.symbol.index) != 0) continue;
      const NodeId open = passes::unwrapped(plan_.graph, value.value);
      const auto [place, is_new] = members.emplace(open.index, plan_.prepared.size());
      if (is_new) {
        add_term({value.symbol, value.value, names.at(open.index)});
        continue;
      }
      PreparedMember& same = plan_.prepared[place->second];
      plan_.names.bind(value.symbol, same.name);
      same.others.push_back(value.symbol);
    }
  }

  void add_term(const passes::PreparedValue& value) {
    const auto name_of = [this](NodeId id) -> std::string {
      const ir::Node& node = plan_.graph[id];
      return node.kind == ir::Kind::symbol ? plan_.graph.symbol(node.symbol).name : std::string();
    };
    std::string wanted = value.name.empty() ? natural_name(plan_.graph, value.value, name_of) : value.name;
    NameScope& scope = plan_.names.scope();
    const std::string name = wanted.empty() ? scope.allocate_anonymous("c") : scope.allocate(wanted);
    plan_.names.bind(value.symbol, name);
    plan_.prepared.push_back({value.symbol, {}, name, {}, value.value, false, false});
  }

  Plan& plan_;
  passes::PreparationSplit split_;
  std::unordered_map<std::uint32_t, std::size_t> position_;  ///< of a symbol among the parameters
  IdSet added_;
};

}  // namespace

Plan::Plan(ir::Graph own, const Unit& described)
    : graph(std::move(own)), unit(described), names(graph, unit), result_types(unit) {
  Planner(*this).run();
}

}  // namespace gaussgen::emit
