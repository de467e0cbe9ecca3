#pragma once
// What a body contributes to the kinetic energy and to Gauss's function.

#include <vector>

#include "symbolic/chart.hpp"

namespace gaussgen::gauss {

using symbolic::Chart;
using symbolic::ex;
using symbolic::FreeIndex;
using symbolic::FullIndex;
using symbolic::HeldIndex;
using symbolic::Matrix3;
using symbolic::Row;
using symbolic::Table;
using symbolic::Vector3;

/// Over the chart (θ of quaternions still in it).
struct BodyMotion {
  ex mass;
  Vector3 position;  ///< m, of the mass centre, in space
  bool is_rigid = false;
  Vector3 omega;       ///< rad/s, in the axes of `inertia`
  Matrix3 inertia;     ///< kg m², about the mass centre; in body axes unless isotropic
  Vector3 omega_body;  ///< rad/s, in body axes
};

std::vector<BodyMotion> body_motions(const model::Model& model, const Chart& chart);

}  // namespace gaussgen::gauss
