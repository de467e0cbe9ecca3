#pragma once
// A triaxial body with products of inertia, free to turn, for the models that contain it: as text and as bare points.

#include <string>

#include "gauss/oracle/bare_body.hpp"
#include "gauss/oracle/evaluation.hpp"

namespace gaussgen::oracle::skew_top {

// Entries of the section `parameters`.
inline const std::string k_parameters = R"(
  m: {value: 2}
  A: {value: 0.3}
  B: {value: 0.4}
  C: {value: 0.5}
)";

// Of the body: that of body(), whose axes are turned by the cosine 0.6 and the sine 0.8.
inline const std::string k_inertia = R"(
    inertia:
      - [m/3*(0.64*A^2 + 0.36*B^2 + C^2), m/3*0.48*(A^2 - B^2), 0]
      - [m/3*0.48*(A^2 - B^2), m/3*(0.36*A^2 + 0.64*B^2 + C^2), 0]
      - [0, 0, m/3*(A^2 + B^2)]
)";

/// The section `orientations`, with `attitude` and the speeds wx, wy, wz in `frame`.
std::string orientations(const std::string& frame);

Body body(const Values& values);
Quaternion attitude(const Values& values);

}  // namespace gaussgen::oracle::skew_top
