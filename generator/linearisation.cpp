#include "linearisation.hpp"

#include <algorithm>
#include <cmath>

#include "evaluate/decimal.hpp"
#include "model/impossible.hpp"
#include "steady.hpp"

namespace gaussgen {

using analysis::Real;
using cln::cl_F;
using evaluate::Arithmetic;

namespace {

const char* const k_no_motion = "the constraints leave no motion, so there is nothing to linearise";

constexpr int k_digits = 45;

/// Names and units of displacements, then of speeds.
std::vector<LinearState> all_states(const Mechanics& mechanics) {
  const kinematics::Symbols& symbols = mechanics.symbols;
  std::vector<LinearState> states;
  const std::size_t plain = symbols.plain_count();
  for (std::size_t i = 0; i < plain; ++i) {
    const auto& q = symbols.configuration[kinematics::ConfigurationIndex{i}];
    states.push_back({q.name, q.unit, true, i, 0, 0});
  }
  for (const model::Orientation& orientation : mechanics.model.orientations) {
    for (const char axis : {'x', 'y', 'z'})
      states.push_back({orientation.name.text + "_" + axis, "rad", true, states.size(), 0, 0});
  }
  for (const auto& u : symbols.speeds) states.push_back({u.name, u.unit, false, states.size(), 0, 0});
  return states;
}

/// Indices among displacements and speeds.
std::set<std::size_t> indices_of(const std::set<std::string>& names, const Mechanics& mechanics) {
  const kinematics::Symbols& symbols = mechanics.symbols;
  const std::size_t plain = symbols.plain_count(), n = symbols.speeds.size();
  std::set<std::size_t> result;
  for (const auto i : symbols.configuration.indices()) {
    if (names.count(symbols.configuration[i].name) == 0) continue;
    if (i.value < plain) {
      result.insert(i.value);
    } else {
      const std::size_t orientation = (i.value - plain) / 4;
      for (std::size_t axis = 0; axis < 3; ++axis) result.insert(plain + 3 * orientation + axis);
    }
  }
  for (const auto a : symbols.speeds.indices()) {
    if (names.count(symbols.speeds[a].name) != 0) result.insert(n + a.value);
  }
  return result;
}

class Lineariser {
 public:
  Lineariser(Mechanics& mechanics, const LinearisationOptions& options)
      : mechanics_(mechanics),
        options_(options),
        equations_(mechanics),
        fine_(mechanics, equations_, options.time, Arithmetic<cl_F>(k_digits)),
        rough_(mechanics, equations_, options.time, Arithmetic<double>()) {}

  Linearisation run() {
    if (!fine_.start()) return failed("the initial state is undefined: " + fine_.trouble());
    auto numbers = fine_.numbers();
    if (!numbers) return failed("at the initial state a value is undefined: " + fine_.trouble());
    IndependentChoice choice = choose(options_.preferences, *numbers);
    if (choice.all.empty()) return failed(k_no_motion);
    if (options_.at == LinearisedAt::steady) {
      const std::string why = search(choice);
      if (!why.empty()) return failed(why);
      numbers = fine_.numbers();
      if (!numbers) return failed("at the steady motion a value is undefined: " + fine_.trouble());
      choice = choose(options_.preferences, *numbers);
      if (choice.all.empty()) return failed(k_no_motion);
    }
    const auto motion = reduce(*numbers, choice);
    if (!motion) return failed("constraints do not determine what they ought to, to all digits that there are");
    doubt_state();
    add_states(*numbers, choice);
    result_.A = motion->A;
    result_.B = motion->B;
    result_.modes = analysis::modes(result_.A);
    judge(*motion, choice);
    return std::move(result_);
  }

 private:
  Linearisation failed(const std::string& why) {
    result_.failure = why;
    return std::move(result_);
  }

  void set_rough() {
    std::vector<double> state;
    for (const cl_F& value : fine_.state()) state.push_back(evaluate::to_double(value));
    rough_.set(std::move(state));
  }

  std::string search(const IndependentChoice& choice) {
    set_rough();
    return find_steady(rough_, fine_, choice, indices_of(options_.fixed, mechanics_));
  }

  // Of the state of the model, as `evaluate` says it.
  void doubt_state() {
    const auto is_true = [this](ir::Expr condition) {
      const auto value = fine_.values({condition});
      return value && !cln::zerop(value->front());
    };
    if (is_true(mechanics_.solution.singular_mass_matrix)) {
      result_.doubts.emplace_back("singular_mass_matrix");
      result_.warnings.emplace_back("the mass matrix is singular here: accelerations cannot be trusted");
    }
    if (is_true(mechanics_.solution.dependent_constraints)) {
      result_.warnings.emplace_back(
          "constraints follow from each other here; what they leave independent is not touched by that");
    }
    bool has_impossible = false;
    for (const support::Diagnostic& found : model::impossible_bodies(mechanics_.model)) {
      result_.warnings.push_back(found.message);
      has_impossible = has_impossible || found.severity == support::Severity::error;
    }
    if (has_impossible) result_.doubts.emplace_back("impossible_bodies");
    const auto residuals = fine_.numbers();
    const Real left =
        std::max<Real>(residuals->positions.size() == 0 ? 0 : residuals->positions.lpNorm<Eigen::Infinity>(),
                       residuals->velocities.size() == 0 ? 0 : residuals->velocities.lpNorm<Eigen::Infinity>());
    if (left > 1e-8L) {
      result_.doubts.emplace_back("violated_constraints");
      result_.warnings.emplace_back("the state does not satisfy the constraints");
    }
  }

  void add_states(const LinearNumbers& numbers, const IndependentChoice& choice) {
    std::vector<LinearState> states = all_states(mechanics_);
    const std::size_t n = mechanics_.symbols.speeds.size(), plain = mechanics_.symbols.plain_count();
    const std::size_t n_q = mechanics_.symbols.configuration.size();
    for (LinearState& state : states) {
      state.rate = numbers.rates[static_cast<Eigen::Index>(state.index)];
      const bool is_turn = state.is_coordinate && state.index >= plain;
      if (!is_turn) state.value = to_real(fine_.state()[state.is_coordinate ? state.index : n_q + state.index - n]);
    }
    for (const std::size_t i : choice.all) result_.states.push_back(states[i]);
    for (const std::size_t i : choice.positions.dependent) result_.dependent.push_back(states[i].name);
    for (const std::size_t i : choice.speeds.dependent) result_.dependent.push_back(states[n + i].name);
    for (const model::Input& input : mechanics_.model.inputs) result_.inputs.push_back(input.name.text);
  }

  void judge(const ReducedMotion& motion, const IndependentChoice& choice) {
    result_.cyclic = cyclic_coordinates(motion, choice);
    result_.changing = changing(motion, result_.cyclic, choice);
    result_.is_at_rest = result_.is_steady();
    for (std::size_t k = 0; k < choice.position_count(); ++k)
      result_.is_at_rest = result_.is_at_rest && !moves(motion, k);
    if (!result_.is_steady()) {
      result_.warnings.emplace_back(
          "this is neither an equilibrium nor a steady motion: A and B are those of this instant");
      return;
    }
    set_rough();
    if (!goes_on(rough_, choice, result_.cyclic, options_.time))
      result_.warnings.emplace_back("the motion does not go on as it is: A and B are those of this instant");
  }

  Mechanics& mechanics_;
  LinearisationOptions options_;
  LinearEquations equations_;
  StatePoint<cl_F> fine_;
  StatePoint<double> rough_;
  Linearisation result_;
};

}  // namespace

Linearisation linearise(Mechanics& mechanics, const LinearisationOptions& options) {
  if (mechanics.dynamics.n() == 0) {
    Linearisation result;
    result.failure = "no coordinate is free: there is nothing to linearise";
    return result;
  }
  return Lineariser(mechanics, options).run();
}

}  // namespace gaussgen
