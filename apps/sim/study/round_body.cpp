#include "sim/study/round_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "sim/study/places.hpp"

namespace gausssim {

namespace {

using Ways = Eigen::Matrix3Xd;

/// From the mass centre to the contact, in axes of the body.
Ways ways_of(const Motion::Body& body, const std::vector<Place>& contact) {
  Ways ways(3, static_cast<Eigen::Index>(contact.size()));
  for (std::size_t k = 0; k < contact.size(); ++k) {
    const auto& [w, x, y, z] = body.orientation[k];
    const Eigen::Vector3d way = vector_of(contact[k]) - vector_of(body.position[k]);
    ways.col(static_cast<Eigen::Index>(k)) = Eigen::Quaterniond(w, x, y, z).conjugate() * way;
  }
  return ways;
}

struct Spread {
  Eigen::Vector3d sizes;       ///< rising
  Eigen::Matrix3d directions;  ///< columns
};

/// Root mean squares along principal directions.
Spread spread_of(const Ways& ways) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> found(ways * ways.transpose() /
                                                             static_cast<double>(ways.cols()));
  return {found.eigenvalues().cwiseMax(0).cwiseSqrt(), found.eigenvectors()};
}

}  // namespace

std::optional<RoundBody> round_body(const Motion::Body& body, const std::vector<Place>& contact, double rounding) {
  if (body.orientation.empty()) return std::nullopt;
  const Ways ways = ways_of(body, contact);
  const Eigen::RowVectorXd lengths = ways.colwise().norm();
  const double radius = lengths.mean();
  if (!(radius > rounding) || !((lengths.array() - radius).abs().maxCoeff() <= rounding)) return std::nullopt;
  constexpr double k_much = 0.05;  ///< of the radius: less of a circle or of a ball does not tell which it is
  const Spread around_centre = spread_of(ways), around_mean = spread_of(ways.colwise() - ways.rowwise().mean());
  if (around_mean.sizes[2] < k_much * radius) return std::nullopt;
  if (around_centre.sizes[0] <= rounding) {
    const Eigen::Vector3d axis = around_centre.directions.col(0);
    return RoundBody{radius, Place{axis[0], axis[1], axis[2]}};
  }
  if (around_mean.sizes[0] < k_much * radius) return std::nullopt;
  return RoundBody{radius, std::nullopt};
}

}  // namespace gausssim
