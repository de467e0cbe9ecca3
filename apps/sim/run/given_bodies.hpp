#pragma once
// Bodies and attitudes that the values of a scene, or of options, make impossible.

#include <string>
#include <vector>

#include "model/evaluate.hpp"
#include "model/model.hpp"
#include "sim/scene/scene.hpp"
#include "support/diagnostics.hpp"

namespace gausssim {

/// Masses and inertias that no body has. Those of the model's file are looked at with it.
class GivenBodies {
 public:
  /// `own`: what an instance says itself; of an ordinary scene nothing.
  GivenBodies(const Scene& scene, gaussgen::support::Span own) : scene_(scene), own_(own) {}

  /// Before values are given.
  void look_at(const gaussgen::model::Model& as_in_file);
  /// With those of the scene, before those of options.
  void note_scene(const gaussgen::model::Model& with_values);
  /// With all of them: told at a parameter of the scene that may have made them so. Throws cli::UsageError where an option has.
  void check(const gaussgen::model::Model& with_all, const std::vector<std::string>& sets,
             gaussgen::support::Diagnostics& diagnostics) const;

 private:
  bool is_own(const Given& given) const;
  gaussgen::support::Span place() const;

  const Scene& scene_;
  gaussgen::support::Span own_;
  bool own_is_to_blame_ = false;  ///< without what the instance says, they are possible
  std::vector<gaussgen::support::Diagnostic> of_scene_;
};

/// Initial quaternions that scenes or options give; those of the model's file are looked at with it.
std::vector<std::string> remarks_on_quaternions(const gaussgen::model::Model& read,
                                                const gaussgen::model::Values& values);

}  // namespace gausssim
