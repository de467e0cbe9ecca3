#pragma once
// Models of models/*.yaml and a few harder ones, written a second time as bare points, at random parameters and states.

#include <functional>
#include <string>
#include <vector>

#include "gauss/oracle/bare_system.hpp"
#include "model/model.hpp"

namespace gaussgen::oracle {

/// One state of one model, in both descriptions.
struct Case {
  model::Model model;
  Values values;  ///< every parameter, state variable, input and t
  BareSystem bare;
};

struct BareModel {
  std::string name;
  std::function<Case(unsigned seed)> at;
};

/// All of them: sphere_in_cylinder, its quaternion form, skew_chart, skew_nonholonomic, driven_gyroscope,
/// free_body_in_space, free_body_in_body_axes, coupled_drives, released_top.
std::vector<BareModel> bare_models();

Case case_of(const std::string& name, unsigned seed);

}  // namespace gaussgen::oracle
