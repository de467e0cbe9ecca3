#pragma once
// One problem of a study, from its file to its points.

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/ensemble/measure_lanes.hpp"
#include "sim/study/form.hpp"
#include "sim/study/measure.hpp"
#include "sim/study/motion.hpp"
#include "sim/study/study.hpp"

namespace gausssim {

struct DriftTrace {
  int point = 0;
  std::vector<double> t, energy, constraints;
};

struct StudyProblem {
  std::string name;
  std::string file, scene;  ///< of the model; of the scene, empty where there is none
  std::vector<Form> forms;
  std::vector<double> ranges;  ///< of the outputs, along the reference
  StudyReference reference;
  std::vector<Point> points;
  std::vector<DriftTrace> drifts;
  std::optional<Motion> motion;
  std::vector<LanesRow> lanes;
  nlohmann::ordered_json effects;  ///< what they cost and change; null where the model has none that act
  std::string why;                 ///< there is no reference
  bool was_interrupted = false;
};

/// Nothing after an error in the file, which is reported: `code`. Throws Interrupted where nothing has been measured yet.
std::optional<StudyProblem> solve_problem(const std::string& file, const StudyOptions& options, int& code);

}  // namespace gausssim
