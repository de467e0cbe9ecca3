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

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  const Matrix3 columns = ir::transposed(b);
  return ir::transposed({ir::multiply(a, columns[0]), ir::multiply(a, columns[1]), ir::multiply(a, columns[2])});
}

class Builder {
 public:
  Builder(const model::Model& model, const Symbols& symbols, Expressions& expressions, ir::Substitution& hold)
      : model_(model),
        symbols_(symbols),
        expressions_(expressions),
        hold_(hold),
        zero_(ir::zero3(expressions.graph())),
        axes_(ir::identity3(expressions.graph())) {
    for (const FreeIndex i : symbols.speeds.indices()) speeds_.emplace(symbols.speeds[i].symbol.index, i);
  }

  Linkage run() {
    find_carriers();
    ends_.assign(model_.frames.size(), k_ground);
    axes_of_.assign(model_.frames.size(), axes_);
    aligned_of_.assign(model_.frames.size(), std::nullopt);
    for (std::size_t frame = 0; frame < model_.frames.size(); ++frame) {
      if (carries_[frame] != 0) add_frame(frame);
    }
    for (std::size_t body = 0; body < model_.bodies.size(); ++body) add_part(body);
    for (std::size_t frame = 0; frame < model_.frames.size(); ++frame) result_.places.push_back(place(frame));
    result_.ends = ends_;
    return std::move(result_);
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
    const bool is_in_space = frame.parent == model::k_space;
    axes_ = is_in_space ? ir::identity3(graph()) : axes_of_[frame.parent];
    aligned_ = is_in_space ? std::nullopt : aligned_of_[frame.parent];
    frame_ = index;
    name_ = frame.name.text;
    add_shift(ir::multiply(axes_, held(expressions_(frame.position))));
    if (const auto* turns = std::get_if<model::Turns>(&frame.attitude)) {
      for (const model::Turn& turn : *turns) add_turn(turn);
    } else if (const auto* orientation = std::get_if<model::QuaternionOrientation>(&frame.attitude)) {
      add_free_turn(orientation->index);
    }
    ends_[index] = at_;
    axes_of_[index] = axes_;
    aligned_of_[index] = aligned_;
  }

  Vector3 held(const Vector3& v) { return {hold_(v[0]), hold_(v[1]), hold_(v[2])}; }

  Link link(Link::Kind kind) const {
    return {kind, at_, frame_, name_, zero_, 0, {}, {}, {zero_, zero_, zero_}, zero_, zero_, {}, {}, {}};
  }

  /// By which fixed turns, each about one of the axes that those before it lead to, one of the axes comes to lie along a direction.
  struct Alignment {
    std::vector<std::pair<std::size_t, Expr>> turns;
    std::size_t axis = 0;
    int sense = 1;
  };

  /// Of unit length, in the axes of the frame before the turn.
  Vector3 direction_of(const model::Turn& turn) const {
    if (const char* letter = std::get_if<char>(&turn.axis))
      return ir::unit_vector(graph(), static_cast<std::size_t>(*letter - 'x'));
    const Vector3 v = expressions_(std::get<std::array<model::Ast, 3>>(turn.axis));
    return pow(ir::dot(v, v), Rational(-1) / 2) * v;
  }

  Alignment aligned_with(const Vector3& d) const {
    std::vector<std::size_t> given;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!d[k].is_zero()) given.push_back(k);
    }
    const auto is_number = [&](std::size_t k) { return graph()[d[k].id()].kind == ir::Kind::constant; };
    if (given.size() == 1 && is_number(given[0])) return {{}, given[0], graph()[d[given[0]].id()].value < 0 ? -1 : 1};
    const auto about = [&](std::size_t axis) {
      const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
      return std::pair{axis, atan2(d[q], d[p])};
    };
    if (given.size() == 1) return {{about((given[0] + 2) % 3)}, given[0], 1};
    if (given.size() == 2) {
      const std::size_t across = 3 - given[0] - given[1];
      return {{about(across)}, (across + 1) % 3, 1};
    }
    // The first of two turns can become part of the turn before, if that is about the same axis.
    const std::size_t first = axis_before().value_or(2), p = (first + 1) % 3, q = (first + 2) % 3;
    const Expr rest = pow(pow(d[p], 2) + pow(d[q], 2), Rational(1) / 2);
    return {{about(first), {q, atan2(-d[first], rest)}}, p, 1};
  }

  std::optional<std::size_t> axis_before() const {
    std::size_t at = at_;
    while (at != k_ground && result_.links[at].kind == Link::Kind::shift) at = result_.links[at].parent;
    if (at == k_ground || result_.links[at].kind != Link::Kind::turn) return std::nullopt;
    return result_.links[at].axis;
  }

  static Expr atan2(Expr y, Expr x) { return {y.graph(), y.graph().call(ir::Function::atan2, {y.id(), x.id()})}; }

  // What carries nothing with mass is no link of its own.
  std::optional<Place> place(std::size_t index) {
    const Matrix3 identity = ir::identity3(graph());
    if (carries_[index] != 0) return Place{ends_[index], zero_, axes_of_[index]};
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
      const Alignment aligned = aligned_with(direction_of(turn));
      const Expr angle = Rational(aligned.sense) * hold_(expressions_(turn.angle));
      for (Vector3& row : result->axes) row = turned(row, aligned, angle);
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

  /// A row of a matrix times the matrix of a turn.
  static Vector3 turned(Vector3 row, const Alignment& aligned, Expr angle) {
    for (const auto& [axis, fixed] : aligned.turns) row = ir::turned(row, axis, -fixed);
    row = ir::turned(row, aligned.axis, -angle);
    for (auto fixed = aligned.turns.rbegin(); fixed != aligned.turns.rend(); ++fixed)
      row = ir::turned(row, fixed->first, fixed->second);
    return row;
  }

  // About an axis in general position: fixed turns first, until one of the axes lies along it. They stay, and the axes of frames behind are
  // given in those of the links.
  void add_turn(const model::Turn& turn) {
    const Expr angle = hold_(expressions_(turn.angle));
    if (angle.is_zero()) return;
    const Vector3 direction = direction_of(turn);
    const bool is_known = aligned_ && aligned_->direction == direction;
    const Alignment aligned =
        is_known ? Alignment{{}, aligned_->axis, 1} : aligned_with(ir::multiply(axes_, direction));
    for (const auto& [axis, fixed] : aligned.turns) {
      append_turn(axis, fixed);
      turn_axes(axis, fixed);
    }
    append_turn(aligned.axis, Rational(aligned.sense) * angle);
    if (!is_known) aligned_.reset();
    if (!aligned.turns.empty()) aligned_ = Aligned{direction, aligned.axis};
  }

  // Numbers are exact, and would grow with each turn: from here on entries are values of their own.
  void turn_axes(std::size_t axis, Expr angle) {
    axes_ = ir::transposed(axes_);
    for (Vector3& axis_of_frame : axes_) axis_of_frame = ir::turned(axis_of_frame, axis, -angle);
    axes_ = ir::transposed(axes_);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) axes_[i][j] = axes_[i][j].named("axes_" + name_ + "_" + "xyz"[i] + "xyz"[j]);
    }
  }

  void append_turn(std::size_t axis, Expr angle) {
    Link link = this->link(Link::Kind::turn);
    link.axis = axis;
    link.angle = angle;
    link.rate = hold_(expressions_.rate(angle));
    link.velocity[axis] = *link.rate;
    link.drift[axis] = hold_(expressions_.rate(link.velocity[axis]));
    append(std::move(link));
  }

  // Angular velocities along the turned axes are those of the link itself. Along the axes before, they are that, turned back:
  // u = Q ω and du/dt = Q dω/dt, as dQ/dt ω = Q (ω × ω).
  void add_free_turn(std::size_t orientation) {
    Link link = this->link(Link::Kind::free);
    const std::size_t first_e = symbols_.first_quaternion_component[orientation].value;
    const auto e = [&](std::size_t i) {
      return expressions_.symbol(symbols_.configuration[ConfigurationIndex{first_e + i}].symbol);
    };
    const Matrix3 turn = quaternion_matrix({e(0), e(1), e(2), e(3)});
    const bool is_straight = axes_ == ir::identity3(graph());
    link.matrix = is_straight ? turn : product(axes_, turn);
    const std::size_t first_u = symbols_.first_angular_velocity[orientation].value;
    for (std::size_t i = 0; i < 3; ++i) {
      const FreeIndex speed{first_u + i};
      link.velocity[i] = expressions_.symbol(symbols_.speeds[speed].symbol);
      link.freedoms.push_back({speed, ir::unit_vector(graph(), i)});
    }
    if (model_.orientations[orientation].axes != model::Axes::body) {
      if (is_straight) link.velocity_before = link.velocity;
      link.velocity = ir::multiply(ir::transposed(turn), link.velocity);
      link.to_speeds = turn;
    }
    axes_ = ir::identity3(graph());
    aligned_.reset();
    result_.links.push_back(std::move(link));
    at_ = result_.links.size() - 1;
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
    const Matrix3& axes = axes_of_[body.frame];
    const Vector3 centre = ir::multiply(axes, expressions_(body.centre));
    Part part{index, link, expressions_(body.mass), centre, {zero_, zero_, zero_}};
    if (body.inertia) {
      part.inertia = product(product(axes, inertia_matrix(*body.inertia, expressions_)), ir::transposed(axes));
    }
    result_.parts.push_back(std::move(part));
  }

  const model::Model& model_;
  const Symbols& symbols_;
  Expressions& expressions_;
  ir::Substitution& hold_;
  Vector3 zero_;
  std::vector<char> carries_;
  std::vector<std::size_t> ends_;  ///< of frames: their last links
  std::vector<Matrix3> axes_of_;   ///< of frames: from their axes to those of these links; of parameters and numbers
  std::size_t at_ = k_ground;
  Matrix3 axes_;  ///< likewise, of the frame at hand
  /// A direction of a frame along which one of the axes of its link was laid.
  struct Aligned {
    Vector3 direction;
    std::size_t axis;
  };
  std::optional<Aligned> aligned_;
  std::vector<std::optional<Aligned>> aligned_of_;
  std::size_t frame_ = 0;
  std::string name_;
  Linkage result_;
  std::unordered_map<std::uint32_t, FreeIndex> speeds_;  ///< by symbol
};

}  // namespace

void mix_speeds(Link& link) {
  if (!link.to_speeds) return;
  for (std::size_t j = 0; j < 3; ++j) link.freedoms[j].column = (*link.to_speeds)[j];
  link.to_speeds.reset();
}

Linkage with_mixed_speeds(Linkage linkage) {
  for (Link& link : linkage.links) mix_speeds(link);
  return linkage;
}

bool is_fixed(const Vector3& v) {
  return std::all_of(v.begin(), v.end(), [](Expr e) { return ir::is_of_parameters(e.graph(), e.id()); });
}

Linkage build_linkage(const model::Model& model, const Symbols& symbols, Expressions& expressions,
                      ir::Substitution& hold) {
  return Builder(model, symbols, expressions, hold).run();
}

}  // namespace gaussgen::kinematics
