// The paper's ball, simulated by generated code and held against its closed form. `./run demo` builds and runs this; with
// --svg FILE it draws the motion.

#include <cstdio>
#include <fstream>
#include <string>

#include "sphere/picture.hpp"
#include "sphere/report.hpp"

namespace {

sphere::Result judged(sphere::Run run, const sphere::Data& data) {
  const sphere::Errors errors = sphere::compare(run.samples, sphere::closed_form_at(run.samples, data));
  return {std::move(run), errors};
}

int draw(const std::string& file) {
  sphere::Plan plan;
  plan.sampling = 0.02;
  const sphere::Run run = sphere::run_quaternion(plan);
  if (!run.trouble.empty()) {
    std::fprintf(stderr, "no picture: %s\n", run.trouble.c_str());
    return 1;
  }
  std::ofstream stream(file, std::ios::binary);
  stream << sphere::picture_of(run, sphere::ClosedForm(sphere::data_of_models()));
  stream.close();
  if (!stream) {
    std::fprintf(stderr, "cannot write '%s'\n", file.c_str());
    return 3;
  }
  std::printf("wrote %s\n", file.c_str());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 3 && arguments[1] == std::string("--svg")) return draw(arguments[2]);
  if (count > 1) {
    std::fputs("usage: sphere_demo [--svg FILE]\n", stderr);
    return 2;
  }
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
