#pragma once
// What a model answers at a state, computed in any scalar type and handed over in 50 digits, where it can be compared.

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <string>
#include <vector>

#include "gauss/math.hpp"

namespace headertest {

using Wide = boost::multiprecision::cpp_bin_float_50;

struct Sample {
  double t = 0;
  std::vector<double> y;
};

/// Quantities that are measured against the largest of them: what one function finds out at one level.
constexpr std::array<const char*, 6> k_parts{"rates",           "accelerations", "reactions",
                                             "energy",          "projected state", "initial state"};

struct Answer {
  std::array<std::vector<Wide>, k_parts.size()> parts;
  std::vector<gauss::Status> statuses;  ///< of rhs_and_reactions (or rhs), energy, project, initial_state
};

constexpr std::size_t k_project = 2;  ///< among the statuses

/// All went well, but for one thing: the one Newton step of `project` may leave something of a nonlinear constraint, and
/// says so.
template <class Statuses>
bool all_ok(const Statuses& statuses) {
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    const bool is_on_the_way = i == k_project && statuses[i] == gauss::Status::violated_constraints;
    if (statuses[i] != gauss::Status::ok && !is_on_the_way) return false;
  }
  return true;
}

/// An emitted model in one scalar type.
struct Computed {
  std::string name;
  int n_q = 0;
  int n_v = 0;
  std::function<std::vector<Answer>(const std::vector<Sample>&)> answers;
};

/// All models as emitted by default; defined where T is float, double, long double, __float128, Wide,
/// a batch or Lane.
template <class T>
std::vector<Computed> plain_models();

/// How far a state determines its answers: the change of each part, relative to that of everything that it is computed
/// from (time, state, parameters, inputs), when these change at random by 1e-20. In the order of plain_models.
using Sensitivity = std::function<std::array<Wide, k_parts.size()>(const Sample&)>;
std::vector<Sensitivity> sensitivities();

inline Wide largest(const std::vector<Wide>& values) {
  Wide result = 0;
  for (const Wide& value : values) {
    if (!(abs(value) <= result)) result = abs(value);
  }
  return result;
}

/// Not less than any difference, and NaN where there is one.
inline Wide largest_difference(const std::vector<Wide>& a, const std::vector<Wide>& b) {
  std::vector<Wide> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b.at(i));
  return largest(differences);
}

}  // namespace headertest
