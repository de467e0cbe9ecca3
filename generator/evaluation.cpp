#include "evaluation.hpp"

#include "evaluate/arithmetic_double.hpp"
#include "evaluate/arithmetic_scale.hpp"
#include "evaluate/decimal.hpp"
#include "strategy/projection.hpp"

namespace gaussgen {

using cln::cl_F;
using ir::Expr;
using ir::NodeId;

namespace {

/// Residuals above this many rounding units of the working precision are the user's, not ours.
constexpr int k_residual_slack = 1000;

class Report {
 public:
  Report(Mechanics& mechanics, const support::Rational& time, int digits)
      : mechanics_(mechanics), digits_(digits), evaluator_(mechanics.graph, evaluate::Arithmetic<cl_F>(digits)) {
    evaluator_.bind(mechanics.symbols.time, evaluator_.arithmetic().number(time));
    bind_parameters(mechanics, evaluator_);
  }

  Evaluation run() {
    if (!set_state()) return std::move(result_);
    add_accelerations();
    add_reactions();
    add_groups("reaction_forces");
    add_groups("energy");
    add_groups("residuals");
    add_groups("compulsion");
    add_status();
    return std::move(result_);
  }

 private:
  void add(const std::string& group, const std::string& name, const std::string& unit, NodeId node) {
    const std::optional<cl_F> value = evaluator_(node);
    if (value) {
      result_.values.push_back({group, name, unit, evaluate::to_decimal(*value, digits_), true});
      return;
    }
    const auto trouble = evaluator_.trouble(node);
    result_.values.push_back({group, name, unit, "undefined: " + trouble->reason + " in " + trouble->name, false});
  }

  bool bind(ir::SymbolId symbol, NodeId node) {
    const std::optional<cl_F> value = evaluator_(node);
    if (value) evaluator_.bind(symbol, *value);
    return value.has_value();
  }

  // The initial state is found first and bound as numbers: everything else is evaluated at it.
  bool set_state() {
    const kinematics::Symbols& symbols = mechanics_.symbols;
    strategy::Steps steps;
    const auto state = strategy::initial_state(mechanics_.model, mechanics_.dynamics, mechanics_.expressions,
                                               mechanics_.expressions.symbol(symbols.time), mechanics_.epsilon(), steps);
    std::vector<std::pair<ir::SymbolId, NodeId>> bindings;
    for (const auto i : symbols.configuration.indices()) {
      const auto& q = symbols.configuration[i];
      add("state", q.name, q.unit, state.configuration[i.value].id());
      bindings.emplace_back(q.symbol, state.configuration[i.value].id());
    }
    for (const auto i : symbols.speeds.indices()) {
      const auto& u = symbols.speeds[i];
      add("state", u.name, u.unit, state.speeds[i.value].id());
      bindings.emplace_back(u.symbol, state.speeds[i.value].id());
    }
    bool all_defined = true;
    for (const auto& [symbol, node] : bindings) all_defined = bind(symbol, node) && all_defined;
    if (!all_defined) result_.warnings.push_back("the initial state is undefined");
    return all_defined;
  }

  void add_accelerations() {
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      const auto& u = mechanics_.symbols.speeds[i];
      const NodeId node = mechanics_.solution.accelerations[i.value].id();
      add("accelerations", u.acceleration_name, u.unit.empty() ? "" : u.unit + "^2", node);
      bind(u.acceleration, node);
    }
  }

  void add_reactions() {
    for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
      add("multipliers", mechanics_.dynamics.constraints[mu], "", mechanics_.solution.multipliers[mu].id());
    }
    for (const auto i : mechanics_.symbols.held.indices()) {
      add("reactions", mechanics_.symbols.held[i].name, "", mechanics_.held_reactions[i.value].id());
    }
  }

  static std::string suffix(const emit::Field& field, std::size_t index) {
    static const char* const k_axes[] = {"x", "y", "z"};
    if (field.shape.empty()) return "";
    if (field.shape[0] == 3 && field.values.size() == 3) return std::string(".") + k_axes[index];
    return "[" + std::to_string(index) + "]";
  }

  void add_groups(const std::string& output) {
    for (const emit::Artefact& artefact : build_artefact(output, mechanics_)) {
      for (const emit::Group& group : artefact.groups) {
        for (const emit::Field& field : group.fields) {
          for (std::size_t i = 0; i < field.values.size(); ++i) {
            const std::string name = (group.name.empty() ? "" : group.name + ".") + field.name + suffix(field, i);
            add(output, name, unit_in(field.about), field.values[i]);
          }
        }
      }
    }
  }

  /// "[N*m], space axes" → "N*m"
  static std::string unit_in(const std::string& about) {
    const std::size_t end = about.find(']');
    return !about.empty() && about[0] == '[' && end != std::string::npos ? about.substr(1, end - 1) : "";
  }

  void add_status() {
    if (is_true(mechanics_.solution.singular_mass_matrix)) {
      result_.warnings.push_back("the mass matrix is singular here: accelerations cannot be trusted");
    }
    if (is_true(mechanics_.solution.dependent_constraints)) {
      result_.warnings.push_back("constraints depend on each other here: multipliers are not unique");
    }
    for (const auto& row : mechanics_.kinematics.constraints) check_residual(row);
  }

  bool is_true(Expr condition) {
    const auto value = evaluator_(condition.id());
    return value && evaluator_.arithmetic().is_true(*value);
  }

  // Compared with the terms that make the residual up: β_A u^A, so that units do not matter.
  void check_residual(const kinematics::ConstraintRow& row) {
    const auto phi = evaluator_(row.phi.id());
    if (!phi) return;
    cl_F scale = cln::abs(*phi);
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      const auto b = evaluator_(row.beta[mechanics_.symbols.full(i)].id());
      const auto u = evaluator_(mechanics_.graph.use(mechanics_.symbols.speeds[i].symbol));
      if (b && u && cln::abs(*b * *u) > scale) scale = cln::abs(*b * *u);
    }
    const auto& arithmetic = evaluator_.arithmetic();
    if (cln::abs(*phi) <= arithmetic.epsilon() * arithmetic.number(support::Rational(k_residual_slack)) * scale) return;
    result_.warnings.push_back("the initial state violates constraint '" + row.name +
                               "' by " + evaluate::to_decimal(*phi, 3));
  }

  Mechanics& mechanics_;
  int digits_;
  evaluate::Evaluator<cl_F> evaluator_;
  Evaluation result_;
};

}  // namespace

template <class T>
void bind_parameters(Mechanics& mechanics, evaluate::Evaluator<T>& evaluator) {
  const model::Model& model = mechanics.model;
  for (std::size_t i = 0; i < model.parameters.size(); ++i) {
    const auto value = evaluator(mechanics.expressions(model.parameters[i].value).id());
    if (value) evaluator.bind(mechanics.symbols.parameters[i], *value);
  }
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const auto value = evaluator(mechanics.expressions(model.inputs[i].value).id());
    if (value) evaluator.bind(mechanics.symbols.inputs[i], *value);
  }
}

template void bind_parameters(Mechanics&, evaluate::Evaluator<cl_F>&);
template void bind_parameters(Mechanics&, evaluate::Evaluator<double>&);
template void bind_parameters(Mechanics&, evaluate::Evaluator<long double>&);
template void bind_parameters(Mechanics&, evaluate::Evaluator<evaluate::Scaled<cl_F>>&);

Evaluation evaluate_model(Mechanics& mechanics, const support::Rational& time, int digits) {
  return Report(mechanics, time, digits).run();
}

}  // namespace gaussgen
