#include <algorithm>
#include <cmath>

#include "sim/drive/quad.hpp"
#include "sim/model/layout.hpp"
#include "sim/run/drive.hpp"

namespace gausssim {

namespace {

std::vector<std::size_t> slots_of(const std::vector<ResultNumber>& slots, const std::string& name) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].name.rfind(name + "[", 0) == 0 || slots[i].name == name) found.push_back(i);
  }
  return found;
}

template <class S>
double largest(const std::vector<S>& values, const std::vector<std::size_t>& slots, double so_far) {
  for (const std::size_t i : slots) so_far = std::max(so_far, std::abs(static_cast<double>(values[i])));
  return so_far;
}

}  // namespace

template <class S>
DriftMeter<S>::DriftMeter(const Functions<S>& functions, const Described& model) : functions_(functions) {
  const EnergyLayout& energy = functions.energy_layout;
  const std::vector<ResultNumber> residuals = layout_of(model.tree, "Residuals");
  energy_.resize(energy.size);
  residuals_.resize(residuals.size());
  rates_.resize(model.size());
  drift_.has_energy = functions.energy && energy.is_conserved;
  kinetic_ = energy.kinetic;
  total_ = energy.total;
  positions_ = slots_of(residuals, "position");
  // Its unit length is a constraint of positions, which steps leave as they do others.
  const std::vector<std::size_t> lengths = slots_of(residuals, "quaternion");
  positions_.insert(positions_.end(), lengths.begin(), lengths.end());
  velocities_ = slots_of(residuals, "velocity");
  drift_.has_constraints = functions.residuals && !residuals.empty();
}

template <class S>
void DriftMeter<S>::look(const S& t, const S* state) {
  if (drift_.has_energy) look_at_energy(t, state);
  if (drift_.has_constraints) look_at_constraints(t, state);
}

template <class S>
void DriftMeter<S>::go_on_from(const Drift& earlier, const S& start_energy) {
  drift_.energy = earlier.energy;
  drift_.energy_scale = earlier.energy_scale;
  drift_.positions = earlier.positions;
  drift_.velocities = earlier.velocities;
  start_energy_ = start_energy;
  has_start_ = true;
}

template <class S>
void DriftMeter<S>::look_at_energy(const S& t, const S* state) {
  functions_.energy(t, state, energy_.data());
  const S total = energy_[total_];
  if (!has_start_) start_energy_ = total;
  has_start_ = true;
  last_energy_ = static_cast<double>(total - start_energy_);
  drift_.energy = std::max(drift_.energy, std::abs(last_energy_));
  drift_.energy_scale = std::max(drift_.energy_scale, static_cast<double>(energy_[kinetic_]));
}

template <class S>
void DriftMeter<S>::look_at_constraints(const S& t, const S* state) {
  functions_.rates(t, state, rates_.data());
  functions_.residuals(t, state, residuals_.data(), nullptr, rates_.data());
  last_constraints_ = largest(residuals_, velocities_, largest(residuals_, positions_, 0));
  drift_.positions = largest(residuals_, positions_, drift_.positions);
  drift_.velocities = largest(residuals_, velocities_, drift_.velocities);
}

template class DriftMeter<float>;
template class DriftMeter<double>;
template class DriftMeter<long double>;
template class DriftMeter<Quad>;

}  // namespace gausssim
