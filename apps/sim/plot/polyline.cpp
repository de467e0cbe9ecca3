#include "sim/plot/polyline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gausssim::plot {

namespace {

void keep(const std::vector<Point>& points, std::size_t begin, std::size_t end, std::vector<Point>& kept) {
  std::array<std::size_t, 4> places{begin, begin, begin, end - 1};
  for (std::size_t i = begin; i < end; ++i) {
    if (points[i].y < points[places[1]].y) places[1] = i;
    if (points[i].y > points[places[2]].y) places[2] = i;
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0 || places[i] != places[i - 1]) kept.push_back(points[places[i]]);
  }
}

}  // namespace

std::vector<Point> decimated(const std::vector<Point>& points, double width) {
  const auto bucket = [&](const Point& point) { return std::floor(point.x / width); };
  std::vector<Point> kept;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && bucket(points[end]) == bucket(points[begin])) ++end;
    keep(points, begin, end, kept);
  }
  return kept;
}

}  // namespace gausssim::plot
