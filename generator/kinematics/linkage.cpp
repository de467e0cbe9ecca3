#include "kinematics/linkage.hpp"

#include <algorithm>

#include "ir/contract.hpp"
#include "ir/differentiate.hpp"
#include "ir/rotation.hpp"
#include "ir/traverse.hpp"

namespace gaussgen::kinematics {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using support::Rational;

namespace {

class Builder {
 public:
  Builder(const model::Model& model, const Symbols& symbols, Expressions& expressions, ir::Substitution& hold)
      : model_(model),
        symbols_(symbols),
        expressions_(expressions),
        hold_(hold),
        zero_(ir::zero3(expressions.graph())) {
    for (const FreeIndex i : symbols.speeds.indices()) speeds_.emplace(symbols.speeds[i].symbol.index, i);
  }

  std::optional<Linkage> run() {
    find_carriers();
    ends_.assign(model_.frames.size(), k_ground);
    for (std::size_t frame = 0; frame < model_.frames.size(); ++frame) {
      if (carries_[frame] != 0) add_frame(frame);
    }
    for (std::size_t body = 0; body < model_.bodies.size(); ++body) add_part(body);
    for (std::size_t frame = 0; frame < model_.frames.size(); ++frame) result_.places.push_back(place(frame));
    result_.ends = ends_;
    return is_complete_ ? std::optional<Linkage>(std::move(result_)) : std::nullopt;
  }

 private:
  // Frames come after their parents.
  void find_carriers() {
    carries_.assign(model_.frames.size(), 0);
    for (const model::Body& body : model_.bodies) carries_[body.frame] = 1;
    for (std::size_t i = model_.frames.size(); i-- > 0;) {
      if (carries_[i] != 0 && model_.frames[i].parent != model::k_space) carries_[model_.frames[i].parent] = 1;
    }
  }

  void add_frame(std::size_t index) {
    const model::Frame& frame = model_.frames[index];
    at_ = frame.parent == model::k_space ? k_ground : ends_[frame.parent];
    frame_ = index;
    name_ = frame.name.text;
    add_shift(held(expressions_(frame.position)));
    if (const auto* turns = std::get_if<model::Turns>(&frame.attitude)) {
      for (const model::Turn& turn : *turns) add_turn(turn);
    } else if (const auto* orientation = std::get_if<model::QuaternionOrientation>(&frame.attitude)) {
      add_free_turn(orientation->index);
    }
    ends_[index] = at_;
  }

  Vector3 held(const Vector3& v) { return {hold_(v[0]), hold_(v[1]), hold_(v[2])}; }

  Link link(Link::Kind kind) const {
    return {kind, at_, frame_, name_, zero_, 0, {}, {}, {zero_, zero_, zero_}, zero_, zero_, {}};
  }

  struct Axis {
    std::size_t index;
    int sense;
  };

  /// x, y or z, also where it is given as a vector along one of them; nothing in general position.
  std::optional<Axis> axis_of(const model::Turn& turn) const {
    if (const char* letter = std::get_if<char>(&turn.axis)) return Axis{static_cast<std::size_t>(*letter - 'x'), 1};
    const Vector3 v = expressions_(std::get<std::array<model::Ast, 3>>(turn.axis));
    std::optional<Axis> axis;
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[k].is_zero()) continue;
      const ir::Node& node = graph()[v[k].id()];
      if (axis || node.kind != ir::Kind::constant) return std::nullopt;
      axis = Axis{k, node.value < 0 ? -1 : 1};
    }
    return axis;
  }

  // What carries nothing with mass is no link of its own.
  std::optional<Place> place(std::size_t index) {
    const Matrix3 identity = ir::identity3(graph());
    if (carries_[index] != 0) return Place{ends_[index], zero_, identity};
    const model::Frame& frame = model_.frames[index];
    std::optional<Place> result =
        frame.parent == model::k_space ? Place{k_ground, zero_, identity} : result_.places[frame.parent];
    if (!result) return std::nullopt;
    result->position = result->position + ir::multiply(result->axes, held(expressions_(frame.position)));
    result->is_fixed = result->is_fixed && stays(*result);
    if (std::holds_alternative<std::monostate>(frame.attitude)) return result;
    const auto* turns = std::get_if<model::Turns>(&frame.attitude);
    if (turns == nullptr) return std::nullopt;
    for (const model::Turn& turn : *turns) {
      const std::optional<Axis> axis = axis_of(turn);
      if (!axis) return std::nullopt;
      const Expr angle = support::Rational(axis->sense) * hold_(expressions_(turn.angle));
      for (Vector3& row : result->axes) row = ir::turned(row, axis->index, -angle);
    }
    result->is_fixed = result->is_fixed && stays(*result);
    return result;
  }

  static bool stays(const Place& place) {
    return is_fixed(place.position) && std::all_of(place.axes.begin(), place.axes.end(), is_fixed);
  }

  ir::Graph& graph() const { return expressions_.graph(); }

  void append(Link link) {
    find_freedoms(link);
    result_.links.push_back(std::move(link));
    at_ = result_.links.size() - 1;
  }

  void add_shift(const Vector3& offset) {
    if (is_zero(offset)) return;
    Link shift = link(Link::Kind::shift);
    shift.offset = offset;
    shift.velocity = held(expressions_.rate(offset));
    shift.drift = held(expressions_.rate(shift.velocity));
    append(std::move(shift));
  }

  void add_turn(const model::Turn& turn) {
    const std::optional<Axis> axis = axis_of(turn);
    if (!axis) {
      is_complete_ = false;
      return;
    }
    const Expr angle = support::Rational(axis->sense) * hold_(expressions_(turn.angle));
    if (angle.is_zero()) return;
    Link link = this->link(Link::Kind::turn);
    link.axis = axis->index;
    link.angle = angle;
    link.rate = hold_(expressions_.rate(angle));
    link.velocity[link.axis] = *link.rate;
    link.drift[link.axis] = hold_(expressions_.rate(link.velocity[link.axis]));
    append(std::move(link));
  }

  // Angular velocities along the turned axes are the accelerations of the links themselves; along the axes before they are not.
  void add_free_turn(std::size_t orientation) {
    if (model_.orientations[orientation].axes != model::Axes::body) {
      is_complete_ = false;
      return;
    }
    Link link = this->link(Link::Kind::free);
    const std::size_t first_e = symbols_.first_quaternion_component[orientation].value;
    const auto e = [&](std::size_t i) {
      return expressions_.symbol(symbols_.configuration[ConfigurationIndex{first_e + i}].symbol);
    };
    link.matrix = quaternion_matrix({e(0), e(1), e(2), e(3)});
    const std::size_t first_u = symbols_.first_angular_velocity[orientation].value;
    for (std::size_t i = 0; i < 3; ++i) {
      link.velocity[i] = expressions_.symbol(symbols_.speeds[FreeIndex{first_u + i}].symbol);
    }
    append(std::move(link));
  }

  void find_freedoms(Link& link) {
    for (const FreeIndex i : speeds_in(link.velocity)) {
      const ir::SymbolId speed = symbols_.speeds[i].symbol;
      const Vector3 column{ir::partial(link.velocity[0], speed), ir::partial(link.velocity[1], speed),
                           ir::partial(link.velocity[2], speed)};
      if (!is_zero(column)) link.freedoms.push_back({i, column});
    }
  }

  /// In the order of the model.
  std::vector<FreeIndex> speeds_in(const Vector3& v) const {
    const ir::Graph& graph = expressions_.graph();
    std::vector<FreeIndex> found;
    for (const ir::NodeId id : ir::post_order(graph, {v[0].id(), v[1].id(), v[2].id()})) {
      if (graph[id].kind != ir::Kind::symbol) continue;
      if (const auto place = speeds_.find(graph[id].symbol.index); place != speeds_.end())
        found.push_back(place->second);
    }
    std::sort(found.begin(), found.end(), [](FreeIndex a, FreeIndex b) { return a.value < b.value; });
    return found;
  }

  void add_part(std::size_t index) {
    const model::Body& body = model_.bodies[index];
    const std::size_t link = body.frame == model::k_space ? k_ground : ends_[body.frame];
    if (link == k_ground) return;
    Part part{index, link, expressions_(body.mass), expressions_(body.centre), {zero_, zero_, zero_}};
    if (body.inertia) part.inertia = inertia_matrix(*body.inertia, expressions_);
    result_.parts.push_back(std::move(part));
  }

  const model::Model& model_;
  const Symbols& symbols_;
  Expressions& expressions_;
  ir::Substitution& hold_;
  Vector3 zero_;
  std::vector<char> carries_;
  std::vector<std::size_t> ends_;  ///< of frames: their last links
  std::size_t at_ = k_ground;
  std::size_t frame_ = 0;
  std::string name_;
  Linkage result_;
  bool is_complete_ = true;
  std::unordered_map<std::uint32_t, FreeIndex> speeds_;  ///< by symbol
};

}  // namespace

bool is_fixed(const Vector3& v) {
  return std::all_of(v.begin(), v.end(), [](Expr e) { return ir::is_of_parameters(e.graph(), e.id()); });
}

std::optional<Linkage> build_linkage(const model::Model& model, const Symbols& symbols, Expressions& expressions,
                                     ir::Substitution& hold) {
  return Builder(model, symbols, expressions, hold).run();
}

}  // namespace gaussgen::kinematics
