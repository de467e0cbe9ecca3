#include "double_root.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "eigen_lists.hpp"

namespace gaussgen {

namespace {

using Vector = std::vector<double>;

class DoubleRoot {
 public:
  DoubleRoot(PositionEquations& equations, const Vector& spans, std::size_t plain)
      : equations_(equations), spans_(spans), plain_(plain) {}

  /// Goes there if it is as near as half of the digits, and a solution.
  void approach() {
    const Vector before = equations_.position();
    const auto left = left_here();
    if (!left) return;
    std::size_t steps = 0;
    while (steps < spans_.size() && goes_on()) ++steps;
    if (steps == 0) return;
    drop_rounding();
    const auto left_there = left_here();
    if (!left_there || *left_there > std::max(*left, k_solved)) equations_.set(before);
  }

 private:
  std::optional<double> left_here() {
    auto here = equations_.linearised();
    if (!here || here->j.empty()) return std::nullopt;
    here->measure_by(spans_);
    return here->left();
  }

  /// One way; false where there is none.
  bool goes_on() {
    const auto here = equations_.linearised();
    if (!here) return false;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(in_spans(*here), Eigen::ComputeThinU | Eigen::ComputeThinV);
    for (Eigen::Index k = svd.singularValues().size() - 1; k >= 0; --k)
      if (moves_along(svd.matrixU().col(k), svd.matrixV().col(k), svd.singularValues()[k])) return true;
    return false;
  }

  /// Where the singular value is so small beside what it changes by over a span that it is 0 next by.
  bool moves_along(const Eigen::VectorXd& u, const Eigen::VectorXd& v, double size) {
    const Vector before = equations_.position();
    const auto ahead = singular_value(before, u, v, k_part_of_span),
               behind = singular_value(before, u, v, -k_part_of_span);
    const double slope = ahead && behind ? (*ahead - *behind) / (2 * k_part_of_span) : 0;
    equations_.set(before);
    if (!(size > k_exact * std::abs(slope) && size < k_near_double * std::abs(slope))) return false;
    move(v, -size / slope);
    return true;
  }

  std::optional<double> singular_value(const Vector& from, const Eigen::VectorXd& u, const Eigen::VectorXd& v,
                                       double by) {
    equations_.set(from);
    move(v, by);
    const auto there = equations_.linearised();
    return there ? std::optional(u.dot(in_spans(*there) * v)) : std::nullopt;
  }

  void move(const Eigen::VectorXd& v, double by) {
    Vector along = unmapped(by * v);
    for (std::size_t i = 0; i < along.size(); ++i) along[i] *= spans_[i];
    equations_.move(along);
  }

  Eigen::MatrixXd in_spans(const Linearised& at) const {
    return matrix_of(at.j, spans_.size()) * mapped(spans_).asDiagonal();
  }

  void drop_rounding() {
    Vector q = equations_.position();
    for (std::size_t i = 0; i < plain_; ++i)
      if (equations_.movable()[i] && std::abs(q[i]) < k_exact * spans_[i]) q[i] = 0;
    equations_.set(std::move(q));
  }

  static constexpr double k_near_double = 1e-5, k_exact = 1e-12, k_part_of_span = 1e-3;  ///< of spans
  static constexpr double k_solved = 1e-13;                                              ///< f of what it is made of

  PositionEquations& equations_;
  const Vector& spans_;
  std::size_t plain_;
};

}  // namespace

void go_to_double_root(PositionEquations& equations, const std::vector<double>& spans, std::size_t plain) {
  DoubleRoot(equations, spans, plain).approach();
}

}  // namespace gaussgen
