#include <algorithm>
#include <limits>

#include "sim/study/candidate.hpp"

namespace gausssim {

namespace {

bool counts(const Point& point) { return point.status == PointStatus::ok && point.error; }

}  // namespace

void mark_front(std::vector<Point>& points) {
  std::vector<Point*> order;
  for (Point& point : points) {
    point.is_on_front = false;
    if (counts(point)) order.push_back(&point);
  }
  std::sort(order.begin(), order.end(), [](const Point* a, const Point* b) {
    return a->time != b->time ? a->time < b->time : a->error->value < b->error->value;
  });
  double least = std::numeric_limits<double>::infinity();
  double time_of_least = 0;
  for (Point* const point : order) {
    const bool is_alike = point->error->value == least && point->time == time_of_least;
    if (point->error->value >= least && !is_alike) continue;
    least = point->error->value;
    time_of_least = point->time;
    point->is_on_front = true;
  }
}

const Point* cheapest(const std::vector<Point>& points, double error) {
  const Point* best = nullptr;
  for (const Point& point : points) {
    if (!counts(point) || !(point.error->value <= error)) continue;
    if (best == nullptr || point.time < best->time) best = &point;
  }
  return best;
}

}  // namespace gausssim
