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

/// In long double, whose range other number types do not leave.
struct Extent {
  long double range = 0, size = 0;
};

Extent extent_of(const Rows& rows, std::size_t column) {
  long double least = std::numeric_limits<long double>::infinity(), most = -least, size = 0;
  for (long k = 0; k < rows.samples(); ++k) {
    const long double value = rows.at(k, column);
    least = std::min(least, value);
    most = std::max(most, value);
    size = std::max(size, std::abs(value));
  }
  return {most - least, size};
}

/// What changes by less than this part of its size, or of what others with its unit change by, is taken for constant.
constexpr long double k_constant = 1e-6;

std::vector<long double> scales_of(const Rows& reference, const std::vector<Column>& columns) {
  std::vector<Extent> extents;
  std::map<std::string, long double> by_unit;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    extents.push_back(extent_of(reference, i));
    by_unit[columns[i].unit] = std::max(by_unit[columns[i].unit], extents[i].range);
  }
  std::vector<long double> scales;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Extent& extent = extents[i];
    const long double others = by_unit[columns[i].unit];
    const long double whole = std::max(extent.size, others);
    const long double scale = extent.range > k_constant * whole ? extent.range : whole;
    scales.push_back(scale > 0 ? scale : 1);
  }
  return scales;
}

/// In units of `scale`. What is no number in both is not missed; what is none in one of them, or has no scale, is off by all.
double miss(long double value, long double reference, long double scale) {
  if (value == reference || (std::isnan(value) && std::isnan(reference))) return 0;
  const auto result = static_cast<double>(std::abs(value - reference) / scale);
  return std::isfinite(scale) && !std::isnan(result) ? result : std::numeric_limits<double>::infinity();
}

}  // namespace

DeliveredError delivered_error(const Rows& rows, const Rows& reference, const std::vector<Column>& columns) {
  DeliveredError result;
  const std::vector<long double> scales = scales_of(reference, columns);
  const long samples = std::min(rows.samples(), reference.samples());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (long k = 0; k < samples; ++k) {
      const double error = miss(rows.at(k, i), reference.at(k, i), scales[i]);
      if (!(error > result.value)) continue;
      result = {error, columns[i].name};
    }
  }
  return result;
}

}  // namespace gausssim
