// Simbody. To be compiled without NDEBUG: Debian's library was, and its headers change the layout of classes with it.

#include <Simbody.h>

#include "contender.hpp"

namespace {

using namespace SimTK;

struct System {
  MultibodySystem all;
  SimbodyMatterSubsystem matter{all};
  GeneralForceSubsystem forces{all};
  State state;

  System() { matter.setShowDefaultGeometry(false); }
  void finish() {
    state = all.realizeTopology();
    all.realizeModel(state);
  }
};

constexpr double k_m = 1.3, k_L = 0.7, k_J = 1.0 / 12 * k_L * k_L, k_along = 0.001 / k_m;

void planar_chain(System& system, int n) {
  Force::Gravity(system.forces, system.matter, Vec3(0, -9.81, 0));
  const Vec3 centre(0, -k_L / 2, 0);
  const Body::Rigid rod(MassProperties(k_m, centre, UnitInertia(k_J, k_along, k_J).shiftFromCentroid(centre)));
  MobilizedBody above = system.matter.updGround();
  for (int i = 0; i < n; ++i)
    above = MobilizedBody::Pin(above, Transform(Vec3(0, i == 0 ? 0 : -k_L, 0)), rod, Transform());
}

void spatial_chain(System& system, int n) {
  Force::Gravity(system.forces, system.matter, Vec3(0, 0, -9.81));
  const Vec3 centre(0, 0, -k_L / 2);
  const Body::Rigid rod(MassProperties(k_m, centre, UnitInertia(k_J, k_J, k_along).shiftFromCentroid(centre)));
  MobilizedBody above = system.matter.updGround();
  for (int i = 0; i < n; ++i)
    above = MobilizedBody::Universal(above, Transform(Vec3(0, 0, i == 0 ? 0 : -k_L)), rod, Transform());
}

void four_bar(System& system) {
  constexpr double L1 = 0.2, L2 = 0.6, L3 = 0.5, L4 = 0.55;
  Force::Gravity(system.forces, system.matter, Vec3(0, -9.81, 0));
  const auto bar = [](double m, double L) {
    const Vec3 centre(L / 2, 0, 0);
    return Body::Rigid(MassProperties(m, centre, UnitInertia(0.001, L * L / 12, L * L / 12).shiftFromCentroid(centre)));
  };
  MobilizedBody::Pin crank(system.matter.updGround(), Transform(), bar(0.5, L1), Transform());
  MobilizedBody::Pin coupler(crank, Transform(Vec3(L1, 0, 0)), bar(1.5, L2), Transform());
  MobilizedBody::Pin rocker(system.matter.updGround(), Transform(Vec3(L4, 0, 0)), bar(1.2, L3), Transform());
  // Two equations: a ball joint would have a third that says nothing.
  const Constraint::PointOnLine loop(coupler, UnitVec3(ZAxis), Vec3(L2, 0, 0), rocker, Vec3(L3, 0, 0));
  const Force::MobilityConstantForce motor(system.forces, crank, 0, 0.8);
}

class Evaluation : public bench::Contender {
 public:
  Evaluation(std::unique_ptr<System> system, bool with_reactions)
      : system_(std::move(system)), with_reactions_(with_reactions) {
    system_->finish();
  }

  void take(const bench::Samples& samples) override { samples_ = &samples; }
  void run(long calls) override {
    for (long i = 0; i < calls; ++i) evaluate(static_cast<std::size_t>(i) % bench::k_states);
  }
  bool accelerations(std::size_t state, double* a) override {
    evaluate(state);
    const Vector& found = system_->state.getUDot();
    for (int i = 0; i < found.size(); ++i) a[i] = found[i];
    return true;
  }

 private:
  void evaluate(std::size_t i) {
    const bench::Sample& sample = (*samples_)[i];
    State& state = system_->state;
    Vector& q = state.updQ();
    Vector& u = state.updU();
    for (int k = 0; k < u.size(); ++k) {
      q[k] = sample.q[static_cast<std::size_t>(k)];
      u[k] = sample.v[static_cast<std::size_t>(k)];
    }
    system_->all.realize(state, Stage::Acceleration);
    if (with_reactions_) system_->matter.calcMobilizerReactionForces(state, reactions_);
  }

  std::unique_ptr<System> system_;
  bool with_reactions_;
  Vector_<SpatialVec> reactions_;
  const bench::Samples* samples_ = nullptr;
};

std::unique_ptr<bench::Contender> make(const std::string& kind, int size, bool with_reactions) {
  auto system = std::make_unique<System>();
  if (kind == "planar_chain") {
    planar_chain(*system, size);
  } else if (kind == "spatial_chain") {
    spatial_chain(*system, size);
  } else if (kind == "four_bar") {
    four_bar(*system);
  } else {
    return nullptr;
  }
  return std::make_unique<Evaluation>(std::move(system), with_reactions);
}

const bench::Registration k_rhs({"simbody", "rhs", 1, true,
                                 [](const std::string& kind, int size) { return make(kind, size, false); }});
const bench::Registration k_reactions({"simbody", "joint_reactions", 1, true,
                                       [](const std::string& kind, int size) { return make(kind, size, true); }});

}  // namespace
