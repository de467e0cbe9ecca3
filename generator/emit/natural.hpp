#pragma once

#include <functional>
#include <string>

#include "ir/graph.hpp"

namespace gaussgen::emit {

/// A name that says what a shared term is: sin_theta, psi_minus_chi, chi_dot_2 for a square, m_r; empty where it would
/// be long or say nothing. `name_of` gives the name of an operand, or an empty text.
std::string natural_name(const ir::Graph& graph, ir::NodeId id, const std::function<std::string(ir::NodeId)>& name_of);

}  // namespace gaussgen::emit
