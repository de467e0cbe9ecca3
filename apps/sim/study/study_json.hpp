#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/study/problem.hpp"

namespace gausssim {

/// Points or problems are missing.
bool was_interrupted(const std::vector<StudyProblem>& problems, const StudyOptions& options);

/// docs/study-format.md.
nlohmann::ordered_json study_json(const std::vector<StudyProblem>& problems, const StudyOptions& options);

/// A row for each point.
std::string study_csv(const std::vector<StudyProblem>& problems);

}  // namespace gausssim
