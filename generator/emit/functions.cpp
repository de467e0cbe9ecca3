#include "emit/functions.hpp"

#include <algorithm>
#include <unordered_set>

#include "emit/body.hpp"
#include "emit/identifiers.hpp"
#include "emit/literal.hpp"
#include "emit/outputs.hpp"
#include "emit/taylor.hpp"
#include "emit/text.hpp"
#include "passes/schedule.hpp"
#include "passes/share.hpp"

namespace gaussgen::emit {

using ir::Kind;
using passes::Program;
using passes::Request;
using passes::Writing;

namespace {

constexpr std::size_t k_comment_width = 104;
const char* const k_solution_type = "const LinearSolution<S, n_v, n_constraints>&";
const std::string k_start = "start";              ///< of a search: the state before it
constexpr std::size_t k_required_conditions = 3;  ///< of Math<S>::status

Program scheduled(const Writing& writing, const Request& request) {
  return passes::schedule(writing, passes::share(writing, request), request);
}

using SymbolSet = std::unordered_set<std::uint32_t>;

SymbolSet symbols_in(const Writing& writing) {
  SymbolSet found;
  for (const NodeId id : writing.order()) {
    const ir::Node& node = writing.graph()[id];
    if (node.kind == Kind::symbol) found.insert(node.symbol.index);
  }
  return found;
}

/// Of the symbols for a prepared value, one that the function has; all have the same name.
SymbolId used_of(const PreparedMember& member, const SymbolSet& used) {
  for (const SymbolId other : member.others) {
    if (used.count(other.index) != 0) return other;
  }
  return member.symbol;
}

/// Local names for what a function reads, so that formulas read as on paper.
class Reader {
 public:
  Reader(Body& body, const UnitNames& names, const SymbolSet& used, const std::string& type)
      : body_(body), names_(names), used_(used), type_(type) {}

  bool uses(SymbolId symbol) const { return used_.count(symbol.index) != 0; }

  /// True if anything was read.
  bool read(SymbolId symbol, const std::string& from, const std::string& call = "") {
    return read_as(symbol, from + "." + names_.of_symbol(symbol) + call);
  }

  bool read_as(SymbolId symbol, const std::string& place) {
    if (!uses(symbol)) return false;
    body_.add(cpp::Definition{type_, names_.of_symbol(symbol), cpp::atom(place)});
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
  SymbolId symbol_of(const PreparedMember& member) const { return used_of(member, used_); }

  Body& body_;
  const UnitNames& names_;
  const SymbolSet& used_;
  std::string type_;
};

bool is_always_good(const ir::Graph& graph, const Task& task) {
  const Status nodes = status_of(task);
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](const Condition& condition) { return graph.is_zero(condition.node); });
}

void return_status(Body& body, const ir::Graph& graph, const Task& task) {
  if (is_always_good(graph, task)) return body.add(cpp::Return{cpp::call("StatusOf<S>", {})});
  std::vector<cpp::Expression> conditions;
  for (const Condition& condition : status_of(task)) {
    const bool may_be_left_out = conditions.size() >= k_required_conditions;
    if (may_be_left_out && graph.is_zero(condition.node)) continue;
    conditions.push_back(body.define_condition(condition.node, condition.name));
  }
  body.add(cpp::Return{cpp::call("Math<S>::status", std::move(conditions))});
}

/// Free for temporaries are the names of results (rates that are no speeds, accelerations and the state unless they are
/// given) and of prepared terms that this function does not read.
NameScope scope_for(const Plan& plan, const Artefact& artefact, const SymbolSet& used) {
  NameScope scope = plan.names.function_scope();
  for (const PreparedMember& member : plan.prepared) {
    const bool is_term = !member.is_plain && !member.is_formula;
    if (is_term && used.count(used_of(member, used).index) == 0) scope.release(member.name);
  }
  const std::vector<Entry>& speeds = plan.unit.speeds;
  for (const std::string& rate : plan.unit.configuration_rates) {
    const auto is_rate = [&](const Entry& speed) { return speed.name == rate; };
    if (std::none_of(speeds.begin(), speeds.end(), is_rate)) scope.release(plan.names.of(rate));
  }
  if (!artefact.takes_state) {
    for (const Entry& entry : plan.unit.configuration) scope.release(plan.names.of(entry));
    for (const Entry& entry : speeds) scope.release(plan.names.of(entry));
  }
  if (artefact.takes_accelerations || artefact.takes_solution) return scope;
  for (const Entry& entry : plan.unit.accelerations) scope.release(plan.names.of(entry));
  return scope;
}

/// True if anything was read.
bool read_list(Reader& reader, const std::vector<Entry>& entries, const std::string& from) {
  bool any = false;
  for (std::size_t i = 0; i < entries.size(); ++i)
    any = reader.read_as(entries[i].symbol, from + "[" + std::to_string(i) + "]") || any;
  return any;
}

/// Reads what a function needs and lists its arguments as it goes.
std::vector<cpp::Argument> read_arguments(const Plan& plan, const Artefact& artefact, Reader& reader) {
  const Unit& unit = plan.unit;
  const std::string source = artefact.state.empty() ? "state" : "from";
  const bool reads_prepared = reader.read_all(plan.prepared, "prepared", "");
  const bool reads_inputs = reader.read_all(unit.inputs, "inputs", "");
  const bool reads_coordinates = reader.read_all(unit.configuration, source, "()");
  const bool reads_state = reader.read_all(unit.speeds, source, "()") || reads_coordinates;
  bool reads_start = false;
  for (std::size_t i = 0; i < unit.start.size(); ++i)
    reads_start = reader.read_as(unit.start[i].symbol, k_start + ("." + plan.names.of(unit.configuration[i]) + "()")) ||
                  reads_start;
  bool reads_accelerations = false, reads_solution = false;
  if (artefact.takes_solution) {
    reads_solution = read_list(reader, unit.accelerations, "solved.accelerations");
    reads_solution = read_list(reader, unit.multipliers, "solved.multipliers") || reads_solution;
  } else {
    reads_accelerations = reader.read_all(unit.accelerations, "accelerations", "()");
  }
  std::vector<cpp::Argument> arguments;
  if (artefact.takes_time) arguments.push_back({"const S&", "t", reader.uses(unit.time)});
  if (artefact.takes_start) arguments.push_back({"const State<S>&", k_start, reads_start});
  if (artefact.takes_state) arguments.push_back({"const State<S>&", source, reads_state});
  if (artefact.takes_inputs) arguments.push_back({"const Inputs<S>&", "inputs", reads_inputs});
  arguments.push_back({"const Prepared<S>&", "prepared", reads_prepared});
  if (artefact.takes_accelerations) arguments.push_back({"const Derivative<S>&", "accelerations", reads_accelerations});
  if (artefact.takes_solution) arguments.push_back({k_solution_type, "solved", reads_solution});
  if (!artefact.derivative.empty() && !artefact.is_series) arguments.push_back({"Derivative<S>&", "derivative", true});
  if (artefact.is_series) {
    arguments.push_back({"int", "order", true});
    arguments.push_back({"TaylorSeries<S>&", "series", true});
  }
  if (!artefact.state.empty()) arguments.push_back({"State<S>&", "state", true});
  if (!artefact.result_type.empty()) {
    arguments.push_back({artefact.result_type + "<S>&", snake_case(artefact.result_type), true});
  }
  return arguments;
}

}  // namespace

namespace {

/// The rates as order 0 of what `Derivative` holds, and all other orders from them.
FunctionCode series_function(Plan& plan, const Task& task) {
  Request request = task.request;
  const std::vector<NodeId> rates(
      request.outputs.begin(), request.outputs.begin() + static_cast<std::ptrdiff_t>(task.artefact->derivative.size()));
  const passes::Series series = series_of(plan, rates);
  // Mentioned twice, they get names.
  for (const int times : {1, 2}) {
    static_cast<void>(times);
    request.outputs.insert(request.outputs.end(), series.at_start.begin(), series.at_start.end());
  }
  const Writing writing(plan.graph, request.outputs);
  const SymbolSet used = symbols_in(writing);
  NameScope scope = scope_for(plan, *task.artefact, used);
  Body body(writing, plan.names, scope);
  Reader reader(body, plan.names, used, "const S&");
  cpp::Function function = declared(*task.artefact);
  function.arguments = read_arguments(plan, *task.artefact, reader);
  for (cpp::Argument& argument : function.arguments) argument.is_used = argument.is_used || argument.name == "state";
  for (const Output& output : outputs_of(plan, task)) request.suggestions.emplace_back(output.value, output.name);
  body.define(scheduled(writing, request));
  write_series(series, plan, rates, body, scope);
  body.blank_line();
  return_status(body, plan.graph, task);
  function.body = body.take();
  name_type_of_conditions(function.body, !is_always_good(plan.graph, task));
  return {std::move(function), 0, false, series_struct(series)};
}

}  // namespace

/// Without arguments and body.
cpp::Function declared(const Artefact& artefact) {
  cpp::Function function;
  function.comment = wrapped(artefact.about, k_comment_width);
  function.prefix = "GAUSS_FUNCTION";
  function.type = "StatusOf<S>";
  function.name = artefact.name;
  function.suffix = "noexcept";
  return function;
}

FunctionCode artefact_function(Plan& plan, const Task& task) {
  const Artefact& artefact = *task.artefact;
  if (artefact.is_series) return series_function(plan, task);
  cpp::Function function = declared(artefact);

  const Writing writing(plan.graph, task.request.outputs);
  const SymbolSet used = symbols_in(writing);
  NameScope scope = scope_for(plan, artefact, used);
  Body body(writing, plan.names, scope);
  // By value where a caller may pass the same object as argument and result.
  const bool may_alias = !artefact.state.empty() || (artefact.takes_accelerations && !artefact.derivative.empty());
  Reader reader(body, plan.names, used, may_alias ? "const S" : "const S&");
  function.arguments = read_arguments(plan, artefact, reader);
  const std::size_t reads = body.size();

  Request request = task.request;
  const std::vector<Output> outputs = outputs_of(plan, task);
  for (const Output& output : outputs) request.suggestions.emplace_back(output.value, output.name);
  body.define(scheduled(writing, request));
  body.blank_line();
  for (const Output& output : outputs) body.add(cpp::Assignment{cpp::atom(output.place), body.value(output.value)});
  body.blank_line();
  return_status(body, plan.graph, task);
  function.body = body.take();
  const std::size_t statements = function.body.size();
  name_type_of_conditions(function.body, !is_always_good(plan.graph, task));
  const std::size_t named = function.body.size() - statements;
  return {std::move(function), reads + named, may_alias};
}

namespace {

const char* const k_by_one = "by_one";

/// Taken until one moves nothing: see detail::Newton of the prelude.
void add_steps(const Call& call, cpp::Expression status_of_step, cpp::Function& function) {
  const std::string newton = call.function + "_steps";
  function.body.emplace_back(cpp::Declaration{"detail::Newton<S>", {newton}});
  cpp::Loop loop{"step", "0", std::to_string(call.times), {}, newton + ".goes_on()"};
  const cpp::Expression taken = cpp::call(newton + ".take", {std::move(status_of_step), cpp::atom("before.values"),
                                                             cpp::atom("state.values"), cpp::atom(k_by_one)});
  loop.body.push_back({cpp::Definition{"const State<S>", "before", cpp::atom("state")}});
  loop.body.push_back(
      {cpp::Assignment{cpp::atom("status"), cpp::call("Math<S>::worse", {cpp::atom("status"), taken})}});
  function.body.emplace_back(std::move(loop));
}

void measure_by_one(const Artefact& artefact, cpp::Function& function) {
  const auto is_repeated = [](const Call& call) { return call.times > 1; };
  if (std::none_of(artefact.calls.begin(), artefact.calls.end(), is_repeated)) return;
  std::vector<cpp::Expression> flags;
  for (const int flag : artefact.measured_by_one) flags.push_back(cpp::atom(std::to_string(flag)));
  function.body.emplace_back(
      cpp::Definition{"const int", k_by_one + std::string("[n_q + n_v]"), cpp::list(std::move(flags))});
}

}  // namespace

cpp::Function search_function(const Artefact& artefact) {
  cpp::Function function = declared(artefact);
  if (artefact.takes_time) function.arguments.push_back({"const S&", "t"});
  if (artefact.takes_state) function.arguments.push_back({"const State<S>&", "from"});
  function.arguments.push_back({"const Prepared<S>&", "prepared"});
  function.arguments.push_back({"State<S>&", "state"});

  // `state` may be `from`.
  const bool keeps_start =
      std::any_of(artefact.calls.begin(), artefact.calls.end(), [](const Call& call) { return call.takes_start; });
  if (keeps_start) function.body.emplace_back(cpp::Definition{"const State<S>", k_start, cpp::atom("from")});
  if (artefact.takes_state) function.body.emplace_back(cpp::Assignment{cpp::atom("state"), cpp::atom("from")});
  function.body.emplace_back(cpp::Definition{"StatusOf<S>", "status", cpp::call("StatusOf<S>", {})});
  measure_by_one(artefact, function);
  for (const Call& call : artefact.calls) {
    std::vector<cpp::Expression> arguments;
    if (call.takes_state) arguments.push_back(artefact.takes_time ? cpp::atom("t") : literal(0));
    if (call.takes_start) arguments.push_back(cpp::atom(k_start));
    if (call.takes_state) arguments.push_back(cpp::atom("state"));
    arguments.push_back(cpp::atom("prepared"));
    arguments.push_back(cpp::atom("state"));
    cpp::Expression status_of_step = cpp::call(call.function, std::move(arguments));
    if (call.times == 1) {
      function.body.emplace_back(
          cpp::Assignment{cpp::atom("status"), cpp::call("Math<S>::worse", {cpp::atom("status"), status_of_step})});
    } else {
      add_steps(call, std::move(status_of_step), function);
    }
  }
  function.body.emplace_back(cpp::Return{cpp::atom("status")});
  return function;
}

}  // namespace gaussgen::emit
