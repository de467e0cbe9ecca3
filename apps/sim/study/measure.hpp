#pragma once

#include <optional>
#include <string>

#include "sim/study/candidate.hpp"

namespace gausssim {

/// What points are compared with.
struct StudyReference {
  Yardstick yardstick;
  std::string kind;                  ///< "float128" or "closed form"
  std::vector<std::string> methods;  ///< how it was found, twice
  double agreement = 0;              ///< of the two, as an error
};

constexpr const char* k_beyond_time = "beyond the time that the study was given";

struct Effort {
  double limit = 60;  ///< seconds of the first run: what takes longer is refused
  int repeats = 5;
  double seconds = 0.02;  ///< of all repeats; of short runs at least three are made
  double longest = 10;    ///< of one run; what takes longer is not repeated
};

/// Runs a candidate, compares it, and times it.
Point measure(const PreparedModel& model, const Engine& engine, const Candidate& candidate,
              const StudyReference& reference, const Effort& effort);

/// How far a setting is off; `why` it is not known.
DeliveredError error_of(const PreparedModel& model, const Engine& engine, const Setting& setting,
                        const StudyReference& reference, std::string& why);

/// A reference without a closed form: power series in __float128, of two orders and in other steps, or extrapolation where a model has none, or pairs where forces jump. The finer one is it. `engine` has long double, too, where
/// they do.
std::optional<StudyReference> find_reference(const PreparedModel& model, const Engine& engine, std::string& why);

}  // namespace gausssim
