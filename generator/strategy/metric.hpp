#pragma once

#include "strategy/dynamics.hpp"

namespace gaussgen::strategy {

/// G_AB over some of y.
inline Matrix metric_over(const Dynamics& dynamics, const std::vector<std::size_t>& coordinates) {
  Matrix matrix;
  for (const std::size_t i : coordinates) {
    matrix.emplace_back();
    for (const std::size_t j : coordinates) {
      matrix.back().push_back((*dynamics.covariant)->G[kinematics::FullIndex{i}][kinematics::FullIndex{j}]);
    }
  }
  return matrix;
}

inline std::vector<std::string> full_labels(const Dynamics& dynamics, const std::vector<std::size_t>& coordinates) {
  std::vector<std::string> labels;
  for (const std::size_t i : coordinates) {
    labels.push_back(dynamics.kinematics->symbols.label(kinematics::FullIndex{i}));
  }
  return labels;
}

/// G_AB over some of y, factorised; its inverse raises indices there (theory section 1).
class Metric {
 public:
  Metric(const Dynamics& dynamics, std::vector<std::size_t> coordinates, ir::Expr epsilon, Steps& steps)
      : coordinates_(std::move(coordinates)),
        count_(dynamics.kinematics->symbols.full_count()),
        ldl_(begin(dynamics, steps), full_labels(dynamics, coordinates_), "G", epsilon, steps) {}

  /// z with G z = covariant over the chosen coordinates, and 0 for the others.
  Vector solve(const Vector& covariant, const std::string& name, Steps& steps) const {
    Vector chosen;
    for (const std::size_t i : coordinates_) chosen.push_back(covariant[i]);
    const Vector solved = ldl_.solve(chosen, name, steps);
    ir::Graph& graph = covariant[0].graph();
    Vector result(count_, ir::Expr(graph, graph.constant(0)));
    for (std::size_t i = 0; i < coordinates_.size(); ++i) result[coordinates_[i]] = solved[i];
    return result;
  }

  /// Boolean: these coordinates do the same here, to all digits that there are.
  ir::Expr is_singular() const { return ldl_.singular(); }

 private:
  Matrix begin(const Dynamics& dynamics, Steps& steps) const {
    steps.begin("metric G_AB of released coordinates = L D L^T");
    return metric_over(dynamics, coordinates_);
  }

  std::vector<std::size_t> coordinates_;
  std::size_t count_;
  Ldl ldl_;
};

}  // namespace gaussgen::strategy
