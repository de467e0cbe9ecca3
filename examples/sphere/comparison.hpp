#pragma once
// Errors of a run against the closed form.

#include <string>
#include <vector>

#include "run.hpp"

namespace sphere {

/// A quantity that both sides know.
struct Output {
  const char* name;
  const char* unit;
  double (*of)(const Motion&);
  bool is_reaction;
};

const std::vector<Output>& outputs();

/// Largest error of each output over the run, in the order of outputs(), relative to the largest value that the output takes
/// in the closed form. The tangential reaction is zero there: it is compared with the largest contact force.
struct Errors {
  std::vector<double> outputs;
  double attitude = 0;  ///< angle between the attitudes, rad
  double largest = 0;   ///< of all these
};

/// The closed form at the times of the samples.
std::vector<Sample> closed_form_at(const std::vector<Sample>& samples, const Data& data);

Errors compare(const std::vector<Sample>& samples, const std::vector<Sample>& exact);

/// The same at one instant, the largest of all outputs.
double error_at(const Sample& sample, const Sample& exact, const std::vector<double>& scales);

std::vector<double> scales_of(const std::vector<Sample>& exact);

}  // namespace sphere
