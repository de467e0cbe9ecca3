#include "gauss/oracle/bare_case.hpp"

#include <random>

#include "gauss/oracle/evaluation.hpp"

namespace gaussgen::oracle {

namespace {

/// Numbers between 0.2 and 1.2 for parameters, between -1 and 1 for what moves.
Values random_values(const model::Model& model, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> positive(0.2, 1.2);
  std::uniform_real_distribution<double> any(-1, 1);
  Values values;
  for (const auto& parameter : model.parameters) values[parameter.name.text] = positive(engine);
  values["t"] = any(engine);
  for (const auto& coordinate : model.coordinates) {
    values[coordinate.name.text] = any(engine);
    values[coordinate.name.text + "_dot"] = any(engine);
  }
  for (const auto& orientation : model.orientations) {
    Real norm = 0;
    for (const auto& name : orientation.quaternion) norm += pow(values[name.text] = any(engine), 2);
    for (const auto& name : orientation.quaternion) values[name.text] /= sqrt(norm);
    for (const auto& name : orientation.angular_velocity) values[name.text] = any(engine);
  }
  for (const auto& input : model.inputs) values[input.name.text] = any(engine);
  add_formulas(model, values);
  return values;
}

/// y, ẏ by names: rates are name_dot, except for angular velocities, whose coordinate is θ = 0.
void set_state(BareSystem& bare, const Values& v, const std::vector<std::string>& free) {
  for (const std::string& name : free) {
    const bool is_rotation = name[0] == 'w';
    bare.y.push_back(is_rotation ? Real(0) : v.at(name));
    bare.rate.push_back(v.at(is_rotation ? name : name + "_dot"));
  }
  bare.free_count = free.size();
}

}  // namespace

void hold(BareSystem& bare, const std::function<Real(const Real& t)>& c) {
  const Real h("1e-12");
  bare.y.push_back(c(bare.t));
  bare.rate.push_back((c(bare.t + h) - c(bare.t - h)) / (2 * h));
  bare.held_acceleration.push_back((c(bare.t + h) - 2 * c(bare.t) + c(bare.t - h)) / (h * h));
}

Case start(const model::Model& model, unsigned seed, const std::vector<std::string>& free) {
  Case c{model, random_values(model, seed), {}};
  c.bare.t = c.values.at("t");
  set_state(c.bare, c.values, free);
  return c;
}

}  // namespace gaussgen::oracle
