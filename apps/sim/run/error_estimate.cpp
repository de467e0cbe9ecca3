#include "sim/run/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gausssim {

Rows::Rows(std::size_t columns, long samples) : columns_(columns) {
  values_.resize(columns * static_cast<std::size_t>(samples), 0);
}

void Rows::set(long k, const std::vector<long double>& row) {
  std::copy(row.begin(), row.end(),
            values_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k) * columns_));
  count_ = std::max(count_, k + 1);
}

namespace {

struct Extent {
  double range = 0, size = 0;
};

Extent extent_of(const Rows& rows, std::size_t column) {
  double least = std::numeric_limits<double>::infinity(), most = -least, size = 0;
  for (long k = 0; k < rows.samples(); ++k) {
    const auto value = static_cast<double>(rows.at(k, column));
    least = std::min(least, value);
    most = std::max(most, value);
    size = std::max(size, std::abs(value));
  }
  return {most - least, size};
}

/// What changes by less than this part of its size, or of what others with its unit change by, is taken for constant.
constexpr double k_constant = 1e-6;

std::vector<double> scales_of(const Rows& reference, const std::vector<Column>& columns) {
  std::vector<Extent> extents;
  std::map<std::string, double> by_unit;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    extents.push_back(extent_of(reference, i));
    by_unit[columns[i].unit] = std::max(by_unit[columns[i].unit], extents[i].range);
  }
  std::vector<double> scales;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Extent& extent = extents[i];
    const double others = by_unit[columns[i].unit];
    const double whole = std::max(extent.size, others);
    const double scale = extent.range > k_constant * whole ? extent.range : whole;
    scales.push_back(scale > 0 ? scale : 1);
  }
  return scales;
}

/// What is no number in the reference cannot be missed; what is none beside a number is off by all.
double miss(long double value, long double reference) {
  if (std::isnan(reference) || value == reference) return 0;
  const auto result = static_cast<double>(std::abs(value - reference));
  return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

}  // namespace

DeliveredError delivered_error(const Rows& rows, const Rows& reference, const std::vector<Column>& columns) {
  DeliveredError result;
  const std::vector<double> scales = scales_of(reference, columns);
  const long samples = std::min(rows.samples(), reference.samples());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (long k = 0; k < samples; ++k) {
      const double error = miss(rows.at(k, i), reference.at(k, i)) / scales[i];
      if (!(error > result.value)) continue;
      result = {error, columns[i].name};
    }
  }
  return result;
}

}  // namespace gausssim
