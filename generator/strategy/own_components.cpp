#include "strategy/own_components.hpp"

#include <algorithm>

#include "strategy/axes.hpp"

namespace gaussgen::strategy {

using kinematics::Freedom;
using kinematics::k_ground;
using kinematics::Link;

namespace {

class Finder {
 public:
  Finder(const std::vector<Link>& links, const std::vector<char>& is_acted_on)
      : links_(links), is_acted_on_(is_acted_on) {
    result_.of_joint.resize(links.size());
    result_.uses.resize(is_acted_on.size());
    result_.is_owned.assign(is_acted_on.size(), 0);
    where_.resize(is_acted_on.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (const Freedom& freedom : links[i].freedoms) where_[freedom.speed.value].push_back(i);
    }
  }

  OwnComponents run(const std::vector<std::pair<std::size_t, std::size_t>>& released) {
    for (const auto& [link, k] : released) result_.of_joint[link][k].is_free = true;
    // Each component that is found free frees others of what moves them, too.
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t i = 0; i < links_.size(); ++i) is_changed = find(i) || is_changed;
    }
    for (std::size_t u = 0; u < where_.size(); ++u) {
      for (const std::size_t i : where_[u]) {
        if (is_owner(i, u) || !components(i, *freedom_of(i, u)).empty()) result_.uses[u].push_back(i);
      }
    }
    return std::move(result_);
  }

 private:
  const Freedom* freedom_of(std::size_t link, std::size_t speed) const {
    for (const Freedom& freedom : links_[link].freedoms) {
      if (freedom.speed.value == speed) return &freedom;
    }
    return nullptr;
  }

  /// Along which a speed does something: not where the component is free, unless something acts on it and so on this speed.
  std::vector<std::size_t> components(std::size_t link, const Freedom& freedom) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < 3; ++k) {
      if (freedom.column[k].is_zero()) continue;
      const OwnComponent& own = result_.of_joint[link][k];
      const bool acts =
          own.freedom != nullptr && own.freedom != &freedom && is_acted_on_[own.freedom->speed.value] != 0;
      if (!own.is_free || acts) found.push_back(k);
    }
    return found;
  }

  bool find(std::size_t i) {
    bool is_changed = false;
    for (const Freedom& freedom : links_[i].freedoms) {
      const std::vector<std::size_t> here = components(i, freedom);
      if (here.size() != 1 || result_.of_joint[i][here[0]].is_free || is_used_elsewhere(i, freedom)) continue;
      const ir::Expr entry = freedom.column[here[0]];
      if (entry.graph()[entry.id()].kind != ir::Kind::constant) continue;
      result_.of_joint[i][here[0]] = {true, &freedom};
      result_.is_owned[freedom.speed.value] = 1;
      result_.in_order.emplace_back(i, here[0]);
      is_changed = true;
    }
    return is_changed;
  }

  bool is_used_elsewhere(std::size_t i, const Freedom& freedom) const {
    const std::size_t u = freedom.speed.value;
    return std::any_of(where_[u].begin(), where_[u].end(), [&](std::size_t other) {
      return other != i && (!components(other, *freedom_of(other, u)).empty() || is_owner(other, u));
    });
  }

  bool is_owner(std::size_t link, std::size_t speed) const {
    return std::any_of(result_.of_joint[link].begin(), result_.of_joint[link].end(), [&](const OwnComponent& own) {
      return own.freedom != nullptr && own.freedom->speed.value == speed;
    });
  }

  const std::vector<Link>& links_;
  const std::vector<char>& is_acted_on_;
  std::vector<std::vector<std::size_t>> where_;
  OwnComponents result_;
};

bool has_mass(const MassProperties& body) {
  return !body.mass.is_zero() || !is_zero(body.first) ||
         !std::all_of(body.inertia.begin(), body.inertia.end(), [](const ir::Vector3& row) { return is_zero(row); });
}

/// Turns of these axes leave the free components among themselves.
bool keeps(const Link& link, const std::array<bool, 3>& along) {
  if (link.kind == Link::Kind::shift) return link.freedoms.empty();
  if (keeps_axes(link)) return true;
  if (link.kind == Link::Kind::free) return along[0] && along[1] && along[2];
  return along[(link.axis + 1) % 3] == along[(link.axis + 2) % 3];
}

/// As far as nothing has mass or hangs beside: there Z knows the origin by its axes, where its inertia is constant.
std::size_t anchor_of(const FloatingBase& floating, const std::vector<Link>& links,
                      const std::vector<MassProperties>& properties,
                      const std::vector<std::vector<std::size_t>>& children, bool is_acted_on) {
  std::size_t at = floating.base;
  while (!has_mass(properties[at]) && children[at].size() == 1) {
    const std::size_t next = children[at][0];
    if (!keeps(links[next], floating.along) || (is_acted_on && links[next].kind == Link::Kind::shift)) break;
    at = next;
  }
  return at;
}

}  // namespace

const FloatingBase* OwnComponents::base_anchored_at(std::size_t link) const {
  for (const FloatingBase& floating : bases) {
    if (floating.anchor == link) return &floating;
  }
  return nullptr;
}

const FloatingBase* OwnComponents::base_at(std::size_t link) const {
  for (const FloatingBase& floating : bases) {
    if (floating.base == link) return &floating;
  }
  return nullptr;
}

OwnComponents own_components(const std::vector<Link>& links, const std::vector<MassProperties>& properties,
                             const std::vector<char>& is_acted_on,
                             const std::vector<std::pair<std::size_t, std::size_t>>& released) {
  OwnComponents result = Finder(links, is_acted_on).run(released);
  const auto children = children_of(links);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].kind != Link::Kind::shift || links[i].parent != k_ground) continue;
    FloatingBase floating{i, i, {}};
    bool acts = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const OwnComponent& own = result.of_joint[i][k];
      floating.along[k] = own.is_free;
      acts = acts || (own.freedom != nullptr && is_acted_on[own.freedom->speed.value] != 0);
    }
    if (!floating.along[0] && !floating.along[1] && !floating.along[2]) continue;
    floating.anchor = anchor_of(floating, links, properties, children, acts);
    result.bases.push_back(floating);
  }
  return result;
}

}  // namespace gaussgen::strategy
