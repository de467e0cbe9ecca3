// MuJoCo with everything switched off that a chain without contacts does not need: once by mj_forward, once by the steps of it that
// are left. Debian's library has no AVX code.

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "contender.hpp"

namespace {

using bench::Sample;

enum class Way { forward, steps, reactions };

/// printf with 17 digits.
template <class... Values>
std::string format(const char* text, Values... values) {
  char buffer[4096];
  std::snprintf(buffer, sizeof buffer, text, values...);
  return buffer;
}

/// A closed loop needs its constraint.
std::string document(const char* gravity, bool has_constraints, const std::string& world, const std::string& more) {
  const std::string off = has_constraints
                              ? "contact='disable' frictionloss='disable' limit='disable' warmstart='disable'"
                              : "constraint='disable' contact='disable'";
  return "<mujoco><compiler angle='radian'/><option gravity='" + std::string(gravity) + "'><flag " + off +
         " passive='disable' actuation='disable' sensor='disable'/></option><worldbody>" + world + "</worldbody>" +
         more + "</mujoco>";
}

std::string chain(int n, const char* hinges) {
  constexpr double m = 1.3, L = 0.7, J = m * L * L / 12;
  std::string open, close;
  for (int i = 0; i < n; ++i) {
    open += format("<body pos='0 0 %.17g'>", i == 0 ? 0.0 : -L) + hinges +
            format("<inertial pos='0 0 %.17g' mass='%.17g' diaginertia='%.17g %.17g 0.001'/>", -L / 2, m, J, J);
    close += "</body>";
  }
  return document("0 0 -9.81", false, open + close, "");
}

/// A bar along its own x axis, which a hinge holds at its beginning; `angle` closes the loop.
std::string bar(const char* name, double at, double angle, double m, double L) {
  return format(
      "<body name='%s' pos='%.17g 0 0' euler='0 0 %.17g'><joint type='hinge' axis='0 0 1' ref='%.17g'/>"
      "<inertial pos='%.17g 0 0' mass='%.17g' diaginertia='%.17g %.17g %.17g'/>",
      name, at, angle, angle, L / 2, m, m * L * L / 20, m * L * L / 20, m * L * L / 12);
}

std::string four_bar() {
  constexpr double L1 = 0.2, L2 = 0.6, L3 = 0.5, L4 = 0.55, crank = 0.6;
  const double x = L4 - L1 * std::cos(crank), y = -L1 * std::sin(crank), d = std::hypot(x, y);
  const double coupler = std::atan2(y, x) + std::acos((L2 * L2 + d * d - L3 * L3) / (2 * L2 * d));
  const double rocker = std::atan2(L2 * std::sin(coupler) - y, L2 * std::cos(coupler) - x);
  const std::string world = bar("crank", 0, crank, 0.5, L1) + bar("coupler", L1, coupler - crank, 1.5, L2) +
                            "</body></body>" + bar("rocker", L4, rocker, 1.2, L3) + "</body>";
  return document("0 -9.81 0", true, world,
                  format("<equality><connect body1='coupler' body2='rocker' anchor='%.17g 0 0'/></equality>", L2));
}

class Simulation {
 public:
  explicit Simulation(const std::string& text) {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    const int place = mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(text.size()));
    if (place != 0) throw std::runtime_error("MuJoCo takes no file");
    std::memcpy(files->filedata[0], text.data(), text.size());
    char error[1000] = "";
    model.reset(mj_loadXML("model.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error);
    data.reset(mj_makeData(model.get()));
  }

  std::unique_ptr<mjModel, void (*)(mjModel*)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data{nullptr, mj_deleteData};
};

class Chain : public bench::Contender {
 public:
  Chain(const std::string& text, Way way, double torque) : simulation_(text), way_(way) {
    if (torque != 0) simulation_.data->qfrc_applied[0] = torque;
  }

  void take(const bench::Samples& samples) override { samples_ = &samples; }
  void run(long calls) override {
    for (long i = 0; i < calls; ++i) evaluate(static_cast<std::size_t>(i) % bench::k_states);
  }
  bool accelerations(std::size_t state, double* a) override {
    evaluate(state);
    std::copy_n(simulation_.data->qacc, simulation_.model->nv, a);
    return true;
  }

 private:
  void evaluate(std::size_t state) {
    const mjModel* m = simulation_.model.get();
    mjData* d = simulation_.data.get();
    const Sample& sample = (*samples_)[state];
    std::copy(sample.q.begin(), sample.q.end(), d->qpos);
    std::copy(sample.v.begin(), sample.v.end(), d->qvel);
    if (way_ == Way::steps) {
      mj_kinematics(m, d);
      mj_comPos(m, d);
      mj_crb(m, d);
      mj_factorM(m, d);
      mj_comVel(m, d);
      mj_rne(m, d, 0, d->qfrc_bias);
      for (int i = 0; i < m->nv; ++i) d->qfrc_smooth[i] = -d->qfrc_bias[i];
      mj_solveM(m, d, d->qacc, d->qfrc_smooth, 1);
    } else {
      mj_forward(m, d);
      if (way_ == Way::reactions) mj_rnePostConstraint(m, d);
    }
  }

  Simulation simulation_;
  Way way_;
  const bench::Samples* samples_ = nullptr;
};

std::unique_ptr<bench::Contender> make(const std::string& kind, int size, Way way) {
  if (kind == "planar_chain")
    return std::make_unique<Chain>(chain(size, "<joint type='hinge' axis='0 1 0'/>"), way, 0.0);
  if (kind == "spatial_chain")
    return std::make_unique<Chain>(chain(size, "<joint type='hinge' axis='1 0 0'/><joint type='hinge' axis='0 1 0'/>"),
                                   way, 0.0);
  if (kind == "four_bar" && way != Way::steps) return std::make_unique<Chain>(four_bar(), way, 0.8);
  return nullptr;
}

const bench::Registration k_forward({"mujoco", "rhs", 1, true, [](const std::string& kind, int size) {
                                       return kind == "four_bar" ? nullptr : make(kind, size, Way::forward);
                                     }});
const bench::Registration k_steps({"mujoco, single steps", "rhs", 1, true,
                                   [](const std::string& kind, int size) { return make(kind, size, Way::steps); }});
const bench::Registration k_reactions({"mujoco", "joint_reactions", 1, false, [](const std::string& kind, int size) {
                                         return make(kind, size, Way::reactions);
                                       }});
// Its loop is soft, and its rows leave out what the rates of their directions add: not the same accelerations.
const bench::Registration k_soft({"mujoco", "rhs", 1, false, [](const std::string& kind, int size) {
                                    return kind == "four_bar" ? make(kind, size, Way::forward) : nullptr;
                                  }});

}  // namespace
