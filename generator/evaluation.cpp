#include "evaluation.hpp"

#include <algorithm>

#include "dependence.hpp"
#include "described_motion.hpp"
#include "description.hpp"
#include "evaluate/decimal.hpp"
#include "general_solution.hpp"
#include "ir/differentiate.hpp"
#include "ir/substitute.hpp"
#include "model/impossible.hpp"
#include "model_values.hpp"
#include "strategy/projection.hpp"
#include "vanishing_gradient.hpp"
#include "violation.hpp"

namespace gaussgen {

using cln::cl_F;
using ir::Expr;
using ir::NodeId;

namespace {

const char* const k_about_multipliers =
    "multipliers: lambda of (3.4): a constraint phi = 0 adds lambda * dphi/du to the equation of motion of each speed "
    "u.";

const char* const k_about_wanted =
    "wanted: accelerations are those at the inputs given; reactions, forces and moments are those of the wanted "
    "motion, made "
    "by what is missing.";

// Where names in phi have no units; a power is lambda * phi in all of them.
const char* const k_unit_of_multiplier = "power per phi: N where phi is in m/s, N*m where it is in rad/s";

constexpr int k_beyond_digits = 5;
constexpr int k_digits_of_double = 16;
constexpr int k_violated_digits = 8;

bool has_open_positions(Mechanics& mechanics) {
  const std::vector<bool> open = strategy::open_positions(mechanics.model, mechanics.expressions);
  return std::find(open.begin(), open.end(), true) != open.end();
}

/// An equation that an open position does not satisfy in all digits, as where roots lie side by side.
const kinematics::ConstraintRow* not_reached(Mechanics& mechanics, ModelValues& values, int digits) {
  if (!has_open_positions(mechanics)) return nullptr;
  const cl_F rounding = values.number(cln::expt(support::Rational(10), -digits - k_beyond_digits));
  for (const auto& row : mechanics.kinematics.constraints) {
    const auto left = row.f ? values.relative_residual(row.f->id()) : std::nullopt;
    if (left && *left > rounding) return &row;
  }
  return nullptr;
}

class Report {
 public:
  Report(Mechanics& mechanics, const support::Rational& time, int digits,
         const std::optional<WantedAccelerations>& wanted, const std::optional<RestingMultipliers>& resting)
      : mechanics_(mechanics),
        digits_(digits),
        value_of_(mechanics, time, digits),
        wanted_(wanted),
        resting_(resting),
        singular_mass_matrix_(singular_mass_matrix()) {}

  Evaluation run() {
    warn_of_parameters();
    if (!set_state()) return std::move(result_);
    dependences_ = dependences(mechanics_, value_of_);
    if (resting_) {
      take_rest();
    } else if (!dependences_.empty() || is_lost()) {
      take_general_solution();
    }
    add_accelerations();
    if (wanted_) take_wanted_accelerations();
    add_reactions();
    add_groups("reaction_forces");
    add_groups("joint_reactions");
    add_groups("energy");
    add_groups("residuals");
    if (!rests_without_mass()) add_groups("compulsion");
    add_groups("quantities");
    add_status();
    if (wanted_) add_inverse_dynamics();
    return std::move(result_);
  }

 private:
  // A place where forces balance is found, not given: what would vanish there has the digits of the answer and no more.
  Expr singular_mass_matrix() const {
    const Expr singular = mechanics_.solution.singular_mass_matrix;
    if (!resting_) return singular;
    ir::Substitution rounded(mechanics_.graph);
    rounded.replace(mechanics_.symbols.epsilon, mechanics_.expressions.number(cln::expt(
                                                    support::Rational(10), -std::max(digits_, k_digits_of_double))));
    return rounded(singular);
  }

  void add(const std::string& group, const std::string& name, const Description& description, NodeId node) {
    const auto& [unit, about] = description;
    const std::optional<cl_F> value = ought_to_vanish(group) ? value_of_.residual(node, digits_) : value_of_(node);
    if (value) {
      result_.values.push_back({group, name, unit, about, evaluate::to_decimal(*value, digits_), true});
      return;
    }
    const auto trouble = value_of_.trouble(node);
    result_.values.push_back({group, name, unit, about, trouble->reason + " in " + trouble->name, false});
    doubt("not_finite");
  }

  // Where the model rests, forces in balance leave what the last digit of the position makes of them.
  bool ought_to_vanish(const std::string& group) const {
    return group == "residuals" || (resting_ && (group == "reactions" || group == "joint_reactions"));
  }

  /// Then nothing can be raised by the metric, as Z asks for.
  bool rests_without_mass() { return resting_ && value_of_.is_true(singular_mass_matrix_); }

  void doubt(const std::string& status) {
    if (std::find(result_.doubts.begin(), result_.doubts.end(), status) == result_.doubts.end()) {
      result_.doubts.push_back(status);
    }
  }

  // A model file with such values is refused; here they may have been set.
  void warn_of_parameters() {
    for (const model::Parameter& parameter : mechanics_.model.parameters) {
      const NodeId node = mechanics_.expressions(parameter.value).id();
      const auto trouble = value_of_.trouble(node);
      if (trouble) result_.warnings.push_back("parameter " + parameter.name.text + " is undefined: " + trouble->reason);
    }
    for (const support::Diagnostic& found : model::impossible_bodies(mechanics_.model)) {
      result_.warnings.push_back(found.message);
      if (found.severity == support::Severity::error) doubt("impossible_bodies");
    }
  }

  // Time and what it determines come first: reactions depend on them as on the state.
  void add_time() {
    add("state", "t", {"s", "time"}, mechanics_.expressions.symbol(mechanics_.symbols.time).id());
    for (const kinematics::HeldCoordinate& held : mechanics_.symbols.held) {
      const model::Coordinate& coordinate = mechanics_.model.coordinates[held.model_index];
      add("state", held.name, {coordinate.unit, "held at this time"}, mechanics_.expressions(*coordinate.held_at).id());
    }
  }

  bool set_state() {
    add_time();
    const std::vector<InitialValue> state = initial_values(mechanics_, value_of_);
    const bool is_defined = bind_initial_values(mechanics_, state, value_of_);
    if (is_defined) refine_initial_values(mechanics_, digits_, value_of_);
    for (const InitialValue& value : state) {
      const NodeId bound = mechanics_.graph.use(value.symbol);
      add("state", value.name, {value.unit, ""}, is_defined ? bound : value.node);
    }
    if (!is_defined) result_.warnings.push_back("the initial state is undefined");
    return is_defined;
  }

  // Residuals at acceleration level and the compulsion are evaluated at these.
  void add_accelerations() {
    std::vector<std::pair<ir::SymbolId, NodeId>> found;
    for (const auto i : mechanics_.symbols.speeds.indices()) {
      const auto& u = mechanics_.symbols.speeds[i];
      const NodeId node = mechanics_.solution.accelerations[i.value].id();
      add("accelerations", u.acceleration_name, {u.unit.empty() ? "" : u.unit + "^2", ""}, node);
      found.emplace_back(u.acceleration, node);
    }
    if (!value_of_.bind(found))
      result_.warnings.push_back("accelerations are undefined here: the coordinates may be singular");
  }

  /// Where inertia alone determines too little, or has been divided by, constraints may determine the rest.
  bool is_lost() {
    const strategy::Solution& solution = mechanics_.solution;
    const auto is_undefined = [this](Expr a) { return !value_of_(a.id()); };
    return mechanics_.dynamics.l() > 0 &&
           (value_of_.is_true(solution.singular_mass_matrix) ||
            std::any_of(solution.accelerations.begin(), solution.accelerations.end(), is_undefined));
  }

  /// As emitted code does where its own way is lost.
  void take_general_solution() {
    const bool agree = std::all_of(dependences_.begin(), dependences_.end(),
                                   [](const Dependence& found) { return found.agreement == Agreement::agree; });
    const auto found = agree ? general_solution(mechanics_, value_of_, dependences_) : std::nullopt;
    if (agree && !found && !dependences_.empty() && is_undetermined(mechanics_, value_of_, dependences_)) {
      result_.warnings.push_back(
          "neither inertia nor the constraints that say something here determine all accelerations");
      doubt("singular_mass_matrix");
    }
    if (!found) return;
    for (const auto a : mechanics_.symbols.speeds.indices())
      mechanics_.solution.accelerations[a.value] = mechanics_.expressions.number(found->accelerations[a.value]);
    take_multipliers(found->multipliers);
    is_general_ = true;
    is_motion_known_ = depend_as_usual();
  }

  bool depend_as_usual() const {
    return std::all_of(dependences_.begin(), dependences_.end(),
                       [](const Dependence& one) { return one.everywhere && one.agreement == Agreement::agree; });
  }

  void take_multipliers(const std::vector<support::Rational>& multipliers) {
    for (std::size_t mu = 0; mu < multipliers.size(); ++mu)
      mechanics_.solution.multipliers[mu] = mechanics_.expressions.number(multipliers[mu]);
    mechanics_.solution.motion.reset();
    strategy::Steps steps;
    mechanics_.held_reactions =
        strategy::held_reactions(mechanics_.model, mechanics_.dynamics, mechanics_.solution, steps);
  }

  void take_rest() {
    if (!describes_all_motion(mechanics_, value_of_)) {
      result_.warnings.push_back(
          "the coordinates do not describe every motion here: along the others, forces may be out of balance");
      doubt("singular_mass_matrix");
    } else if (rests_without_mass()) {
      result_.warnings.push_back("the mass matrix is singular here: in motion, accelerations cannot be trusted");
    }
    for (const auto a : mechanics_.symbols.speeds.indices())
      mechanics_.solution.accelerations[a.value] =
          ir::partial(mechanics_.kinematics.speeds_at_rest[a], mechanics_.symbols.time);
    const auto least =
        dependences_.empty() ? std::nullopt : least_multipliers(mechanics_, value_of_, dependences_, *resting_);
    take_multipliers(least.value_or(*resting_));
    is_motion_known_ = depend_as_usual();
  }

  // From here on everything is about the motion that is wanted, made by the forces `missing`: the least ones leave multipliers as they
  // are, while held coordinates and joints carry what this motion takes.
  void take_wanted_accelerations() {
    strategy::Vector wanted;
    std::vector<std::size_t> open;
    for (const auto& speed : mechanics_.symbols.speeds) {
      const auto found = wanted_->find(speed.acceleration_name);
      if (found == wanted_->end()) open.push_back(wanted.size());
      wanted.push_back(mechanics_.expressions.number(found == wanted_->end() ? support::Rational(0) : found->second));
    }
    strategy::Steps steps;
    const strategy::Vector completed =
        strategy::completed_accelerations(mechanics_.dynamics, wanted, open, mechanics_.epsilon(), steps);
    // Where the named ones determine all others and more, nothing is least.
    if (!want(completed)) want(wanted);
    mechanics_.solution.motion.reset();
    strategy::Vector& accelerations = mechanics_.solution.accelerations;
    for (const auto i : mechanics_.symbols.speeds.indices())
      accelerations[i.value] = mechanics_.expressions.symbol(mechanics_.symbols.speeds[i].acceleration);
    mechanics_.held_reactions =
        strategy::held_reactions(mechanics_.model, mechanics_.dynamics, mechanics_.solution, steps);
  }

  void add_inverse_dynamics() {
    for (const auto& speed : mechanics_.symbols.speeds) {
      add("wanted", speed.acceleration_name, {speed.unit.empty() ? "" : speed.unit + "^2", ""},
          mechanics_.expressions.symbol(speed.acceleration).id());
    }
    warn_of_impossible_accelerations();
    result_.notes.push_back(k_about_wanted);
    for (const emit::Artefact& artefact : build_artefact("inverse_dynamics", mechanics_)) {
      add_artefact("inverse_dynamics", artefact);
      warn_of_drives(artefact.status);
      if (result_.doubts.empty()) warn_of_reached(artefact);
    }
  }

  void warn_of_reached(const emit::Artefact& artefact) {
    for (const emit::Field& field : artefact.groups.front().fields) {
      if (field.name != "reached") continue;
      for (const auto i : mechanics_.symbols.speeds.indices())
        warn_of_reached(mechanics_.symbols.speeds[i], field.values[i.value]);
    }
  }

  // Only of what was asked for: the others are 0 for want of a better value.
  void warn_of_reached(const kinematics::Speed& speed, NodeId reached) {
    if (wanted_->count(speed.acceleration_name) == 0) return;
    const Expr wanted = mechanics_.expressions.symbol(speed.acceleration);
    const auto gap = value_of_.residual((Expr(mechanics_.graph, reached) - wanted).id(), digits_);
    const auto value = value_of_(reached);
    if (!gap || !value || cln::zerop(*gap)) return;
    result_.warnings.push_back("the inputs that are needed make " + speed.acceleration_name + " " +
                               evaluate::to_decimal(*value, 3) + ": they cannot make all that is wanted");
  }

  void warn_of_drives(const emit::StatusNodes& status) {
    const bool is_known =
        std::find(result_.doubts.begin(), result_.doubts.end(), "dependent_constraints") != result_.doubts.end();
    if (is_known || !value_of_.is_true(Expr(mechanics_.graph, status.dependent_constraints))) return;
    const std::size_t before = result_.warnings.size();
    for (const std::size_t input : sought_inputs(mechanics_.model)) warn_of_idle(input);
    if (result_.warnings.size() == before) {
      result_.warnings.push_back(
          "inputs do the same here, or what the constraints do: those that are needed are not unique");
    }
    doubt("dependent_constraints");
  }

  void warn_of_idle(std::size_t input) {
    const strategy::Vector& f = mechanics_.dynamics.f;
    const bool acts = std::any_of(f.begin(), f.end(), [&](Expr force) {
      const auto rate = value_of_.residual(ir::partial(force, mechanics_.symbols.inputs[input]).id(), digits_);
      return !rate || !cln::zerop(*rate);
    });
    if (!acts) {
      result_.warnings.push_back("input '" + mechanics_.model.inputs[input].name.text +
                                 "' acts along no free speed here: what it has to be is not determined");
    }
  }

  bool want(const strategy::Vector& accelerations) {
    std::vector<std::pair<ir::SymbolId, NodeId>> given;
    for (const auto i : mechanics_.symbols.speeds.indices())
      given.emplace_back(mechanics_.symbols.speeds[i].acceleration, accelerations[i.value].id());
    return value_of_.bind(given);
  }

  void warn_of_impossible_accelerations() {
    const strategy::Dynamics& dynamics = mechanics_.dynamics;
    for (std::size_t mu = 0; mu < dynamics.l(); ++mu) {
      Expr sum = dynamics.b_drift[mu];
      for (std::size_t i = 0; i < dynamics.n(); ++i)
        sum += dynamics.b[mu][i] *
               mechanics_.expressions.symbol(mechanics_.symbols.speeds[kinematics::FreeIndex{i}].acceleration);
      const auto residual = value_of_.residual(sum.id(), digits_);
      if (!residual || cln::zerop(*residual)) continue;
      result_.warnings.push_back("the wanted accelerations violate constraint '" + dynamics.constraints[mu] + "' by " +
                                 evaluate::to_decimal(cln::abs(*residual), 3));
      doubt("violated_constraints");
    }
  }

  void add_reactions() {
    for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
      const std::string& unit = mechanics_.kinematics.constraints[kinematics::ConstraintIndex{mu}].unit;
      add("multipliers", mechanics_.dynamics.constraints[mu], {unit, unit.empty() ? k_unit_of_multiplier : ""},
          mechanics_.solution.multipliers[mu].id());
    }
    if (mechanics_.dynamics.l() > 0) result_.notes.push_back(k_about_multipliers);
    for (const emit::Artefact& artefact : build_artefact("reactions", mechanics_)) {
      if (artefact.name == "reactions") add_held_reactions(artefact);
    }
  }

  void add_held_reactions(const emit::Artefact& artefact) {
    for (const auto i : mechanics_.symbols.held.indices()) {
      const emit::Group& group = artefact.groups.at(mechanics_.dynamics.l() + i.value);
      const emit::Field& field = group.fields.front();
      add("reactions", mechanics_.symbols.held[i].name, describe(group, field), field.values.front());
    }
  }

  /// Of the equations of positions.
  std::string equation(std::size_t index) const {
    for (const auto& row : mechanics_.kinematics.constraints) {
      if (row.f && index-- == 0) return row.name;
    }
    return "";
  }

  /// Which constraint, orientation or speed an entry is about.
  std::string owner(const std::string& output, const emit::Field& field, std::size_t index) const {
    if (output == "inverse_dynamics") return mechanics_.dynamics.labels.at(index);
    if (output != "residuals") return "";
    if (field.name == "position") return equation(index);
    if (field.name == "quaternion") return mechanics_.model.orientations.at(index).name.text;
    return mechanics_.dynamics.constraints.at(index);
  }

  std::string suffix(const std::string& output, const emit::Field& field, std::size_t index) const {
    static const char* const k_axes[] = {"x", "y", "z"};
    if (field.shape.empty()) return "";
    if (const std::string name = owner(output, field, index); !name.empty()) return "." + name;
    if (field.shape[0] == 3 && field.values.size() == 3) return std::string(".") + k_axes[index];
    return "[" + std::to_string(index) + "]";
  }

  /// Of the forces and accelerations along speeds, which differ in their units.
  std::string unit_along(std::size_t speed, const emit::Field& field) const {
    const std::string& unit = mechanics_.symbols.speeds[kinematics::FreeIndex{speed}].unit;
    if (field.name == "missing") return generalized_unit(unit);
    return unit.empty() ? "" : unit + "^2";
  }

  void add_field(const std::string& output, const emit::Group& group, const emit::Field& field) {
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      const std::string name = (group.name.empty() ? "" : group.name + ".") + field.name + suffix(output, field, i);
      Description description = describe(group, field);
      if (output == "inverse_dynamics" && !field.shape.empty()) description.unit = unit_along(i, field);
      add(output, name, description, field.values[i]);
    }
  }

  void add_groups(const std::string& output) {
    for (const emit::Artefact& artefact : build_artefact(output, mechanics_)) {
      if (!artefact.is_part) add_artefact(output, artefact);
    }
  }

  void add_artefact(const std::string& output, const emit::Artefact& artefact) {
    result_.notes.push_back(output + ": " + on_one_line(artefact.about));
    for (const emit::Group& group : artefact.groups) {
      for (const emit::Field& field : group.fields) add_field(output, group, field);
    }
  }

  void add_status() {
    if (!resting_ && !is_general_ && value_of_.is_true(singular_mass_matrix_)) {
      result_.warnings.push_back(
          "the mass matrix is not positive definite here (singular, or some mass is negative): accelerations cannot be "
          "trusted");
      doubt("singular_mass_matrix");
    }
    warn_of_dependence();
    warn_of_vanishing();
    const bool is_beside =
        std::any_of(dependences_.begin(), dependences_.end(), [](const Dependence& found) { return !found.is_exact; });
    if (result_.doubts.empty() || is_beside) warn_of_slow_search();
    for (const Violation& violation : violations(mechanics_, value_of_)) {
      result_.warnings.push_back("the initial state violates constraint '" + violation.row->name + "' by " +
                                 evaluate::to_decimal(violation.residual, 3));
      doubt("violated_constraints");
    }
  }

  void warn_of_vanishing() {
    for (std::size_t mu = 0; mu < mechanics_.dynamics.l(); ++mu) {
      const model::Constraint& row = mechanics_.model.constraints[mu];
      if (row.may_vanish || !has_small_gradient(mechanics_, value_of_, mu) || !vanishes_with_gradient(mechanics_, mu))
        continue;
      result_.warnings.push_back(holds_nothing(row));
      result_.not_unique.clear();
      doubt("dependent_constraints");
    }
  }

  void warn_of_slow_search() {
    const kinematics::ConstraintRow* row = resting_ ? nullptr : not_reached(mechanics_, value_of_, digits_);
    if (row == nullptr) return;
    const cl_F large = value_of_.number(cln::expt(support::Rational(10), -k_violated_digits));
    const bool is_violated = *value_of_.relative_residual(row->f->id()) > large;
    result_.warnings.push_back(
        "the search for the initial position does not come to where '" + row->name +
        "' holds: " + (is_violated ? "it may have no solution" : "constraints depend on each other there"));
    doubt(is_violated ? "violated_constraints" : "dependent_constraints");
  }

  void warn_of_dependence() {
    const std::size_t before = result_.warnings.size();
    for (const Dependence& dependence : dependences_) {
      const std::string contradiction = contradiction_in(mechanics_, dependence);
      result_.warnings.push_back(contradiction.empty()
                                     ? dependence_in(mechanics_, dependence) + " here: multipliers are not unique"
                                     : contradiction + " here: accelerations cannot be trusted");
      if (!contradiction.empty()) doubt("violated_constraints");
    }
    if (dependences_.empty() && !resting_ && !is_general_ &&
        value_of_.is_true(mechanics_.solution.dependent_constraints)) {
      result_.warnings.push_back("constraints depend on each other here: multipliers are not unique");
    }
    if (result_.warnings.size() == before) return;
    if (is_motion_known_) result_.not_unique = groups_of_multipliers();
    doubt("dependent_constraints");
  }

  /// Those that are there.
  std::vector<std::string> groups_of_multipliers() const {
    std::vector<std::string> groups;
    for (const char* const group : {"multipliers", "reactions", "reaction_forces", "joint_reactions"}) {
      // Sums over all constraints on a body are unique.
      const auto is_of_group = [&](const EvaluatedValue& value) {
        return value.group == group && value.name.rfind("on_", 0) != 0;
      };
      if (std::any_of(result_.values.begin(), result_.values.end(), is_of_group)) groups.emplace_back(group);
    }
    return groups;
  }

  Mechanics& mechanics_;
  int digits_;
  ModelValues value_of_;
  std::vector<Dependence> dependences_;
  bool is_general_ = false;       ///< accelerations are those of the general solution
  bool is_motion_known_ = false;  ///< constraints depend on each other as they always do
  const std::optional<WantedAccelerations>& wanted_;
  const std::optional<RestingMultipliers>& resting_;
  Expr singular_mass_matrix_;
  Evaluation result_;
};

}  // namespace

std::vector<std::string> undefined_groups(const Evaluation& evaluation) {
  std::vector<std::string> groups;
  for (const EvaluatedValue& value : evaluation.values) {
    if (!value.is_defined && std::find(groups.begin(), groups.end(), value.group) == groups.end()) {
      groups.push_back(value.group);
    }
  }
  return groups;
}

bool are_others_trusted(const Evaluation& evaluation) {
  const std::vector<std::string> groups = undefined_groups(evaluation);
  const auto is_of_motion = [](const std::string& group) { return group == "state" || group == "accelerations"; };
  return evaluation.doubts == std::vector<std::string>{"not_finite"} &&
         std::none_of(groups.begin(), groups.end(), is_of_motion);
}

bool is_motion_trusted(const Evaluation& evaluation) {
  return !evaluation.not_unique.empty() && evaluation.doubts == std::vector<std::string>{"dependent_constraints"};
}

template <class T>
void bind_parameters(ModelGraph& motion, evaluate::Evaluator<T>& evaluator) {
  const auto bind = [&](const std::vector<ir::NodeId>& given, const std::vector<ir::SymbolId>& symbols) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (const auto value = evaluator(given[i])) evaluator.bind(symbols[i], *value);
    }
  };
  bind(motion.parameter_values(), motion.symbols.parameters);
  bind(motion.input_values(), motion.symbols.inputs);
  // Before they are found: none of them.
  for (const ir::SymbolId reaction : motion.symbols.reactions)
    evaluator.bind(reaction, evaluator.arithmetic().number(support::Rational(0)));
}

template void bind_parameters(ModelGraph&, evaluate::Evaluator<cl_F>&);
template void bind_parameters(ModelGraph&, evaluate::Evaluator<evaluate::Paired>&);
template void bind_parameters(ModelGraph&, evaluate::Evaluator<double>&);
template void bind_parameters(ModelGraph&, evaluate::Evaluator<long double>&);
template void bind_parameters(ModelGraph&, evaluate::Evaluator<evaluate::Scaled<cl_F>>&);
template void bind_parameters(ModelGraph&, evaluate::Evaluator<evaluate::Scaled<double>>&);

bool is_start_reached(Mechanics& mechanics, const support::Rational& time, int digits) {
  if (!has_open_positions(mechanics)) return true;
  ModelValues values(mechanics, time, digits);
  if (!bind_initial_values(mechanics, initial_values(mechanics, values), values)) return true;
  refine_initial_values(mechanics, digits, values);
  return not_reached(mechanics, values, digits) == nullptr;
}

Evaluation evaluate_model(Mechanics& mechanics, const support::Rational& time, int digits,
                          const std::optional<WantedAccelerations>& wanted,
                          const std::optional<RestingMultipliers>& resting) {
  return Report(mechanics, time, digits, wanted, resting).run();
}

}  // namespace gaussgen
