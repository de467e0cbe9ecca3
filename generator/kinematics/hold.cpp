#include "kinematics/hold.hpp"

#include "ir/substitute.hpp"

namespace gaussgen::kinematics {

using ir::Expr;

namespace {

class Holder {
 public:
  explicit Holder(ir::Substitution& substitution) : put_in_(substitution) {}

  void operator()(Expr& expression) { expression = put_in_(expression); }

  template <class T, std::size_t n>
  void operator()(std::array<T, n>& entries) {
    for (T& entry : entries) (*this)(entry);
  }

  template <class Index, class T>
  void operator()(support::Indexed<Index, T>& entries) {
    for (T& entry : entries) (*this)(entry);
  }

  void operator()(BodyMotion& body) {
    (*this)(body.position);
    (*this)(body.velocity);
    (*this)(body.J);
    (*this)(body.h);
    (*this)(body.force);
    (*this)(body.moment);
    (*this)(body.rotation.matrix);
    (*this)(body.rotation.omega);
    (*this)(body.W);
    (*this)(body.eta);
  }

  void operator()(std::vector<AppliedForce>& forces) {
    for (AppliedForce& force : forces) {
      (*this)(force.point);
      (*this)(force.force);
      (*this)(force.moment);
      (*this)(force.unfelt_force);
      (*this)(force.unfelt_moment);
    }
  }

  void operator()(ConstraintRow& row) {
    if (row.f) (*this)(*row.f);
    (*this)(row.phi);
    (*this)(row.beta);
    (*this)(row.beside);
    (*this)(row.carried);
    (*this)(row.beta_drift);
    if (row.point) (*this)(*row.point);
    for (ConstraintAction& action : row.actions) {
      (*this)(action.point);
      (*this)(action.direction);
    }
  }

 private:
  ir::Substitution& put_in_;
};

}  // namespace

void hold_coordinates(const model::Model& model, Expressions& expressions, ir::Graph& graph, Kinematics& kinematics) {
  ir::Substitution substitution(graph);
  for (const HeldCoordinate& held : kinematics.symbols.held) {
    const Expr c = expressions(*model.coordinates[held.model_index].held_at).named(held.name);
    const Expr c_dot = expressions.rate(c).named(held.name + "_dot");
    const Expr c_ddot = expressions.rate(c_dot).named(held.name + "_ddot");
    substitution.replace(held.symbol, c);
    substitution.replace(held.rate, c_dot);
    substitution.replace(held.acceleration, c_ddot);
    kinematics.held_acceleration.push_back(c_ddot);
  }
  Holder hold(substitution);
  hold(kinematics.bodies);
  hold(kinematics.constraints);
  hold(kinematics.configuration_rates);
  hold(kinematics.speeds_at_rest);
  hold(kinematics.potential);
  hold(kinematics.body_force);
  hold(kinematics.applied);
  for (JointPlace& joint : kinematics.joints) hold(joint.point);
  hold(kinematics.other_force);
  hold(kinematics.carried_force);
  for (std::vector<Expr>& values : kinematics.quantities) {
    for (Expr& value : values) hold(value);
  }
}

}  // namespace gaussgen::kinematics
