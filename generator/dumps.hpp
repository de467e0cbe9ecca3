#pragma once
// Each stage as text that a person can read (`--dump`).

#include <string>

#include "emit/unit.hpp"
#include "mechanics.hpp"

namespace gaussgen {

std::string dump_model(const model::Model& model, const support::Source& source);
std::string dump_kinematics(const Mechanics& mechanics);
std::string dump_strategy(const Mechanics& mechanics);
std::string dump_artefacts(const Mechanics& mechanics, const emit::Unit& unit);

}  // namespace gaussgen
