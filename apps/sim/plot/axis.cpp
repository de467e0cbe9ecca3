#include "sim/plot/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gausssim::plot {

namespace {

double step_of(double width, int wanted) {
  const double rough = width / wanted;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * 0.999) return factor * power;
  }
  return 10 * power;
}

/// What does not change has room above and below.
Range widened(Range range) {
  // Beyond it, the width of a range has no value.
  constexpr double k_most = 4e307;
  range = {std::clamp(range.least, -k_most, k_most), std::clamp(range.most, -k_most, k_most)};
  const double size = std::max(std::abs(range.least), std::abs(range.most));
  constexpr double k_rounding = 1e-14;
  if (range.most - range.least > k_rounding * size) return range;
  const double room = size > 0 ? size / 2 : 1;
  return {range.least - room, range.most + room};
}

/// In threes, as prefixes of units go; none where four digits do.
int exponent_of(double size) {
  constexpr double k_large = 99'999, k_small = 1e-2;
  if (size == 0 || (size <= k_large && size >= k_small)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(size) / 3));
}

std::string superscript(int number) {
  static const char* const k_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) text += k_digits[c - '0'];
  return text;
}

}  // namespace

Axis axis_of(Range range, int wanted, bool is_tight) {
  range = widened(range);
  const double step = step_of(range.most - range.least, wanted);
  Axis axis;
  const double first = is_tight ? std::ceil(range.least / step - 1e-9) : std::floor(range.least / step + 1e-9);
  const double last = is_tight ? std::floor(range.most / step + 1e-9) : std::ceil(range.most / step - 1e-9);
  axis.range = is_tight ? range : Range{first * step, last * step};
  const double size = std::max(std::abs(axis.range.least), std::abs(axis.range.most));
  constexpr double k_many_digits = 1e-5;
  if (step < k_many_digits * size) axis.offset = first * step;
  axis.exponent = exponent_of(axis.offset == 0 ? size : (last - first) * step);
  const double unit = std::pow(10, axis.exponent);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + 1e-9)));
  for (double k = first; k <= last; ++k) {
    // Rounded, so that what is zero is no small number, nor -0.
    const double shown = axis.offset == 0 ? k * step / unit : (k - first) * step / unit;
    std::string label = fmt::format("{:.{}f}", shown == 0 ? 0.0 : shown, decimals);
    std::replace(label.begin(), label.end(), '-', '\x01');
    const std::size_t minus = label.find('\x01');
    if (minus != std::string::npos) label.replace(minus, 1, "−");
    axis.ticks.push_back({k * step, label});
  }
  return axis;
}

std::string unit_text(const Axis& axis, const std::string& unit) {
  std::string text = axis.exponent == 0 ? unit : "10" + superscript(axis.exponent) + (unit.empty() ? "" : " " + unit);
  if (axis.offset == 0) return text;
  return text + (text.empty() ? "" : ", ") + fmt::format("from {:.10g}", axis.offset);
}

}  // namespace gausssim::plot
