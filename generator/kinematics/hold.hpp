#pragma once

#include "ir/substitute.hpp"
#include "kinematics/kinematics.hpp"

namespace gaussgen::kinematics {

/// c^i(t) for x^i, ċ^i for ẋ^i, c̈^i for ẍ^i.
ir::Substitution held_laws(const model::Model& model, Expressions& expressions, const Symbols& symbols);

/// Puts x^i = c^i(t), ẋ^i = ċ^i in (Vujičić (1.4), theory section 4).
class Holder {
 public:
  Holder(const model::Model& model, Expressions& expressions, const Symbols& symbols)
      : put_in_(held_laws(model, expressions, symbols)) {}

  void operator()(ir::Expr& expression) { expression = put_in_(expression); }

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

  void operator()(std::vector<Cut>& cuts) {
    for (Cut& cut : cuts) (*this)(cut.point);
  }

  void operator()(std::vector<HeldFrame>& frames) {
    for (HeldFrame& frame : frames) {
      (*this)(frame.cut.point);
      (*this)(frame.velocity);
      (*this)(frame.omega);
    }
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

  void operator()(std::vector<BodyLoad>& loads) {
    for (BodyLoad& load : loads) {
      (*this)(load.force);
      (*this)(load.moment);
    }
  }

  void operator()(ConstraintRow& row) {
    if (row.f) (*this)(*row.f);
    (*this)(row.phi);
    (*this)(row.phi_beside);
    (*this)(row.beta);
    (*this)(row.beside);
    (*this)(row.carried);
    (*this)(row.beta_drift);
    if (row.point) (*this)(*row.point);
    for (ConstraintAction& action : row.actions) {
      (*this)(action.point);
      (*this)(action.direction);
      if (action.local) (*this)(action.local->components);
      if (action.along_way) (*this)(*action.along_way);
    }
  }

 private:
  ir::Substitution put_in_;
};

/// Into everything that is there; fills held_acceleration with c̈^i.
void hold_coordinates(Holder& hold, Kinematics& kinematics);

}  // namespace gaussgen::kinematics
