#include "model/shapes.hpp"

#include <algorithm>

namespace gaussgen::model {

using format::Shape;
using spec::NodeKind;

NodeKind kind_of(Shape shape) {
  switch (shape) {
    case Shape::list: return NodeKind::sequence;
    case Shape::map:
    case Shape::entries:
    case Shape::counts: return NodeKind::map;
    default: return NodeKind::scalar;
  }
}

bool fits(const spec::Node& node, const format::Value& value) {
  if (kind_of(value.shape) != node.kind) return false;
  return value.shape != Shape::list || node.items.empty() || fits(node.items.front(), *value.item) ||
         std::any_of(value.item->others.begin(), value.item->others.end(),
                     [&](const format::Value& other) { return fits(node.items.front(), other); });
}

}  // namespace gaussgen::model
