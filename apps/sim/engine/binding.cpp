#include "sim/engine/binding.hpp"

#include <initializer_list>

#include "sim/engine/interpreted.hpp"
#include "sim/engine/result_layouts.hpp"
#include "sim/model/layout.hpp"

namespace gausssim {

namespace cpp = gaussgen::emit::cpp;

namespace {

ArgumentIs place_of(const cpp::Argument& argument, bool has_result) {
  const std::string& type = argument.type;
  if (type == "const S&") return ArgumentIs::time;
  if (type == "const State<S>&") return ArgumentIs::state;
  if (type == "const Inputs<S>&") return ArgumentIs::inputs;
  if (type == "const Prepared<S>&") return ArgumentIs::prepared;
  if (type == "const Derivative<S>&") return ArgumentIs::accelerations;
  return has_result ? ArgumentIs::second_result : ArgumentIs::first_result;
}

/// At least one number, so that there is an address.
template <class S>
std::vector<S> room_for(std::size_t count) {
  return std::vector<S>(count == 0 ? 1 : count, S(0));
}

/// By equations, or by the length of quaternions, which have a coordinate more than speeds.
bool is_constrained(const Described& model) {
  return model.n_q() != model.n_v() || !model.unit.constraints.empty() || !layout_of(model.tree, "Residuals").empty();
}

}  // namespace

template <class S>
Callable<S> callable(const Engine& engine, const Described& model, const std::string& function) {
  const cpp::Function* const found = find_function(model.tree, function);
  const Entry entry = found == nullptr ? Entry{} : engine.find(function, scalar_name<S>());
  if (!entry) return {};
  std::vector<ArgumentIs> places;
  bool has_result = false;
  for (const cpp::Argument& argument : found->arguments) {
    places.push_back(place_of(argument, has_result));
    has_result = has_result || places.back() == ArgumentIs::first_result;
  }
  return Callable<S>(entry, std::move(places));
}

template <class S>
std::shared_ptr<Functions<S>> bind(const Engine& engine, const Described& model, const Change<S>& change) {
  auto functions = std::make_shared<Functions<S>>();
  functions->n_q = model.n_q();
  functions->n_v = model.n_v();
  for (const auto& entry : model.unit.configuration) functions->units.push_back(entry.unit);
  for (const auto& entry : model.unit.speeds) functions->units.push_back(entry.unit);
  std::vector<S> parameters = room_for<S>(layout_of(model.tree, "Parameters").size());
  functions->prepared = room_for<S>(layout_of(model.tree, "Prepared").size());
  functions->inputs = room_for<S>(layout_of(model.tree, "Inputs").size());
  // A header without parameters or inputs has no function for them.
  const auto fill = [&](const char* function, std::initializer_list<void*> arguments) {
    if (const Entry entry = engine.find(function, scalar_name<S>())) entry(arguments.begin());
  };
  fill("parameters", {parameters.data()});
  fill("inputs", {functions->inputs.data()});
  if (change) change(parameters), change(functions->inputs);
  functions->parameters = parameters;
  fill("prepare", {parameters.data(), functions->prepared.data()});
  const auto bound = [&](const char* function) {
    Callable<S> found = callable<S>(engine, model, function);
    if (found) found.bind(functions->prepared.data(), functions->inputs.data());
    return found;
  };
  const auto entry = [&](const char* name) { return engine.find(name, scalar_name<S>()); };
  functions->series = {entry("series_begin"), entry("series_advance"), entry("series_tell"), entry("series_end")};
  functions->gains = {entry("gains_begin"), entry("gains_rates"), entry("gains_end")};
  functions->rates = bound("rhs");
  functions->projection = bound("project");
  functions->positions = bound("project_positions");
  functions->speeds = bound("project_speeds");
  functions->energy = bound("energy");
  functions->residuals = bound("residuals");
  functions->jacobian = bound("jacobian");
  functions->energy_layout = energy_layout_of(model.tree);
  functions->jacobian_layout = jacobian_layout_of(model.tree);
  functions->is_constrained = is_constrained(model);
  return functions;
}

namespace {

/// Of code that has no start: interpreted, as all starts are.
template <class S>
gauss::Status state_by_start(const Described& start, const Functions<S>& functions, Numbers<S>& state) {
  const InterpretedEngine engine(start.tree);
  std::vector<S> prepared = room_for<S>(layout_of(start.tree, "Prepared").size());
  const Entry prepare = engine.find("prepare", scalar_name<S>());
  void* const arguments[] = {const_cast<S*>(functions.parameters.data()), prepared.data()};
  if (prepare) prepare(arguments);
  Callable<S> found = callable<S>(engine, start, "initial_state");
  if (!found) return gauss::Status::ok;
  found.bind(prepared.data(), const_cast<S*>(functions.inputs.data()));
  return found(S(0), nullptr, state.data());
}

}  // namespace

template <class S>
gauss::Status initial_state(const Engine& engine, const Described& model, const Functions<S>& functions,
                            Numbers<S>& state) {
  state.assign(model.size(), S(0));
  if (model.start) return state_by_start(*model.start, functions, state);
  Callable<S> start = callable<S>(engine, model, "initial_state");
  if (!start) return gauss::Status::ok;
  start.bind(const_cast<S*>(functions.prepared.data()), const_cast<S*>(functions.inputs.data()));
  return start(S(0), nullptr, state.data());
}

#define GAUSS_SIM_NUMBER(S)                                                                       \
  template Callable<S> callable(const Engine&, const Described&, const std::string&);             \
  template std::shared_ptr<Functions<S>> bind(const Engine&, const Described&, const Change<S>&); \
  template gauss::Status initial_state(const Engine&, const Described&, const Functions<S>&, Numbers<S>&);
GAUSS_SIM_NUMBER(float)
GAUSS_SIM_NUMBER(double)
GAUSS_SIM_NUMBER(long double)
GAUSS_SIM_NUMBER(Quad)
#undef GAUSS_SIM_NUMBER

}  // namespace gausssim
