#include "comparison.hpp"

#include <algorithm>

namespace sphere {

const std::vector<Output>& outputs() {
  static const std::vector<Output> k_outputs{
      {"height", "m", [](const Motion& m) { return m.z; }, false},
      {"rate of climb", "m/s", [](const Motion& m) { return m.z_dot; }, false},
      {"azimuth", "rad", [](const Motion& m) { return m.chi; }, false},
      {"rate of azimuth", "rad/s", [](const Motion& m) { return m.chi_dot; }, false},
      {"angular velocity, radial", "rad/s", [](const Motion& m) { return m.omega[0]; }, false},
      {"angular velocity, tangential", "rad/s", [](const Motion& m) { return m.omega[1]; }, false},
      {"angular velocity, axial", "rad/s", [](const Motion& m) { return m.omega[2]; }, false},
      {"reaction, normal", "N", [](const Motion& m) { return m.reaction[0]; }, true},
      {"reaction, tangential", "N", [](const Motion& m) { return m.reaction[1]; }, true},
      {"reaction, axial", "N", [](const Motion& m) { return m.reaction[2]; }, true}};
  return k_outputs;
}

std::vector<Sample> closed_form_at(const std::vector<Sample>& samples, const Data& data) {
  const ClosedForm motion(data);
  AttitudeOfClosedForm attitude(data, attitude_at_start());
  std::vector<Sample> exact;
  for (const Sample& sample : samples) {
    const Quaternion<long double> q = attitude.at(sample.t);
    exact.push_back({sample.t, motion.at(sample.t), {}, gauss::Status::ok});
    std::transform(q.begin(), q.end(), exact.back().attitude.begin(),
                   [](long double x) { return static_cast<double>(x); });
  }
  return exact;
}

std::vector<double> scales_of(const std::vector<Sample>& exact) {
  std::vector<double> scales(outputs().size(), 0.0);
  double largest_reaction = 0;
  for (const Sample& sample : exact) {
    for (std::size_t i = 0; i < scales.size(); ++i) {
      const double size = std::abs(outputs()[i].of(sample.motion));
      scales[i] = std::max(scales[i], size);
      if (outputs()[i].is_reaction) largest_reaction = std::max(largest_reaction, size);
    }
  }
  for (double& scale : scales) {
    if (scale <= 0) scale = largest_reaction;
  }
  return scales;
}

double error_at(const Sample& sample, const Sample& exact, const std::vector<double>& scales) {
  double largest = angle_between(exact.attitude, sample.attitude);
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const Output& output = outputs()[i];
    largest = worse(largest, std::abs(output.of(sample.motion) - output.of(exact.motion)) / scales[i]);
  }
  return largest;
}

Errors compare(const std::vector<Sample>& samples, const std::vector<Sample>& exact) {
  const std::vector<double> scales = scales_of(exact);
  Errors errors;
  errors.outputs.assign(scales.size(), 0.0);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    for (std::size_t i = 0; i < scales.size(); ++i) {
      const Output& output = outputs()[i];
      const double error = std::abs(output.of(samples[k].motion) - output.of(exact[k].motion)) / scales[i];
      errors.outputs[i] = worse(errors.outputs[i], error);
    }
    errors.attitude = worse(errors.attitude, angle_between(exact[k].attitude, samples[k].attitude));
  }
  errors.largest = std::max(errors.attitude, *std::max_element(errors.outputs.begin(), errors.outputs.end()));
  return errors;
}

}  // namespace sphere
