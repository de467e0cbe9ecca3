#pragma once
// Long tables have more rows than a picture has points.

#include <vector>

namespace gausssim::plot {

struct Point {
  double x = 0, y = 0;
};

/// Of points that follow each other within one `width` of x: the first, the lowest, the highest and the last, in their order. No extreme is lost.
std::vector<Point> decimated(const std::vector<Point>& points, double width);

}  // namespace gausssim::plot
