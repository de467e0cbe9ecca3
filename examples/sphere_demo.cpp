// The paper's ball, simulated by generated code and held against its closed form. `./run demo` builds and runs this.

#include "sphere/report.hpp"

namespace {

sphere::Result judged(sphere::Run run, const sphere::Data& data) {
  const sphere::Errors errors = sphere::compare(run.samples, sphere::closed_form_at(run.samples, data));
  return {std::move(run), errors};
}

}  // namespace

int main() {
  const sphere::Plan plan;
  const sphere::Bars bars;
  const sphere::Data data = sphere::data_of_models();
  sphere::print_introduction(data, plan);

  const sphere::Result euler = judged(sphere::run_euler(plan), data);
  const sphere::Result quaternion = judged(sphere::run_quaternion(plan), data);
  const sphere::Slips slips{sphere::elimination_sign(), sphere::rolling_along(), sphere::normal_reaction()};

  sphere::print_motion(euler, quaternion, sphere::closed_form_at(quaternion.run.samples, data));
  sphere::print_errors(euler, quaternion, bars);
  sphere::print_effort(euler, quaternion);
  sphere::print_lowest_point(quaternion, sphere::ClosedForm(data));
  sphere::print_slips(slips);
  return sphere::print_verdict(euler, quaternion, slips, bars) ? 0 : 1;
}
