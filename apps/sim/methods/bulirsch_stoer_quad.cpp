// In float128, for references of models without power series: the coefficients of extrapolation are exact in any number type.

#include "sim/drive/wide.hpp"
#include "sim/methods/bulirsch_stoer.hpp"
#include "sim/methods/settings.hpp"

namespace gausssim {

namespace {

class InQuads final : public Integrator<Quad> {
 public:
  explicit InQuads(const Problem<Quad>& problem)
      : model_(MotionModel<Wide>(widened(problem.model.functions()))
                   .projecting(problem.settings.projection, Wide(problem.t), widened(problem.start))),
        steps_(model_, widened(problem.start), Wide(problem.t), settings_of<Quad, Wide>(problem)) {}

  bool advance_to(const Quad& end) override { return steps_.advance_to(Wide(end)); }
  Quad time() const override { return narrow(steps_.time()); }
  const Numbers<Quad>& state() const override {
    shown_.clear();
    for (const Wide& value : steps_.state()) shown_.push_back(narrow(value));
    return shown_;
  }
  Progress<Quad> progress() const override {
    const Progress<Wide> of_steps = steps_.progress();
    Progress<Quad> progress = progress_of<Quad>(of_steps);
    progress.why = of_steps.why;
    return progress;
  }

 private:
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
