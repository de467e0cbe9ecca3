#pragma once
// How far a run may be off: what a tighter one says.

#include <optional>
#include <string>
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
  std::size_t columns() const { return columns_; }
  long samples() const { return count_; }
  long double at(long k, std::size_t column) const { return values_[static_cast<std::size_t>(k) * columns_ + column]; }

 private:
  std::size_t columns_;
  long count_ = 0;
  std::vector<long double> values_;
};

/// Over the samples that both have. An output that does not change, such as the energy or a coordinate at rest, has no range: errors of it are relative to its size or to
/// the largest range of an output with the same unit, whichever is larger; of what is 0 throughout, as all of its unit, they are in that unit.
DeliveredError delivered_error(const Rows& rows, const Rows& reference, const std::vector<Column>& columns);

}  // namespace gausssim
