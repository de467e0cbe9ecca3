#pragma once

#include <array>
#include <string>
#include <vector>

#include "emit/plan.hpp"

namespace gaussgen::emit {

/// One value and where it goes.
struct Output {
  NodeId value;
  std::string place;  ///< derivative.chi_dot(), reactions.rod.force[2]
  std::string name;   ///< for a temporary: chi_ddot, rod_force_2
};

/// The outputs of a task, in order, without the status.
std::vector<Output> outputs_of(const Plan& plan, const Task& task);

/// In the order in which Math<S>::status takes its conditions; those that never hold may be left out at the end.
struct Condition {
  NodeId node;
  const char* name;
};
using Status = std::array<Condition, 4>;
Status status_of(const Task& task);

}  // namespace gaussgen::emit
