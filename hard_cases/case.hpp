#pragma once
// A hard case: what a naive form does, what ours does, and how good it has to be.

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace hard_cases {

/// Where a naive form breaks down: NaN, overflow, a step that cannot be taken.
inline constexpr double k_breaks_down = std::numeric_limits<double>::infinity();

/// Makes `largest` the largest size so far; what is not a number breaks down for good.
inline void grow(double& largest, double value) {
  const double size = std::abs(value);
  if (!(size <= std::numeric_limits<double>::max())) {
    largest = k_breaks_down;
  } else if (size > largest) {
    largest = size;
  }
}

struct Series {
  std::string name;
  std::vector<double> t;  ///< s
  std::vector<double> values;
};

/// One figure of a case. It holds if ours is at most the bar, and the naive form, where there is one, misses it.
struct Figure {
  std::string id;        ///< that of the case, with a word where it has several: "H13.energy"
  std::string quantity;  ///< what is measured
  std::string unit;      ///< "1" for a plain number
  std::optional<double> naive = {};
  double ours = k_breaks_down;
  double bar = 0;
  double seconds_naive = 0;  ///< of computing time; what runs for several figures is counted with each
  double seconds_ours = 0;
  std::string remark = {};
  std::vector<Series> charts = {};

  bool holds() const { return ours <= bar && !(naive && *naive <= bar); }
  const char* status() const { return holds() ? "holds" : "fails"; }
};

struct Scope {
  bool is_long = false;  ///< the whole duration of the catalogue, where that takes minutes
  bool is_timed = true;  ///< with figures that are times, which no test judges
};

struct Case {
  std::string id;  ///< "H12"
  std::string title;
  std::vector<Figure> (*run)(const Scope&);
};

/// All cases, by id.
const std::vector<Case>& cases();

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace hard_cases
