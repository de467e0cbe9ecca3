#include "sim/plot/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "sim/plot/axis.hpp"
#include "sim/plot/polyline.hpp"
#include "sim/plot/svg.hpp"

namespace gausssim::plot {

namespace {

// In pixels.
constexpr double k_width = 960, k_left = 84, k_right = 24, k_top = 40, k_panel = 200, k_gap = 22, k_bottom = 56;
constexpr double k_legend_row = 20, k_sample = 26, k_letter = 7.4;
constexpr double k_inside = k_width - k_left - k_right;

struct Panel {
  std::string unit;
  std::vector<const TableColumn*> columns;
  Axis axis;
  double top = 0;  ///< of its frame
  double height = k_panel;
  std::vector<Point> legend;  ///< where its entries begin, by columns
};

Range range_of(const std::vector<const TableColumn*>& columns) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const TableColumn* const column : columns) {
    for (const double value : column->values) {
      if (!std::isfinite(value)) continue;
      range.least = std::min(range.least, value);
      range.most = std::max(range.most, value);
    }
  }
  return range.least > range.most ? Range{0, 0} : range;
}

std::vector<Panel> by_units(const std::vector<const TableColumn*>& columns) {
  std::vector<Panel> panels;
  for (const TableColumn* const column : columns) {
    const auto found =
        std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.unit == column->unit; });
    Panel& panel = found == panels.end() ? panels.emplace_back() : *found;
    panel.unit = column->unit;
    panel.columns.push_back(column);
  }
  return panels;
}

double entry_width(const TableColumn& column) {
  return k_sample + 8 + k_letter * static_cast<double>(column.name.size()) + 18;
}

/// In rows above the frame, which begins below them.
void place_legend(Panel& panel, double top) {
  double x = k_left, y = top + k_legend_row / 2;
  for (const TableColumn* const column : panel.columns) {
    const double width = entry_width(*column);
    if (x > k_left && x + width > k_width - k_right) {
      x = k_left;
      y += k_legend_row;
    }
    panel.legend.push_back({x, y});
    x += width;
  }
  panel.top = y + k_legend_row / 2 + 4;
}

/// Ranges end before the largest numbers do, and their widths have values.
double share_of(const Range& range, double value) {
  return (std::clamp(value, range.least, range.most) - range.least) / (range.most - range.least);
}

double across(const Axis& axis, double value) { return k_left + k_inside * share_of(axis.range, value); }

double up(const Panel& panel, double value) {
  return panel.top + panel.height * (1 - share_of(panel.axis.range, value));
}

void draw_frame(Svg& svg, const Panel& panel, const Axis& below, bool is_last) {
  for (const Tick& tick : panel.axis.ticks) {
    const double y = up(panel, tick.value);
    svg.line({k_left, y}, {k_width - k_right, y}, "grid");
    svg.text({k_left - 8, y + 4}, tick.label, "end", "tick");
  }
  for (const Tick& tick : below.ticks) {
    const double x = across(below, tick.value);
    svg.line({x, panel.top}, {x, panel.top + panel.height}, "grid");
    if (is_last) svg.text({x, panel.top + panel.height + 18}, tick.label, "middle", "tick");
  }
  svg.rectangle({k_left, panel.top}, k_inside, panel.height, "frame");
  const std::string unit = unit_text(panel.axis, panel.unit);
  const std::string name = panel.columns.size() == 1 ? panel.columns.front()->name + " " : "";
  const std::string title = unit.empty() ? name : name + "[" + unit + "]";
  svg.text({20, panel.top + panel.height / 2}, title, "middle", "title", -90);
}

/// A number that is none parts a line; what stands alone is a dot.
void draw_line(Svg& svg, const Panel& panel, const Axis& below, const TableColumn& x, const TableColumn& y,
               const TableColumn* within, std::size_t colour) {
  std::vector<Point> points;
  const auto draw = [&] {
    if (points.size() == 1) svg.dots(points, look_of_dots(colour));
    if (points.size() > 1) svg.polyline(decimated(points, 1), look_of_line(colour));
    points.clear();
  };
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    if (within != nullptr && i > 0 && within->values[i] != within->values[i - 1]) draw();
    if (std::isfinite(x.values[i]) && std::isfinite(y.values[i])) {
      points.push_back({across(below, x.values[i]), up(panel, y.values[i])});
    } else {
      draw();
    }
  }
  draw();
}

/// One for each place that eyes tell from others.
void draw_dots(Svg& svg, const Panel& panel, const Axis& below, const TableColumn& x, const TableColumn& y,
               const std::string& look) {
  std::set<std::pair<long, long>> places;
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    if (!std::isfinite(x.values[i]) || !std::isfinite(y.values[i])) continue;
    const Point point{across(below, x.values[i]), up(panel, y.values[i])};
    if (places.emplace(std::lround(point.x), std::lround(point.y)).second) points.push_back(point);
  }
  svg.dots(points, look);
}

void draw(Svg& svg, const Panel& panel, const Axis& below, const TableColumn& x, const Bonds& bonds, bool is_last) {
  draw_frame(svg, panel, below, is_last);
  for (std::size_t i = 0; i < panel.columns.size(); ++i) {
    const TableColumn& y = *panel.columns[i];
    svg.begin_group(y.unit.empty() ? y.name : y.name + " [" + y.unit + "]");
    const Point at = panel.legend[i];
    if (bonds.are_there) {
      draw_line(svg, panel, below, x, y, bonds.within, i);
      svg.polyline({at, {at.x + k_sample, at.y}}, look_of_line(i));
    } else {
      draw_dots(svg, panel, below, x, y, look_of_dots(i));
      svg.dots({{at.x + k_sample / 2, at.y}}, look_of_dots(i));
    }
    svg.text({at.x + k_sample + 8, at.y + 4}, y.name, "start", "legend");
    svg.end_group();
  }
}

bool is_time(const TableColumn& x, const Bonds& bonds) {
  return bonds.are_there && (bonds.within != nullptr || std::is_sorted(x.values.begin(), x.values.end()));
}

/// Time ends where the picture does; a path and dots would lie on its frame.
Range range_across(const TableColumn& x, const Bonds& bonds) {
  const Range range = range_of({&x});
  const double margin = is_time(x, bonds) ? 0 : 0.03 * (range.most - range.least);
  return {range.least - margin, range.most + margin};
}

/// Of a path in one unit: so that a circle is round, unless that makes a strip of it.
double height_of_path(const Panel& panel, const Axis& below) {
  constexpr double k_least = k_panel / 2, k_most = k_inside;
  const auto width = [](const Range& range) { return range.most - range.least; };
  const double height = k_inside * (width(panel.axis.range) / width(below.range));
  return height >= k_least && height <= k_most ? height : k_panel;
}

}  // namespace

std::string chart(const TableColumn& x, const std::vector<const TableColumn*>& columns, const std::string& title,
                  const Bonds& bonds) {
  constexpr int k_ticks_up = 5, k_ticks_across = 10;
  const Axis below = axis_of(range_across(x, bonds), k_ticks_across, true);
  std::vector<Panel> panels = by_units(columns);
  double top = k_top;
  for (Panel& panel : panels) {
    panel.axis = axis_of(range_of(panel.columns), k_ticks_up, false);
    if (!is_time(x, bonds) && panel.unit == x.unit && !x.unit.empty()) panel.height = height_of_path(panel, below);
    place_legend(panel, top);
    top = panel.top + panel.height + k_gap;
  }
  const double end = panels.back().top + panels.back().height;
  Svg svg(k_width, end + k_bottom, title);
  svg.text({k_left, k_top - 16}, title, "start", "title");
  for (const Panel& panel : panels) draw(svg, panel, below, x, bonds, &panel == &panels.back());
  const std::string unit = unit_text(below, x.unit);
  svg.text({k_left + k_inside / 2, end + 42}, unit.empty() ? x.name : x.name + " [" + unit + "]", "middle", "title");
  return svg.finished();
}

}  // namespace gausssim::plot
