// The double pendulum of models/double_pendulum.yaml by MuJoCo's RK4, in steps of one length; see bench/accuracy_time.py.
//
//   mujoco_pendulum END SAMPLES STEPS_BETWEEN ROUNDS
//
// Prints the least seconds of processor time, then a row for each sample: time, pivot, elbow.

#include <mujoco/mujoco.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace {

// What a chain without contacts does not need is off. Of the moments of inertia only that about z counts.
const char* const k_model = R"(<mujoco>
 <compiler angle='radian'/>
 <option gravity='0 -9.81 0' integrator='RK4'>
  <flag constraint='disable' contact='disable' passive='disable' actuation='disable' sensor='disable'/>
 </option>
 <worldbody>
  <body>
   <joint type='hinge' axis='0 0 1'/>
   <inertial pos='0 -0.5 0' mass='1.2' diaginertia='0.1 0.001 0.1'/>
   <body pos='0 -1 0'>
    <joint type='hinge' axis='0 0 1'/>
    <inertial pos='0 -0.35 0' mass='0.9' diaginertia='0.03675 0.001 0.03675'/>
   </body>
  </body>
 </worldbody>
</mujoco>)";

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

mjModel* loaded() {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(std::strlen(k_model)));
  std::memcpy(files->filedata[0], k_model, std::strlen(k_model));
  char error[1000] = "";
  mjModel* const model = mj_loadXML("model.xml", files.get(), error, sizeof error);
  if (model == nullptr) std::fprintf(stderr, "MuJoCo: %s\n", error);
  mj_deleteVFS(files.get());
  return model;
}

struct Row {
  double t, pivot, elbow;
};

void run(const mjModel* model, mjData* data, int between, std::vector<Row>& rows) {
  constexpr double k_horizontal = 1.5707963267948966;
  mj_resetData(model, data);
  data->qpos[0] = k_horizontal;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (int i = 0; k > 0 && i < between; ++i) mj_step(model, data);
    rows[k] = {data->time, data->qpos[0], data->qpos[1]};
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  const double end = std::atof(argv[1]);
  const int samples = std::atoi(argv[2]), between = std::atoi(argv[3]), rounds = std::atoi(argv[4]);
  mjModel* const model = loaded();
  if (model == nullptr) return 1;
  model->opt.timestep = end / (samples - 1) / between;
  mjData* const data = mj_makeData(model);
  std::vector<Row> rows(static_cast<std::size_t>(samples));
  double least = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const double begin = now();
    run(model, data, between, rows);
    least = std::min(least, now() - begin);
  }
  std::printf("%.9g\n", least);
  for (const Row& row : rows) std::printf("%.17g %.17g %.17g\n", row.t, row.pivot, row.elbow);
  mj_deleteData(data);
  mj_deleteModel(model);
}
