#include "symbolic/chart.hpp"

#include "support/assert.hpp"

namespace gaussgen::symbolic {

using model::Model;

Chart::Chart(const Model& model) : time_(declare("t")), frames_(model, *this) {
  scope_.values["pi"] = GiNaC::Pi;
  scope_.values["t"] = time_;
  scope_.dot = [this](const ex& f) { return rate_of(f); };
  scope_.place = [this, &model](const std::string& name) {
    const model::SymbolRef place = model.resolve(name);
    if (place.kind == model::SymbolKind::axis)
      return frames_(place.index / 9).axes[place.index % 3][place.index / 3 % 3];
    if (place.kind == model::SymbolKind::spin) {
      const Placement& placement = frames_(place.index / 3);
      return multiply(placement.axes, placement.omega_body)[place.index % 3];
    }
    return frames_(place.index / 3).origin[place.index % 3];
  };
  for (const model::Table& table : model.tables)
    scope_.tables.emplace(table.name.text, static_cast<unsigned>(scope_.tables.size()));
  declare_constants(model);
  declare_coordinates(model);
  for (const model::Orientation& orientation : model.orientations) declare_orientation(orientation);
  // The held coordinates come last: x^i = y^(n+i).
  for (const model::Coordinate& held : model.coordinates) {
    if (!held.held_at) continue;
    const std::string& name = held.name.text;
    all_.push_back({name, symbols_.at(name), declare(name + "_dot"), declare(name + "_ddot"), (*this)(*held.held_at)});
  }
  declare_speeds(model);
  for (const ChartCoordinate& coordinate : all_) rest_[coordinate.rate] = 0;
}

GiNaC::realsymbol Chart::declare(const std::string& name) {
  const auto [place, is_new] = symbols_.emplace(name, GiNaC::realsymbol(name));
  GAUSS_ASSERT(is_new, "symbol {} twice", name);
  return place->second;
}

void Chart::declare_constants(const Model& model) {
  for (const model::Parameter& parameter : model.parameters) {
    scope_.values[parameter.name.text] = declare(parameter.name.text);
  }
  for (const model::Parameter& parameter : model.parameters) {
    if (parameter.is_formula) formulas_[parameter.name.text] = (*this)(parameter.value);
  }
  for (const model::Input& input : model.inputs) scope_.values[input.name.text] = declare(input.name.text);
}

void Chart::declare_coordinates(const Model& model) {
  for (const model::Coordinate& coordinate : model.coordinates) {
    const std::string& name = coordinate.name.text;
    const GiNaC::realsymbol y = declare(name);
    scope_.values[name] = y;
    if (coordinate.held_at) continue;
    all_.push_back({name, y, declare(name + "_dot"), declare(name + "_ddot"), std::nullopt});
    free_.push_back(name);
  }
}

void Chart::declare_orientation(const model::Orientation& orientation) {
  Quaternion e;
  for (std::size_t i = 0; i < 4; ++i) e[i] = declare(orientation.quaternion[i].text);
  Vector3 theta;
  Vector3 theta_dot;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& name = orientation.angular_velocity[i].text;
    // Not in the table of symbols: θ is 0 in everything that leaves this route.
    const GiNaC::realsymbol angle("theta_" + name);
    const GiNaC::realsymbol rate = declare(name);
    all_.push_back({name, angle, rate, declare(name + "_dot"), std::nullopt});
    free_.push_back(name);
    attitude_origin_[angle] = 0;
    theta[i] = angle;
    theta_dot[i] = rate;
  }
  orientations_.push_back({turned(e, theta, orientation.axes), angular_velocity(theta, theta_dot, orientation.axes)});
  const Attitude& attitude = orientations_.back();
  for (std::size_t i = 0; i < 4; ++i) scope_.values[orientation.quaternion[i].text] = attitude.e[i];
  for (std::size_t i = 0; i < 3; ++i) scope_.values[orientation.angular_velocity[i].text] = attitude.omega[i];
}

void Chart::declare_speeds(const Model& model) {
  for (const model::Speed& speed : model.speeds) scope_.values[speed.name.text] = (*this)(speed.is);
  for (const model::Coordinate& coordinate : model.coordinates) {
    if (coordinate.held_at) continue;
    speeds_.push_back(std::nullopt);
    if (!coordinate.speed) continue;
    const std::string& name = model.speeds[*coordinate.speed].name.text;
    speeds_[FreeIndex{speeds_.size() - 1}] = ChartSpeed{name, scope_.values.at(name)};
  }
  while (speeds_.size() < free_count()) speeds_.push_back(std::nullopt);
}

FullIndex Chart::find(const std::string& label) const {
  for (const FullIndex A : all()) {
    if (all_[A].label == label) return A;
  }
  GAUSS_ASSERT(false, "no coordinate {}", label);
  return {};
}

Vector3 Chart::operator()(const std::array<model::Ast, 3>& ast) const {
  return {(*this)(ast[0]), (*this)(ast[1]), (*this)(ast[2])};
}

ex Chart::rate_of(const ex& f) const {
  GiNaC::exvector terms{f.diff(time_)};
  for (const ChartCoordinate& coordinate : all_) {
    terms.push_back(f.diff(coordinate.y) * coordinate.rate);
    terms.push_back(f.diff(coordinate.rate) * coordinate.acceleration);
  }
  return GiNaC::add(terms);
}

Vector3 Chart::rate_of(const Vector3& v) const { return {rate_of(v[0]), rate_of(v[1]), rate_of(v[2])}; }

ex Chart::at_attitude(const ex& f) const {
  return attitude_origin_.empty() ? f : f.subs(attitude_origin_, GiNaC::subs_options::no_pattern);
}

ex Chart::at_rest(const ex& f) const { return f.subs(rest_, GiNaC::subs_options::no_pattern); }

}  // namespace gaussgen::symbolic
