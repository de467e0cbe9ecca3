#pragma once
// The settings that a study tries, and what became of each.

#include <optional>
#include <string>
#include <vector>

#include "sim/run/error_estimate.hpp"
#include "sim/run/simulate.hpp"

namespace gausssim {

/// A setting of one of the forms in which the motion is described.
struct Candidate {
  std::size_t form = 0;
  Setting setting;
  bool is_default = false;
  double share_of_time = 1;  ///< until this part of the budget is over it may run
};

enum class PointStatus { ok, failed, refused };

/// One run, repeated.
struct Point {
  int id = 0;
  Candidate candidate;
  PointStatus status = PointStatus::ok;
  std::string why;  ///< of a failure
  std::optional<DeliveredError> error;
  double time = 0, least_time = 0, most_time = 0;  ///< s of the processor
  int repeats = 0;
  long calls = 0, steps = 0, rejected = 0;
  Drift drift;
  bool is_on_front = false;
};

/// Which points no other one beats in both, error and time: of the ones that are ok.
void mark_front(std::vector<Point>& points);

/// Of those that delivered `error` at most, the one that took least time; null if none did.
const Point* cheapest(const std::vector<Point>& points, double error);

}  // namespace gausssim
