#pragma once
// Random states of a model, the same numbers in every scalar type.

#include <random>

#include "answers.hpp"

namespace headertest {

/// Projected in double until the constraints are satisfied; false if that does not come about.
inline bool project_fully(const Computed& model, Sample& sample) {
  for (int step = 0; step < 20; ++step) {
    const Answer answer = model.answers({sample}).at(0);
    const gauss::Status status = answer.statuses.at(k_project);
    if (status != gauss::Status::ok && status != gauss::Status::violated_constraints) return false;
    const std::vector<Wide>& projected = answer.parts[4];
    for (std::size_t i = 0; i < projected.size(); ++i) sample.y[i] = static_cast<double>(projected[i]);
    if (status == gauss::Status::ok) return true;
  }
  return false;
}

/// Random, then projected, so that quaternions have unit length and constraints hold, then rounded to float.
inline std::vector<Sample> random_samples(const Computed& model, std::size_t count, bool as_float) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<Sample> samples;
  for (int attempt = 0; samples.size() < count && attempt < 1000; ++attempt) {
    Sample sample;
    sample.t = uniform(0, 3);
    for (int i = 0; i < model.n_q; ++i) sample.y.push_back(uniform(-1.5, 1.5));
    for (int i = 0; i < model.n_v; ++i) sample.y.push_back(uniform(-3, 3));
    if (!project_fully(model, sample)) continue;
    if (as_float) {
      sample.t = static_cast<float>(sample.t);
      for (double& value : sample.y) value = static_cast<float>(value);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace headertest
