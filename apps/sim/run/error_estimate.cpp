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

void Rows::take(long k, const Rows& other) {
  const auto first = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k) * columns_);
  std::copy_n(other.values_.begin() + first, columns_, values_.begin() + first);
}

// In long double, whose range other number types do not leave.
Extent extent_of(const Rows& rows, std::size_t column) {
  long double least = std::numeric_limits<long double>::infinity(), most = -least;
  for (long k = 0; k < rows.samples(); ++k) {
    const long double value = rows.at(k, column);
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (!(least <= most)) return {};
  return {most - least, std::max(std::abs(least), std::abs(most))};
}

namespace {

/// By how much two runs differ: neither is known better.
long double doubt_of(const Rows& rows, const Rows& other, std::size_t column) {
  long double most = 0;
  for (long k = 0; k < std::min(rows.samples(), other.samples()); ++k) {
    const long double apart = std::abs(rows.at(k, column) - other.at(k, column));
    if (std::isfinite(apart)) most = std::max(most, apart);
  }
  return most;
}

/// Whether two runs share how an output begins to move: until it has moved by a quarter of its range, they differ by less than one of `times` parts of that. Runs that lose each other later do, and noise does not: eight
/// samples of it are not alike by chance, and four hardly.
bool begin_alike(const Rows& rows, const Rows& other, std::size_t column, long double range, long double times) {
  constexpr long k_alike = 8, k_least = 4;
  const long samples = std::min(rows.samples(), other.samples());
  const long alike = std::clamp(samples / 2, k_least, k_alike);
  long double least = std::numeric_limits<long double>::infinity(), most = -least, apart = 0;
  for (long k = 0; k < samples; ++k) {
    const long double value = rows.at(k, column);
    least = std::min(least, value);
    most = std::max(most, value);
    apart = std::max(apart, std::abs(value - other.at(k, column)));
    if (k >= alike && most - least >= range / 4) return most - least > times * apart;
  }
  return false;
}

/// What stays within this, in its unit, is 0 but for rounding, if nothing of that unit is more.
constexpr long double k_nothing = 1e-12;

/// Likewise, but two runs may have nearly the same noise: what rounding makes of numbers near 1, as others of the model are.
constexpr long double k_rounded = 4 * static_cast<long double>(std::numeric_limits<double>::epsilon());

/// No quantity is that small, in any unit that people use: what decays by steps that are too long for it is.
constexpr long double k_nowhere = 1e-60;

/// A radian, or 1.
bool has_natural_size(const std::string& unit) { return unit == "rad" || unit == "1"; }

/// Then whatever range runs have is an error of theirs: the energy, also as kinetic energy of what has no other.
bool is_conserved(const std::vector<Column>& columns, const std::vector<Extent>& extents, std::size_t i) {
  if (columns[i].is_conserved) return true;
  if (columns[i].name != "energy.kinetic") return false;
  bool is_whole = false;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].name == "energy.potential" && extents[k].range != 0) return false;
    is_whole = is_whole || columns[k].is_conserved;
  }
  return is_whole;
}

/// In units of `scale`. What is no number in both is not missed; what is none in one of them is off by all.
double miss(long double value, long double reference, long double scale) {
  if (value == reference || (std::isnan(value) && std::isnan(reference))) return 0;
  const auto result = static_cast<double>(std::abs(value - reference) / scale);
  return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

}  // namespace

Yardstick::Yardstick(Rows rows, const Rows& other, const std::vector<Column>& columns, double least, double rounding)
    : rows_(std::move(rows)) {
  std::vector<Extent> extents;
  std::map<std::string, long double> by_unit;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    extents.push_back(extent_of(rows_, i));
    by_unit[columns[i].unit] = std::max(by_unit[columns[i].unit], extents[i].range);
  }
  const long double digits = std::max(static_cast<long double>(rounding), std::numeric_limits<long double>::epsilon());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    // Two runs in double may drift alike, by what rounding makes from step to step: so small a range has to be clearer.
    constexpr long double k_clear = 10, k_clearer = 100, k_clearest = 1e4, k_noise = 1e5,
                          k_drift = k_noise * std::numeric_limits<double>::epsilon();
    const long double range = extents[i].range, size = std::max(extents[i].size, by_unit[columns[i].unit]);
    const bool may_be_noise = size <= k_rounded;
    const long double times = may_be_noise ? k_clearest : range > k_drift * extents[i].size ? k_clear : k_clearer;
    const bool is_told =
        range > times * doubt_of(rows_, other, i) || (!may_be_noise && begin_alike(rows_, other, i, range, times));
    const bool is_something = size > (has_natural_size(columns[i].unit) ? k_rounded : k_nowhere);
    const bool is_clear = is_told && is_something && range > k_clear * digits * size;
    // What steps make of it becomes less with them, and rounding is less than what two wrong runs have.
    const bool is_of_steps =
        range <= least * size && (range <= k_noise * digits * size || range < extent_of(other, i).range / 2);
    const bool is_constant = is_conserved(columns, extents, i) || (!is_clear && (is_of_steps || size <= k_nothing));
    const long double scale = !is_constant ? range : size <= k_nothing ? 1 : size;
    outputs_.push_back({columns[i].name, scale, is_constant});
  }
}

DeliveredError Yardstick::difference(const Rows& rows, const Rows& reference) const {
  DeliveredError result;
  const long samples = std::min(rows.samples(), reference.samples());
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    for (long k = 0; k < samples; ++k) {
      const double error = miss(rows.at(k, i), reference.at(k, i), outputs_[i].scale);
      if (error > result.value) result = {error, outputs_[i].name};
    }
  }
  return result;
}

DeliveredError Yardstick::change_within(double share) const {
  DeliveredError result;
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    for (long k = 0; k + 1 < rows_.samples(); ++k) {
      const double change = share * miss(rows_.at(k + 1, i), rows_.at(k, i), outputs_[i].scale);
      if (std::isfinite(change) && change > result.value) result = {change, outputs_[i].name};
    }
  }
  return result;
}

std::vector<std::string> Yardstick::constants() const {
  std::vector<std::string> names;
  for (const Output& output : outputs_) {
    if (output.is_constant) names.push_back(output.name);
  }
  return names;
}

double least_range(double tolerance) {
  constexpr double k_drift = 1e3, k_least = 1e-10, k_most = 1e-3;
  return std::clamp(k_drift * tolerance, k_least, k_most);
}

}  // namespace gausssim
