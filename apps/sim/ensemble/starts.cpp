#include "sim/ensemble/starts.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "gauss/integrate/step_result.hpp"
#include "sim/drive/quad.hpp"
#include "sim/ensemble/philox.hpp"
#include "sim/model/layout.hpp"

namespace gausssim {

template <class S>
Bound<S>::Bound(const Engine& with, const Described& of)
    : engine(with), model(of), functions(bind<S>(with, of)), prepare(with.find("prepare", scalar_name<S>())) {
  parameters.assign(std::max<std::size_t>(1, layout_of(of.tree, "Parameters").size()), S(0));
  if (const Entry usual = with.find("parameters", scalar_name<S>())) {
    void* const arguments[] = {parameters.data()};
    usual(arguments);
  }
  usual_inputs = functions->inputs;
  initial_state = callable<S>(with, of, "initial_state");
  if (initial_state) initial_state.bind(functions->prepared.data(), functions->inputs.data());
}

namespace {

/// Members of emitted structs have the order of the unit; formulas are none.
std::vector<std::string> members(const gaussgen::emit::Unit& unit, bool of_inputs) {
  std::vector<std::string> names;
  for (const auto& input : unit.inputs) {
    if (of_inputs) names.push_back(input.entry.name);
  }
  for (const auto& parameter : unit.parameters) {
    if (!of_inputs && !parameter.is_formula) names.push_back(parameter.entry.name);
  }
  return names;
}

}  // namespace

template <class S>
PlannedStarts<S>::PlannedStarts(const Plan& plan, const std::vector<Placed>& places, const Described& model)
    : plan_(plan), places_(places) {
  for (const Placed& place : places_) {
    const std::vector<std::string> names = members(model.unit, place.is_input);
    const auto found = std::find(names.begin(), names.end(), place.name);
    if (found == names.end()) throw std::logic_error("emitted code has no '" + place.name + "'");
    slots_.push_back(static_cast<std::size_t>(found - names.begin()));
  }
}

template <class S>
gauss::Status PlannedStarts<S>::begin(long trajectory, Bound<S>& bound, Numbers<S>& state) const {
  const std::vector<double> values = plan_.values(trajectory);
  for (std::size_t i = 0; i < values.size(); ++i)
    (places_[i].is_input ? bound.functions->inputs : bound.parameters)[slots_[i]] = S(values[i]);
  if (bound.prepare) {
    void* const arguments[] = {bound.parameters.data(), bound.functions->prepared.data()};
    bound.prepare(arguments);
  }
  state.assign(bound.model.size(), S(0));
  return bound.initial_state ? bound.initial_state(S(0), nullptr, state.data()) : gauss::Status::ok;
}

template <class S>
gauss::Status PerturbedStarts<S>::begin(long trajectory, Bound<S>& bound, Numbers<S>& state) const {
  const gauss::Status status = initial_state(bound.engine, bound.model, *bound.functions, state);
  if (!gauss::integrate::is_motion_known(status)) return status;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const auto bits = philox({static_cast<std::uint32_t>(trajectory), static_cast<std::uint32_t>(i), 0, 0}, {0, 0});
    const double share = static_cast<double>(bits[0]) * 0x1p-31 - 1;
    const S size = state[i] < S(0) ? -state[i] : state[i];
    state[i] += S(part_ * share) * (size + S(1e-3));
  }
  const auto& onto = bound.functions->projection;
  const Numbers<S> moved = state;
  return onto ? onto(S(0), moved.data(), state.data()) : status;
}

#define GAUSS_SIM_NUMBER(S)        \
  template struct Bound<S>;        \
  template class PlannedStarts<S>; \
  template class PerturbedStarts<S>;
GAUSS_SIM_NUMBER(float)
GAUSS_SIM_NUMBER(double)
GAUSS_SIM_NUMBER(long double)
GAUSS_SIM_NUMBER(Quad)
#undef GAUSS_SIM_NUMBER

}  // namespace gausssim
