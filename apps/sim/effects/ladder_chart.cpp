#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/effects/ladder_text.hpp"
#include "sim/plot/svg.hpp"

namespace gausssim {

namespace {

using plot::Point;

constexpr double k_width = 900, k_row = 24, k_top = 76, k_gap = 64;
constexpr double k_cost = 330, k_cost_end = 560, k_change = 610, k_change_end = 860;
constexpr int k_least_decade = -12, k_last_decade = 1;

double x_of_change(double change) {
  const double decade = std::clamp(std::log10(std::max(change, 1e-300)), double(k_least_decade), double(k_last_decade));
  return k_change + (decade - k_least_decade) / (k_last_decade - k_least_decade) * (k_change_end - k_change);
}

class Drawing {
 public:
  explicit Drawing(const EffectsReport& report)
      : report_(report), svg_(k_width, height(), report.bench.name() + ": effects"), most_(most_operations()) {}

  std::string run() {
    svg_.text({16, 24}, fmt::format("{}: what effects cost and change", report_.bench.name()), "start", "title");
    double y = panel(k_top, "all but one", report_.ladder.each);
    panel(y + k_gap, "left out in turn", report_.ladder.rungs);
    return svg_.finished();
  }

 private:
  double height() const {
    const auto rows = static_cast<double>(report_.ladder.each.size() + report_.ladder.rungs.size());
    return k_top + k_row * rows + k_gap + 40;
  }

  int most_operations() const {
    int most = std::max(1, report_.ladder.all.operations);
    for (const Compared& one : report_.ladder.each) most = std::max(most, one.measured.operations);
    return most;
  }

  double panel(double y, const char* name, const std::vector<Compared>& rows) {
    svg_.text({16, y - 10}, name, "start", "title");
    svg_.text({k_cost, y - 10}, "operations of the rates", "start", "tick");
    svg_.text({(k_change + k_change_end) / 2, y - 28}, "change of the motion, of the range of an output", "middle",
              "tick");
    const double bottom = y + k_row * static_cast<double>(rows.size());
    for (int decade = k_least_decade; decade <= 0; decade += 3) {
      const double x = x_of_change(std::pow(10.0, decade));
      svg_.line({x, y - 4}, {x, bottom}, "grid");
      svg_.text({x, y - 10}, fmt::format("1e{}", decade), "middle", "tick");
    }
    if (report_.need) svg_.line({x_of_change(*report_.need), y - 4}, {x_of_change(*report_.need), bottom}, "line c1");
    for (const Compared& one : rows) {
      row(y, one);
      y += k_row;
    }
    return bottom;
  }

  void row(double y, const Compared& one) {
    const double middle = y + k_row / 2;
    const Measured& measured = one.measured;
    svg_.begin_group(measured.why.empty() ? fmt::format("{}: {} operations, {:.4g} ms", one.move.what,
                                                        measured.operations, 1e3 * measured.seconds)
                                          : one.move.what + ": " + measured.why);
    svg_.text({16, middle + 4}, one.move.what, "start", "tick");
    if (measured.why.empty()) {
      const double length = (k_cost_end - 50 - k_cost) * measured.operations / most_;
      svg_.line({k_cost, middle}, {k_cost + length, middle}, "dot c0");
      svg_.text({k_cost + length + 8, middle + 4}, fmt::format("{}", measured.operations), "start", "tick");
      if (measured.change.value > 0) svg_.dots({{x_of_change(measured.change.value), middle}}, "dot c1");
    }
    svg_.end_group();
  }

  const EffectsReport& report_;
  plot::Svg svg_;
  int most_;
};

}  // namespace

std::string chart_of_effects(const EffectsReport& report) { return Drawing(report).run(); }

}  // namespace gausssim
