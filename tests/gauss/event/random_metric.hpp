#pragma once

#include <cstddef>
#include <random>
#include <vector>

/// Symmetric and positive definite, n × n.
inline std::vector<double> random_metric(std::mt19937& engine, std::size_t n) {
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<double> root(n * n), metric;
  for (double& one : root) one = any(engine);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      double sum = i == j ? 0.5 : 0;
      for (std::size_t k = 0; k < n; ++k) sum += root[i * n + k] * root[j * n + k];
      metric.push_back(sum);
    }
  return metric;
}
