#pragma once
// What varies from one trajectory of an ensemble to the next. docs/ensembles.md.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "support/source.hpp"

namespace gausssim {

/// Which values a quantity takes.
struct Distribution {
  enum class Kind {
    uniform,      ///< anywhere between two numbers
    normal,       ///< by mean and standard deviation
    log_uniform,  ///< its logarithm is anywhere between those of two positive numbers
    points,       ///< each of these: a sweep, or a list
  };
  Kind kind = Kind::points;
  double a = 0, b = 0;  ///< the two numbers
  std::vector<double> points;

  bool is_random() const { return kind != Kind::points; }
};

enum class Section { parameters, initial, inputs };

/// As scenes call it.
const char* name_of(Section section);

struct Varied {
  Section section = Section::parameters;
  std::string name;
  Distribution distribution;
  gaussgen::support::Span span;  ///< of the name
};

struct Ensemble {
  std::vector<Varied> varied;
  std::uint64_t seed = 0;
  long trajectories = 1;         ///< for each point of the sweeps
  bool records_samples = false;  ///< else the end alone
  gaussgen::support::Span span;  ///< of the key
};

inline constexpr long k_most_trajectories = 10'000'000;
/// A double has all numbers up to it, and so have programs that read JSON.
inline constexpr long k_largest_seed = 1L << 53;

/// How many points all sweeps together have.
double points_of(const Ensemble& ensemble);

}  // namespace gausssim
