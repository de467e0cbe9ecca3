#pragma once
// Methods of libraries in float128, for references of models without power series: of those whose coefficients are exact in any number type.

#include <memory>

#include "sim/drive/wide.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

/// Numbers go in and out; `make` has the problem in the type that libraries know.
class InQuads final : public Integrator<Quad> {
 public:
  InQuads(const Problem<Quad>& problem, Made<Wide> (*make)(const Problem<Wide>&))
      : model_(MotionModel<Wide>(widened(problem.model.functions()))
                   .projecting(problem.settings.projection, Wide(problem.t), widened(problem.start))),
        steps_(make({model_, widened(problem.start), Wide(problem.t), problem.settings.in<Wide>()})) {}

  bool advance_to(const Quad& end) override { return steps_->advance_to(Wide(end)); }
  Quad time() const override { return narrow(steps_->time()); }
  const Numbers<Quad>& state() const override {
    shown_.clear();
    for (const Wide& value : steps_->state()) shown_.push_back(narrow(value));
    return shown_;
  }
  Progress<Quad> progress() const override {
    const Progress<Wide> of_steps = steps_->progress();
    Progress<Quad> progress = progress_of<Quad>(of_steps);
    progress.why = of_steps.why;
    return progress;
  }

 private:
  mutable Numbers<Quad> shown_;
  MotionModel<Wide> model_;
  Made<Wide> steps_;
};

}  // namespace gausssim
