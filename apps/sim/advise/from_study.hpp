#pragma once
// What a study says of a problem.

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/run/prepare.hpp"

namespace gausssim {

/// A point of docs/study-format.md.
struct StudyPoint {
  std::string formulation, code, method, number, projection;
  double tolerance = 0, step = 0, error = 0, seconds = 0, longest_step = 0;
  long steps = 0;
};

/// One of the scene's `formulations`, by name; nothing where it cannot be derived.
using FormOfScene = std::function<std::optional<PreparedModel>(const std::string& name)>;

/// The cheapest point of the problem that delivered `error` with a margin of two. Nothing delivered it: `why`. Throws cli::FileError where the file is no study, or lacks
/// the problem, or has another one of the name.
StudyPoint cheapest_in_study(const std::string& path, const PreparedModel& prepared, const FormOfScene& prepared_form,
                             double error, std::string& why);

}  // namespace gausssim
