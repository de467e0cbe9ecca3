#include "ir/rotation.hpp"

#include <tuple>
#include <vector>

namespace gaussgen::ir {

namespace {

/// x = r cos φ and y = sign r sin φ; or with sine and cosine the other way round.
struct Polar {
  Expr r;
  Expr angle;
  bool has_cosine_first = true;
  int sign = 1;
};

std::vector<NodeId> factors_of(const Graph& graph, NodeId id) {
  const Node& node = graph[id];
  const bool is_scaled = node.kind == Kind::sum && node.value == 0 && node.children.size() == 1;
  if (is_scaled) id = node.children[0];
  return graph[id].kind == Kind::product ? listed(graph[id].children) : std::vector<NodeId>{id};
}

std::optional<Polar> polar(Expr x, Expr y) {
  Graph& graph = x.graph();
  if (x.is_zero() || y.is_zero()) return std::nullopt;
  for (const NodeId factor : factors_of(graph, x.id())) {
    const Node& node = graph[factor];
    if (node.kind != Kind::function) continue;
    const bool is_cosine = node.function == Function::cos;
    if (!is_cosine && node.function != Function::sin) continue;
    const Expr angle(graph, node.children[0]);
    const Expr r = x * pow(Expr(graph, factor), -1);
    const Expr partner = r * call(is_cosine ? Function::sin : Function::cos, angle);
    if (partner == y) return Polar{r, angle, is_cosine, 1};
    if (-partner == y) return Polar{r, angle, is_cosine, -1};
  }
  return std::nullopt;
}

}  // namespace

std::pair<Expr, Expr> turned(Expr x, Expr y, Expr angle) {
  if (angle.is_zero()) return {x, y};
  if (const auto found = polar(x, y)) {
    const auto& [r, own, has_cosine_first, sign] = *found;
    const Expr sum = has_cosine_first == (sign > 0) ? own + angle : own - angle;
    const Expr sine = r * call(Function::sin, sum), cosine = r * call(Function::cos, sum);
    const Expr first = has_cosine_first ? cosine : sine, second = has_cosine_first ? sine : cosine;
    return {first, sign > 0 ? second : -second};
  }
  const Expr sine = call(Function::sin, angle), cosine = call(Function::cos, angle);
  return {cosine * x - sine * y, sine * x + cosine * y};
}

Vector3 turned(const Vector3& v, std::size_t axis, Expr angle) {
  const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
  Vector3 result = v;
  std::tie(result[p], result[q]) = turned(v[p], v[q], angle);
  return result;
}

std::optional<Expr> polar_angle(Expr x, Expr y) {
  const auto found = polar(x, y);
  if (!found) return std::nullopt;
  return found->has_cosine_first == (found->sign > 0) ? found->angle : -found->angle;
}

}  // namespace gaussgen::ir
