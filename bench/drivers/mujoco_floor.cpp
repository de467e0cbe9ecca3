// A chain of planar bars by MuJoCo's RK4, above a floor that it never reaches, and without a floor; see bench/effects.py.
//
//   mujoco_floor BARS STEPS ROUNDS
//
// Prints the least nanoseconds of processor time of a step: with contacts off, and with a floor 100 m below.

#include <mujoco/mujoco.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

namespace {

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Of the moments of inertia only that about y counts.
std::string chain(int bars, bool has_floor) {
  std::string text = "<mujoco><compiler angle='radian'/><option gravity='0 0 -9.81' integrator='RK4' timestep='1e-4'><flag ";
  text += has_floor ? "" : "constraint='disable' contact='disable' ";
  text += "actuation='disable' sensor='disable'/></option><worldbody>";
  if (has_floor) text += "<geom type='plane' size='0 0 1' pos='0 0 -100'/>";
  std::string ends;
  for (int i = 1; i <= bars; ++i) {
    const double m = 1 + i / 2.0;
    const std::string mass = std::to_string(m), moment = std::to_string(m * 0.25 / 12);
    text += i == 1 ? "<body>" : "<body pos='0 0 -0.5'>";
    text += "<joint type='hinge' axis='0 1 0' stiffness='3'/><inertial pos='0 0 -0.25' mass='" + mass + "' diaginertia='" + moment + " " +
            moment + " 0.001'/>";
    // A ball at its end may touch the floor, and nothing else.
    if (has_floor) text += "<geom type='sphere' size='0.01' pos='0 0 -0.5' contype='2' conaffinity='1'/>";
    ends += "</body>";
  }
  return text + ends + "</worldbody></mujoco>";
}

double ns_of_step(int bars, bool has_floor, int steps, int rounds) {
  const std::string text = chain(bars, has_floor);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  mjModel* const model = mj_loadXML("model.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) {
    std::fprintf(stderr, "MuJoCo: %s\n", error);
    std::exit(1);
  }
  mjData* const data = mj_makeData(model);
  double least = 1e9;
  for (int round = 0; round < rounds; ++round) {
    mj_resetData(model, data);
    for (int i = 0; i < bars; ++i) data->qpos[i] = 0.2 * (i + 1);
    const double begin = now();
    for (int i = 0; i < steps; ++i) mj_step(model, data);
    least = std::min(least, now() - begin);
  }
  mj_deleteData(data);
  mj_deleteModel(model);
  return 1e9 * least / steps;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const int bars = std::atoi(argv[1]), steps = std::atoi(argv[2]), rounds = std::atoi(argv[3]);
  std::printf("%.9g %.9g\n", ns_of_step(bars, false, steps, rounds), ns_of_step(bars, true, steps, rounds));
}
