#pragma once

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// G_AB over all y, factorised; its inverse raises indices in E_{n+k} (theory section 1).
class FullMetric {
 public:
  FullMetric(const Dynamics& dynamics, ir::Expr epsilon, Steps& steps)
      : ldl_(begin(dynamics, steps), labels(dynamics), "G", epsilon, steps) {}

  Vector solve(const Vector& covariant, const std::string& name, Steps& steps) const {
    return ldl_.solve(covariant, name, steps);
  }

 private:
  static Matrix begin(const Dynamics& dynamics, Steps& steps) {
    steps.begin("full metric G_AB = L D L^T");
    Matrix matrix;
    for (const auto& row : dynamics.covariant->G) matrix.push_back(row.values());
    return matrix;
  }

  static std::vector<std::string> labels(const Dynamics& dynamics) {
    const kinematics::Symbols& symbols = dynamics.kinematics->symbols;
    std::vector<std::string> all;
    for (const auto i : support::indices<kinematics::FullIndex>(symbols.full_count())) all.push_back(symbols.label(i));
    return all;
  }

  Ldl ldl_;
};

}  // namespace gaussgen::strategy
