#pragma once
// Vectors and places in the axes of other links.

#include <optional>

#include "kinematics/linkage.hpp"

namespace gaussgen::strategy {

/// Of each link, the ones that hang on it.
std::vector<std::vector<std::size_t>> children_of(const std::vector<kinematics::Link>& links);

/// Whether one of two links carries the other; the ground carries all.
bool is_carried(const std::vector<kinematics::Link>& links, std::size_t link, std::size_t by);

/// The last link that carries both.
std::size_t common_carrier(const std::vector<kinematics::Link>& links, std::size_t a, std::size_t b);

/// A vector in axes of `from`, in those of `to`. Turns about one axis that follow each other are one, by the sum of their angles.
ir::Vector3 resolved(const std::vector<kinematics::Link>& links, std::size_t from, std::size_t to, ir::Vector3 v);

/// A place on `from`, from the origin of `to` in its axes, m; one of the links carries the other.
ir::Vector3 position_on(const std::vector<kinematics::Link>& links, std::size_t from, std::size_t to,
                        ir::Vector3 place);

}  // namespace gaussgen::strategy
