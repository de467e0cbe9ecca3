#pragma once
// Simulates each generated model, and measures it.

#include <string>
#include <vector>

#include "description.hpp"
#include "operations.hpp"

namespace sphere {

struct Drift {
  double quaternion = 0;  ///< largest |squared norm - 1|
  double velocity = 0;    ///< largest residual of a rolling constraint, m/s
};

struct Run {
  std::vector<Sample> samples;
  Drift before_projection, after_projection;
  long steps = 0;
  long rejected = 0;
  long calls = 0;
  double lowest_height = 0;  ///< over all steps
  double nanoseconds = 0;    ///< of one rhs, median over batches
  Operations operations;     ///< of one rhs
  std::string trouble;       ///< why it ended early; empty if it did not
};

struct Plan {
  double duration = 10;   // s
  double sampling = 0.1;  // s
  double tolerance = 1e-12;
};

Run run_euler(const Plan& plan);
Run run_quaternion(const Plan& plan);

/// What the models start with, for the closed form.
Data data_of_models();
Quaternion<long double> attitude_at_start();

}  // namespace sphere
