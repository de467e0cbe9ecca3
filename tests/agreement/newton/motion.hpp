#pragma once
// A model moved by numbers: where its frames are, how they move and accelerate, by differentiating along one motion. It reads the
// checked model and shares nothing with the mechanics of the generator: no Jacobians, no angular velocities of joints, no graph.

#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "model/model.hpp"
#include "newton/jet.hpp"

namespace agreement::newton {

/// Values of names with their derivatives.
using Values = std::unordered_map<std::string, Number>;

class Motion {
 public:
  Motion(const gaussgen::model::Model& model, Values values) : model_(model), values_(std::move(values)) {}

  Number operator()(const gaussgen::model::Ast& ast);
  Vector operator()(const std::array<gaussgen::model::Ast, 3>& components);

  Vector origin(std::size_t frame) { return placed(frame).origin; }
  Matrix axes(std::size_t frame) { return placed(frame).axes; }
  Vector point(std::size_t frame, const Vector& inside) { return origin(frame) + axes(frame) * inside; }

  /// In space, with its rate (and no second one).
  Vector omega(std::size_t frame);

  /// Rate of a material point of the frame that is at `place` now, with the acceleration that follows while `place` moves on.
  Vector velocity_at(std::size_t frame, const Vector& place);

  Values& values() { return values_; }

 private:
  struct Placed {
    Vector origin;
    Matrix axes;
  };

  const Placed& placed(std::size_t frame);
  Matrix turned(const gaussgen::model::Attitude& attitude);
  Matrix turn(const gaussgen::model::Turn& turn);
  Matrix quaternion(const gaussgen::model::Orientation& orientation);
  Number named(const std::string& name);
  Number call(const gaussgen::model::Ast& ast);
  Number piecewise(const gaussgen::model::Ast& ast);

  const gaussgen::model::Model& model_;
  Values values_;
  std::map<std::size_t, Placed> placed_;
};

/// A constant expression, such as an exponent.
Real number_of(const gaussgen::model::Ast& ast);

}  // namespace agreement::newton
