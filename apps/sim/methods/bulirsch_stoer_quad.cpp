// In float128, for references of models without power series: the coefficients of extrapolation are exact in any number type.

#include "sim/drive/wide.hpp"
#include "sim/methods/bulirsch_stoer.hpp"
#include "sim/methods/makers.hpp"

namespace gausssim {

namespace {

class InQuads final : public Integrator<Quad> {
 public:
  explicit InQuads(const Problem<Quad>& problem)
      : model_(MotionModel<Wide>(widened(problem.model.functions()))
                   .projecting(problem.settings.projection, Wide(problem.t), widened(problem.start))),
        steps_(model_, widened(problem.start), Wide(problem.t), settings_with(problem, model_.projects())) {}

  bool advance_to(const Quad& end) override { return steps_.advance_to(Wide(end)); }
  Quad time() const override { return narrow(steps_.time()); }
  const Numbers<Quad>& state() const override {
    shown_.clear();
    for (const Wide& value : steps_.state()) shown_.push_back(narrow(value));
    return shown_;
  }
  Progress<Quad> progress() const override {
    const Progress<Wide> of_steps = steps_.progress();
    Progress<Quad> progress;
    progress.outcome = of_steps.outcome;
    progress.status = of_steps.status;
    progress.why = of_steps.why;
    progress.steps = of_steps.steps;
    progress.rejected = of_steps.rejected;
    progress.calls = of_steps.calls;
    progress.with_fewer_constraints = of_steps.with_fewer_constraints;
    progress.start_moved = narrow(of_steps.start_moved);
    progress.start_component = of_steps.start_component;
    return progress;
  }

 private:
  static gauss::simulate::Settings<Wide> settings_with(const Problem<Quad>& problem, bool projects) {
    gauss::simulate::Settings<Wide> settings;
    settings.tolerance = Wide(problem.settings.tolerance);
    settings.longest_step = Wide(problem.settings.longest_step);
    settings.most_steps = problem.settings.most_steps;
    settings.project = projects;
    return settings;
  }

  mutable Numbers<Quad> shown_;
  MotionModel<Wide> model_;
  BulirschStoer<Wide> steps_;
};

}  // namespace

template <>
Made<Quad> make_bulirsch_stoer(const Problem<Quad>& problem) {
  return std::make_unique<InQuads>(problem);
}

}  // namespace gausssim
