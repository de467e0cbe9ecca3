#include "emit/functions.hpp"

#include <algorithm>
#include <unordered_set>

#include "emit/body.hpp"
#include "emit/identifiers.hpp"
#include "emit/text.hpp"
#include "passes/schedule.hpp"
#include "passes/share.hpp"

namespace gaussgen::emit {

using ir::Kind;
using ir::SymbolClass;
using passes::Program;
using passes::Request;
using passes::Writing;

namespace {

Program scheduled(const Writing& writing, const Request& request) {
  return passes::schedule(writing, passes::share(writing, request), request);
}

std::unordered_set<std::uint32_t> symbols_in(const Writing& writing) {
  std::unordered_set<std::uint32_t> found;
  for (const NodeId id : writing.order()) {
    const ir::Node& node = writing.graph()[id];
    if (node.kind == Kind::symbol) found.insert(node.symbol.index);
  }
  return found;
}

bool is_always_good(const ir::Graph& graph, const Request& request) {
  const std::vector<NodeId>& outputs = request.outputs;
  return std::all_of(outputs.end() - 3, outputs.end(), [&](NodeId id) { return graph.is_zero(id); });
}

bool has_conditions(const Writing& writing, const Request& request) {
  const std::vector<NodeId>& order = writing.order();
  return !is_always_good(writing.graph(), request) ||
         std::any_of(order.begin(), order.end(), [&](NodeId id) { return passes::is_boolean(writing.graph(), id); });
}

/// Local names for what a function reads, so that formulas read as on paper.
class Reader {
 public:
  Reader(Body& body, const UnitNames& names, std::unordered_set<std::uint32_t> used, const std::string& type)
      : body_(body), names_(names), used_(std::move(used)), type_(type) {}

  bool read(SymbolId symbol, const std::string& from, const std::string& call = "") {
    if (used_.count(symbol.index) == 0) return false;
    const std::string& name = names_.of_symbol(symbol);
    body_.add(cpp::Definition{type_, name, cpp::atom(from + "." + name + call)});
    return true;
  }

  template <class Entries>
  bool read_all(const Entries& entries, const std::string& from, const std::string& call) {
    bool any = false;
    for (const auto& entry : entries) any = read(symbol_of(entry), from, call) || any;
    return any;
  }

 private:
  static SymbolId symbol_of(const Entry& entry) { return entry.symbol; }
  static SymbolId symbol_of(const InputEntry& input) { return input.entry.symbol; }
  static SymbolId symbol_of(const PreparedMember& member) { return member.symbol; }

  Body& body_;
  const UnitNames& names_;
  std::unordered_set<std::uint32_t> used_;
  std::string type_;
};

/// Assigns outputs in their order to the places of derivative, state and result.
class Filler {
 public:
  Filler(const Plan& plan, Body& body, const std::vector<NodeId>& outputs) : plan_(plan), body_(body), outputs_(outputs) {}

  void fill(const Artefact& artefact) {
    if (!artefact.derivative.empty()) {
      for (const std::string& rate : plan_.unit.configuration_rates) set("derivative." + plan_.names.of(rate) + "()");
      for (const Entry& entry : plan_.unit.accelerations) set("derivative." + plan_.names.of(entry) + "()");
    }
    if (!artefact.state.empty()) {
      for (const Entry& entry : plan_.unit.configuration) set("state." + plan_.names.of(entry) + "()");
      for (const Entry& entry : plan_.unit.speeds) set("state." + plan_.names.of(entry) + "()");
    }
    for (const Group& group : artefact.groups) {
      for (const Field& field : group.fields) {
        const std::string path = plan_.result_types.path(artefact.result_type, group.name, field.name);
        for (std::size_t i = 0; i < field.values.size(); ++i) set(path + index(field.shape, i));
      }
    }
  }

  NodeId next() { return outputs_[position_++]; }

 private:
  static std::string index(const std::vector<int>& shape, std::size_t position) {
    std::string text;
    for (auto size = shape.rbegin(); size != shape.rend(); ++size) {
      const auto extent = static_cast<std::size_t>(*size);
      text.insert(0, "[" + std::to_string(position % extent) + "]");
      position /= extent;
    }
    return text;
  }

  void set(const std::string& place) { body_.add(cpp::Assignment{cpp::atom(place), body_.value(next())}); }

  const Plan& plan_;
  Body& body_;
  const std::vector<NodeId>& outputs_;
  std::size_t position_ = 0;
};

void return_status(Body& body, Filler& outputs) {
  const cpp::Expression singular = body.define_condition(outputs.next(), "singular_mass_matrix");
  const cpp::Expression dependent = body.define_condition(outputs.next(), "dependent_constraints");
  const cpp::Expression not_finite = body.define_condition(outputs.next(), "not_finite");
  body.add(cpp::Return{cpp::call("Math<S>::status", {singular, dependent, not_finite})});
}

}  // namespace

cpp::Function prepare_function(Plan& plan) {
  cpp::Function function;
  function.comment = "What depends on parameters alone, to be computed once.";
  function.prefix = "GAUSS_FUNCTION";
  function.type = "Prepared<S>";
  function.name = "prepare";
  function.suffix = "noexcept";

  std::vector<NodeId> roots;
  for (const PreparedMember& member : plan.prepared) roots.push_back(member.value);
  const Writing all(plan.graph, roots);
  NameScope scope = plan.names.function_scope();
  Body first(all, plan.names, scope);
  Reader reader(first, plan.names, symbols_in(all), "const S&");
  bool uses_parameters = false;
  for (const ParameterEntry& parameter : plan.unit.parameters) {
    if (!parameter.is_formula) uses_parameters = reader.read(parameter.entry.symbol, "parameters") || uses_parameters;
  }
  function.arguments = {{"const Parameters<S>&", "parameters", uses_parameters}};
  function.body = first.take();
  const auto append = [&function](Body& body) {
    for (cpp::Statement& statement : body.take()) function.body.push_back(std::move(statement));
  };

  // One formula after the other, since later ones use the names of earlier ones.
  for (const PreparedMember& member : plan.prepared) {
    if (!member.is_formula) continue;
    const Writing writing(plan.graph, {member.value});
    Body body(writing, plan.names, scope);
    body.define(scheduled(writing, {{member.value}, {}}));
    body.add(cpp::Definition{"const S", member.name, body.value(member.value)});
    append(body);
  }

  std::vector<NodeId> terms;
  for (const PreparedMember& member : plan.prepared) {
    if (!member.is_formula && !member.is_plain) terms.push_back(member.value);
  }
  const Writing writing(plan.graph, terms);
  Body body(writing, plan.names, scope);
  body.define(scheduled(writing, {terms, {}}));
  body.add(cpp::BlankLine{});
  body.add(cpp::Declaration{"Prepared<S>", {"prepared"}});
  for (const PreparedMember& member : plan.prepared) {
    const bool is_local = member.is_formula || member.is_plain;
    cpp::Expression value = is_local ? cpp::atom(member.name) : body.value(member.value);
    body.add(cpp::Assignment{cpp::atom("prepared." + member.name), std::move(value)});
  }
  body.add(cpp::Return{cpp::atom("prepared")});
  append(body);
  return function;
}

cpp::Function artefact_function(Plan& plan, const Task& task) {
  const Artefact& artefact = *task.artefact;
  const Unit& unit = plan.unit;
  cpp::Function function;
  function.comment = wrapped(artefact.about, 104);
  function.prefix = "GAUSS_FUNCTION";
  function.type = "StatusOf<S>";
  function.name = artefact.name;
  function.suffix = "noexcept";

  const Writing writing(plan.graph, task.request.outputs);
  const std::unordered_set<std::uint32_t> used = symbols_in(writing);
  NameScope scope = plan.names.function_scope();
  Body body(writing, plan.names, scope);
  if (has_conditions(writing, task.request)) body.add(cpp::Alias{"Bool", "typename Math<S>::Bool"});
  // By value where a caller may pass the same object as argument and result.
  const bool may_alias = !artefact.state.empty() || artefact.takes_accelerations;
  Reader reader(body, plan.names, used, may_alias ? "const S" : "const S&");
  const bool reads_prepared = reader.read_all(plan.prepared, "prepared", "");
  const bool reads_inputs = reader.read_all(unit.inputs, "inputs", "");
  const std::string source = artefact.state.empty() ? "state" : "from";
  bool reads_state = reader.read_all(unit.configuration, source, "()");
  reads_state = reader.read_all(unit.speeds, source, "()") || reads_state;
  const bool reads_accelerations = reader.read_all(unit.accelerations, "accelerations", "()");
  body.define(scheduled(writing, task.request));

  if (artefact.takes_time) function.arguments.push_back({"const S&", "t", used.count(unit.time.index) != 0});
  if (artefact.takes_state) function.arguments.push_back({"const State<S>&", source, reads_state});
  if (artefact.takes_inputs) function.arguments.push_back({"const Inputs<S>&", "inputs", reads_inputs});
  function.arguments.push_back({"const Prepared<S>&", "prepared", reads_prepared});
  if (artefact.takes_accelerations) {
    function.arguments.push_back({"const Derivative<S>&", "accelerations", reads_accelerations});
  }
  if (!artefact.derivative.empty()) function.arguments.push_back({"Derivative<S>&", "derivative", true});
  if (!artefact.state.empty()) function.arguments.push_back({"State<S>&", "state", true});
  if (!artefact.result_type.empty()) {
    function.arguments.push_back({artefact.result_type + "<S>&", snake_case(artefact.result_type), true});
  }

  body.blank_line();
  Filler outputs(plan, body, task.request.outputs);
  outputs.fill(artefact);
  body.blank_line();
  if (is_always_good(plan.graph, task.request)) {
    body.add(cpp::Return{cpp::call("StatusOf<S>", {})});
  } else {
    return_status(body, outputs);
  }
  function.body = body.take();
  return function;
}

}  // namespace gaussgen::emit
