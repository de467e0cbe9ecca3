#include "strategy/emitted_numbers.hpp"

#include "catch_shim.hpp"
#include "evaluate/decimal.hpp"
#include "gauss/oracle/evaluation.hpp"

namespace gaussgen::oracle {

namespace {

// A few digits more than Real has, so that nothing is lost on the way.
constexpr int k_digits = 60;

cln::cl_F as_cln(const evaluate::Arithmetic<cln::cl_F>& arithmetic, const Real& value) {
  // Four doubles hold more bits than Real has.
  cln::cl_F sum = arithmetic.number(0.0);
  Real rest = value;
  for (int part = 0; part < 4; ++part) {
    const double head = static_cast<double>(rest);
    sum = sum + arithmetic.number(head);
    rest -= head;
  }
  return sum;
}

}  // namespace

EmittedNumbers::EmittedNumbers(const Case& c, MechanicsOptions options)
    : mechanics_(c.model, options), evaluator_(mechanics_.graph, evaluate::Arithmetic<cln::cl_F>(k_digits)) {
  const kinematics::Symbols& symbols = mechanics_.symbols;
  bind(symbols.time, c.values.at("t"));
  for (std::size_t i = 0; i < c.model.parameters.size(); ++i) {
    bind(symbols.parameters[i], c.values.at(c.model.parameters[i].name.text));
  }
  for (std::size_t i = 0; i < c.model.inputs.size(); ++i)
    bind(symbols.inputs[i], c.values.at(c.model.inputs[i].name.text));
  for (const auto& q : symbols.configuration) bind(q.symbol, c.values.at(q.name));
  for (const auto& u : symbols.speeds) bind(u.symbol, c.values.at(u.name));
}

Real EmittedNumbers::operator()(ir::NodeId node) {
  const auto value = evaluator_(node);
  if (!value) FAIL(evaluator_.trouble(node)->name << ": " << evaluator_.trouble(node)->reason);
  return Real(evaluate::to_decimal(*value, k_digits));
}

Vec EmittedNumbers::operator()(const std::vector<ir::NodeId>& nodes) {
  Vec result;
  for (const ir::NodeId node : nodes) result.push_back((*this)(node));
  return result;
}

Vec EmittedNumbers::operator()(const strategy::Vector& nodes) {
  Vec result;
  for (const ir::Expr node : nodes) result.push_back((*this)(node.id()));
  return result;
}

std::map<std::string, Vec> EmittedNumbers::fields(const std::string& function) {
  std::map<std::string, Vec> result;
  for (const emit::Group& group : artefact(function).groups) {
    for (const emit::Field& field : group.fields) {
      result[(group.name.empty() ? "" : group.name + ".") + field.name] = (*this)(field.values);
    }
  }
  return result;
}

Vec EmittedNumbers::derivative(const std::string& function) { return (*this)(artefact(function).derivative); }
Vec EmittedNumbers::state(const std::string& function) {
  const emit::Artefact& of = artefact(function);
  return of.calls.empty() ? (*this)(of.state) : searched(of).state;
}

std::vector<std::string> EmittedNumbers::troubles(const std::string& function) {
  const emit::Artefact& of = artefact(function);
  return of.calls.empty() ? troubles(of.status) : searched(of).troubles;
}

std::vector<ir::SymbolId> EmittedNumbers::state_symbols() const {
  std::vector<ir::SymbolId> symbols;
  for (const auto& q : mechanics_.symbols.configuration) symbols.push_back(q.symbol);
  for (const auto& u : mechanics_.symbols.speeds) symbols.push_back(u.symbol);
  return symbols;
}

// As the emitted function does it; afterwards everything is bound as it was.
EmittedNumbers::Searched EmittedNumbers::searched(const emit::Artefact& caller) {
  const std::vector<ir::SymbolId> symbols = state_symbols();
  const std::map<std::uint32_t, cln::cl_F> before = bound_;
  for (std::size_t i = 0; i < mechanics_.start.size(); ++i)
    evaluator_.bind(mechanics_.start[i], before.at(symbols[i].index));
  if (!caller.takes_time) bind(mechanics_.symbols.time, 0);
  Searched result;
  for (const emit::Call& call : caller.calls) {
    const emit::Artefact& step = artefact(call.function);
    for (int time = 0; time < call.times; ++time) {
      for (const std::string& trouble : troubles(step.status)) result.troubles.push_back(trouble);
      result.state = (*this)(step.state);
      for (std::size_t i = 0; i < symbols.size(); ++i) bind(symbols[i], result.state[i]);
    }
  }
  for (const auto& [index, value] : before) evaluator_.bind(ir::SymbolId{index}, value);
  bound_ = before;
  return result;
}

std::vector<std::string> EmittedNumbers::troubles(const emit::StatusNodes& nodes) {
  std::vector<std::string> result;
  for (const auto& [node, name] :
       {std::pair(nodes.singular_mass_matrix, "singular mass matrix"),
        std::pair(nodes.dependent_constraints, "dependent constraints"), std::pair(nodes.not_finite, "not finite"),
        std::pair(nodes.violated_constraints, "violated constraints")}) {
    if ((*this)(node) != 0) result.emplace_back(name);
  }
  return result;
}

void EmittedNumbers::bind(ir::SymbolId symbol, const Real& value) {
  bound_.insert_or_assign(symbol.index, as_cln(evaluator_.arithmetic(), value));
  evaluator_.bind(symbol, bound_.at(symbol.index));
}

void EmittedNumbers::bind_accelerations(const Vec& free) {
  REQUIRE(free.size() == mechanics_.symbols.speeds.size());
  for (const auto i : mechanics_.symbols.speeds.indices())
    bind(mechanics_.symbols.speeds[i].acceleration, free[i.value]);
}

void EmittedNumbers::bind_configuration(const Vec& q) {
  REQUIRE(q.size() == mechanics_.symbols.configuration.size());
  for (const auto i : mechanics_.symbols.configuration.indices())
    bind(mechanics_.symbols.configuration[i].symbol, q[i.value]);
}

// `reactions` comes with `rhs_and_reactions`; each under its own name.
const emit::Artefact& EmittedNumbers::artefact(const std::string& function) {
  const auto known = artefacts_.find(function);
  if (known != artefacts_.end()) return known->second;
  const std::string output = function == "rhs_and_reactions" ? "reactions" : function;
  for (emit::Artefact& built : build_artefact(output, mechanics_))
    artefacts_.insert_or_assign(built.name, std::move(built));
  REQUIRE(artefacts_.count(function) == 1);
  return artefacts_.at(function);
}

double deviation(const Vec& a, const Vec& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, deviation(a[i], b[i]));
  return largest;
}

}  // namespace gaussgen::oracle
