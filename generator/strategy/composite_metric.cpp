#include "strategy/composite_metric.hpp"

#include "ir/contract.hpp"
#include "strategy/link_axes.hpp"
#include "strategy/massed_links.hpp"

namespace gaussgen::strategy {

using ir::Expr;
using ir::Matrix3;
using ir::Vector3;
using kinematics::Freedom;
using kinematics::k_ground;
using kinematics::Link;

namespace {

/// All that a link carries, as one rigid body; about its origin, in space.
struct Composite {
  Expr mass;
  Vector3 first;    ///< mass times the mass centre
  Matrix3 inertia;  ///< only the upper half counts
};

/// Of a momentum, about the origin of a link.
struct Momentum {
  Vector3 linear;
  Vector3 angular;
};

class CompositeMetric {
 public:
  CompositeMetric(const kinematics::Linkage& linkage, const std::vector<std::string>& labels, ir::Graph& graph,
                  Steps& steps)
      : massed_(linkage, graph),
        links_(massed_.links()),
        labels_(labels),
        graph_(graph),
        steps_(steps),
        axes_(links_, graph),
        g_(labels.size(), Vector(labels.size(), number(0))) {}

  Matrix run() {
    find_composites();
    steps_.begin("metric g_ab (1.10): momentum by one speed, along the other");
    for (std::size_t j = 0; j < links_.size(); ++j) {
      for (const Freedom& freedom : links_[j].freedoms) carry(j, freedom, k_ground);
    }
    name_entries();
    return std::move(g_);
  }

  Vector diagonal() {
    find_composites();
    // A speed that moves one link alone has nothing to do with those before.
    std::vector<std::size_t> first(labels_.size(), k_ground);
    for (std::size_t j = links_.size(); j-- > 0;) {
      for (const Freedom& freedom : links_[j].freedoms) first[freedom.speed.value] = j;
    }
    for (std::size_t j = 0; j < links_.size(); ++j) {
      for (const Freedom& freedom : links_[j].freedoms) carry(j, freedom, links_[first[freedom.speed.value]].parent);
    }
    Vector result;
    for (std::size_t i = 0; i < labels_.size(); ++i) result.push_back(g_[i][i]);
    return result;
  }

 private:
  void find_composites() {
    steps_.begin("what each link carries as one rigid body, about the origin of the link, in space");
    for (std::size_t i = 0; i < links_.size(); ++i) {
      composites_.push_back(own(i));
      arms_.push_back(arm(i));
    }
    for (std::size_t i = links_.size(); i-- > 0;) complete(i);
  }

  Expr number(int value) const { return {graph_, graph_.constant(value)}; }

  Composite own(std::size_t i) {
    const MassProperties& rest = massed_.rest(i);
    const Matrix3& axes = axes_.of(i, steps_);
    // R I Rᵀ, of which the columns are R I times the rows of R.
    const auto column = [&](std::size_t k) { return ir::multiply(axes, ir::multiply(rest.inertia, axes[k])); };
    return {massed_.at_origin(i), ir::multiply(axes, rest.first), transposed(Matrix3{column(0), column(1), column(2)})};
  }

  Vector3 arm(std::size_t i) {
    if (links_[i].kind != Link::Kind::shift) return ir::zero3(graph_);
    return steps_.name(ir::multiply(axes_.of(i, steps_), links_[i].offset), "shift_" + links_[i].name);
  }

  // Masses at the origin stand at the first link that has it: links behind count them all the same, since nothing of their inertia is
  // asked for along a shift.
  void complete(std::size_t i) {
    Composite& body = composites_[i];
    const std::string& name = links_[i].name;
    body.mass = steps_.name_varying(body.mass, "mass_" + name);
    body.first = steps_.name(body.first, "mc_" + name);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = k; l < 3; ++l) {
        body.inertia[k][l] = steps_.name(body.inertia[k][l], "I_" + name + "_" + "xyz"[k] + "xyz"[l]);
        body.inertia[l][k] = body.inertia[k][l];
      }
    }
    if (links_[i].parent != k_ground) add_to(composites_[links_[i].parent], body, arms_[i]);
  }

  // Steiner's theorem with the mass centre at c and the origin at d: m (d·d 1 - d dᵀ) + 2 m c·d 1 - m (c dᵀ + d cᵀ).
  void add_to(Composite& sum, const Composite& body, const Vector3& d) const {
    const Vector3 moved = body.first + body.mass * d;
    sum.mass += body.mass;
    sum.first = sum.first + moved;
    const Expr both = dot(d, body.first + moved);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = k; l < 3; ++l) {
        Expr entry = body.inertia[k][l] - body.first[k] * d[l] - d[k] * moved[l];
        if (k == l) entry += both;
        sum.inertia[k][l] += entry;
      }
    }
  }

  Vector3 along(std::size_t i, const Freedom& freedom) { return ir::multiply(axes_.of(i, steps_), freedom.column); }

  Momentum momentum(std::size_t i, const Vector3& along) const {
    const Composite& body = composites_[i];
    if (links_[i].kind == Link::Kind::shift) return {body.mass * along, cross(body.first, along)};
    return {cross(along, body.first), ir::multiply(body.inertia, along)};
  }

  // To the link `end`, or to the ground, about the origin of each link on the way.
  void carry(std::size_t j, const Freedom& freedom, std::size_t end) {
    Momentum p = momentum(j, along(j, freedom));
    const std::string& label = labels_[freedom.speed.value];
    for (std::size_t i = j; i != k_ground && i != end; i = links_[i].parent) {
      for (const Freedom& other : links_[i].freedoms) {
        const bool is_linear = links_[i].kind == Link::Kind::shift;
        add(freedom, other, i == j, dot(along(i, other), is_linear ? p.linear : p.angular));
      }
      if (links_[i].parent == k_ground || links_[i].parent == end || is_zero(arms_[i])) continue;
      p.angular =
          steps_.name(p.angular + cross(arms_[i], p.linear), "L_" + label + "_" + links_[links_[i].parent].name);
    }
  }

  // Of two links, each of both orders counts.
  void add(const Freedom& a, const Freedom& b, bool is_same_link, Expr value) {
    const std::size_t i = a.speed.value, j = b.speed.value;
    g_[i][j] += value;
    if (!is_same_link) g_[j][i] += value;
  }

  void name_entries() {
    for (std::size_t i = 0; i < g_.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        g_[i][j] = steps_.name(g_[i][j], "G_" + labels_[j] + "_" + labels_[i]);
        g_[j][i] = g_[i][j];
      }
    }
  }

  MassedLinks massed_;
  const std::vector<Link>& links_;
  const std::vector<std::string>& labels_;
  ir::Graph& graph_;
  Steps& steps_;
  LinkAxes axes_;
  std::vector<Composite> composites_;
  std::vector<Vector3> arms_;
  Matrix g_;
};

}  // namespace

Matrix composite_metric(const kinematics::Linkage& linkage, const std::vector<std::string>& labels, ir::Graph& graph,
                        Steps& steps) {
  return CompositeMetric(linkage, labels, graph, steps).run();
}

Vector composite_inertias(const kinematics::Linkage& linkage, const std::vector<std::string>& labels, ir::Graph& graph,
                          Steps& steps) {
  return CompositeMetric(linkage, labels, graph, steps).diagonal();
}

}  // namespace gaussgen::strategy
