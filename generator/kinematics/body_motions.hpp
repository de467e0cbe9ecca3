#pragma once

#include "ir/symbol_sets.hpp"
#include "kinematics/kinematics.hpp"

namespace gaussgen::kinematics {

/// Derivatives by the rates of y, of a model's expressions: each visits only what it changes.
class Partials {
 public:
  Partials(ir::Graph& graph, const Symbols& symbols);

  ir::Expr operator()(ir::Expr function, FullIndex i) {
    return depends(function, i) ? along_rate_[i.value](function) : zero_;
  }

  /// Whether the rate along A occurs in it: most do not, so that whoever goes over all of them asks first.
  bool depends(ir::Expr function, FullIndex i) { return rates_in_.depends(function.id(), i.value); }

  /// ∂v/∂ẏ^A for all A
  support::Indexed<FullIndex, ir::Vector3> operator()(const ir::Vector3& v);

 private:
  ir::SymbolSets rates_in_;  ///< of the nodes that are differentiated
  std::vector<ir::Directional> along_rate_;
  ir::Expr zero_;
};

/// The motion of a model's bodies with x^i free, without forces.
class BodyMotions {
 public:
  BodyMotions(const model::Model& model, Expressions& expressions, Partials& partials)
      : model_(model), expressions_(expressions), partials_(partials) {}

  const BodyMotion& operator[](BodyIndex body);

  ir::Vector3 position(BodyIndex body);  ///< of the mass centre, without the rest
  bool is_rigid(BodyIndex body) const { return model_.bodies[body.value].inertia.has_value(); }

 private:
  BodyMotion motion(const model::Body& body);
  void add_rotation(const model::Body& body, BodyMotion& motion);
  model::Axes preferred_axes(std::size_t frame) const;

  const model::Model& model_;
  Expressions& expressions_;
  Partials& partials_;
  std::unordered_map<std::size_t, BodyMotion> known_;
};

}  // namespace gaussgen::kinematics
