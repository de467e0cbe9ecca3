#pragma once
// How far a run may be off: what a tighter one says.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/run/simulate.hpp"

namespace gausssim {

/// The largest difference of an output at a sampled time from that of a reference, relative to the range of that output in the reference.
struct DeliveredError {
  double value = 0;
  std::string output;  ///< where it is largest
};

/// Rows of one run, sample by sample: in more digits than most, so that references can be told apart.
class Rows {
 public:
  Rows(std::size_t columns, long samples);

  void set(long k, const std::vector<long double>& row);
  /// One of another run with the same columns.
  void take(long k, const Rows& other);
  /// Those of the first `samples`, if there are more.
  void keep(long samples) { count_ = std::min(count_, samples); }
  std::size_t columns() const { return columns_; }
  long samples() const { return count_; }
  long double at(long k, std::size_t column) const { return values_[static_cast<std::size_t>(k) * columns_ + column]; }

 private:
  std::size_t columns_;
  long count_ = 0;
  std::vector<long double> values_;
};

/// Of a column of a run; what is no number has none.
struct Extent {
  long double range = 0;  ///< from the least to the largest
  long double size = 0;   ///< the largest, whatever its sign
};

Extent extent_of(const Rows& rows, std::size_t column);

/// Rows that others are compared with, and what an error of each output is relative to: the range of the output along them. What does not change, such as the energy or a
/// coordinate at rest, has no range, only what rounding and steps leave of it: errors of it are relative to its size or to the largest range of an output with the same unit,
/// whichever is larger; of what is 0 throughout, as all of its unit, they are in that unit.
class Yardstick {
 public:
  Yardstick() = default;
  /// `other`: rows that should be the same. An output is taken for constant where they do not tell its range, since a tenth of it is no more than they differ by, or than
  /// `rounding` of its size, if it is below `least` of that; size is also what others with its unit range over.
  Yardstick(Rows rows, const Rows& other, const std::vector<Column>& columns, double least, double rounding);

  const Rows& rows() const { return rows_; }
  long double scale(std::size_t column) const { return outputs_[column].scale; }
  bool is_constant(std::size_t column) const { return outputs_[column].is_constant; }
  /// Over the samples that both have.
  DeliveredError error_of(const Rows& rows) const { return difference(rows, rows_); }
  /// Of two others, as errors are measured.
  DeliveredError difference(const Rows& rows, const Rows& reference) const;
  /// The largest change of an output within a share of the time from one sample to the next, as errors are measured.
  DeliveredError change_within(double share) const;
  /// Names of the outputs that have no range.
  std::vector<std::string> constants() const;
  /// Closer to the motion.
  void take(Rows rows) { rows_ = std::move(rows); }

 private:
  struct Output {
    std::string name;
    long double scale = 1;
    bool is_constant = false;
  };

  Rows rows_{0, 0};
  std::vector<Output> outputs_;
};

/// Of rows whose steps keep `tolerance`: what does not change drifts by some times that.
double least_range(double tolerance);

}  // namespace gausssim
