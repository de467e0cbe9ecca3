// Z does not depend on the coordinates (Vujičić (1.13) is a scalar): the same model in other ones has the same value of Z, the same
// accelerations of bodies, multipliers, reactions and forces at corresponding states.

#include <cstdio>

#include "catch_shim.hpp"
#include "model_files.hpp"
#include "newton/change.hpp"
#include "newton/setting.hpp"
#include "strategy/compulsion.hpp"

namespace {

using agreement::newton::Change;
using agreement::newton::Setting;
using agreement::newton::Specimen;
using agreement::newton::Wrench;

constexpr int k_states = 200;

/// Z where the accelerations are those that are found; a model of massless bodies or a singular metric may have none.
class WithZ {
 public:
  explicit WithZ(gaussgen::model::Model model) : specimen(std::move(model)) {
    gaussgen::strategy::Vector found;
    auto& mechanics = specimen.mechanics;
    for (const auto& speed : mechanics.symbols.speeds)
      found.push_back(mechanics.expressions.symbol(speed.acceleration));
    gaussgen::strategy::Steps steps;
    Z_ = gaussgen::strategy::compulsion(mechanics.dynamics, found, mechanics.epsilon(), steps)->Z.id();
  }

  double Z() { return specimen.value(Z_); }

  /// Of the metric of all coordinates, held ones too, with a diagonal of 1: Z spreads forces along coordinates by its inverse.
  double condition_of_metric() {
    const auto& G = specimen.mechanics.covariant->G;
    const auto n = static_cast<Eigen::Index>(G.size());
    Eigen::MatrixXd metric(n, n);
    for (const auto i : G.indices()) {
      for (const auto j : G.indices()) {
        metric(static_cast<Eigen::Index>(i.value), static_cast<Eigen::Index>(j.value)) = specimen.value(G[i][j].id());
      }
    }
    const Eigen::VectorXd unit = metric.diagonal().cwiseSqrt().cwiseInverse();
    return agreement::condition(unit.asDiagonal() * metric * unit.asDiagonal());
  }

  Specimen specimen;

 private:
  gaussgen::ir::NodeId Z_;
};

struct Worst {
  double Z = 0, accelerations = 0, multipliers = 0, reactions = 0, bodies = 0, joints = 0;
  int left_out = 0;

  double all() const { return std::max({Z, accelerations, multipliers, reactions, bodies, joints}); }
};

double largest(const std::vector<double>& v) {
  double result = 0;
  for (const double x : v) agreement::take(result, std::fabs(x));
  return result;
}

/// What the forces of the problem amount to, over the root of a mass: the unit of all comparisons.
double size_of(Setting& setting) {
  double size = 0;
  for (std::size_t i = 0; i < setting.terms.size(); ++i) {
    const auto& body = setting.model.bodies[i];
    size += setting.terms[i].force / std::sqrt(setting.motion(body.mass).value);
    if (body.inertia) size += setting.terms[i].moment / std::sqrt(inertia(body, setting.motion).trace());
  }
  for (const auto& load : setting.loads) size += load.force.norm() + load.moment.norm();
  return size;
}

double difference(const Wrench& a, const Wrench& b) {
  return std::max((a.force - b.force).norm(), (a.moment - b.moment).norm());
}

double difference(Setting& a, Setting& b) {
  double worst = 0;
  for (const auto& body : a.model.bodies) {
    const double m = a.motion(body.mass).value;
    agreement::take(worst, std::sqrt(m) * (a.centre(body).second - b.centre(body).second).norm());
    if (!body.inertia) continue;
    const double root = std::sqrt(inertia(body, a.motion).trace());
    agreement::take(worst, root * (a.motion.omega(body.frame).rate - b.motion.omega(body.frame).rate).norm());
  }
  return worst;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  std::vector<double> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return largest(result);
}

void compare(WithZ& old, WithZ& changed, Worst& worst) {
  Setting a(old.specimen);
  Setting b(changed.specimen);
  const double bar = 100 * agreement::k_eps * std::max(old.specimen.condition, changed.specimen.condition);
  const double size = std::max(size_of(a), size_of(b));
  const double forces = size + largest(old.specimen.lambda) + largest(old.specimen.R);
  agreement::take(worst.accelerations, difference(a, b) / (bar * size));
  const double Z = old.Z();
  const double full = std::max({1.0, old.condition_of_metric(), changed.condition_of_metric()});
  const double bar_of_Z = std::max(bar, 100 * agreement::k_eps * full);
  // Near a pole of the angles, held ones among them, that metric has no inverse, though the one of the motion has.
  if (full < agreement::k_largest_condition) {
    agreement::take(worst.Z, std::fabs(Z - changed.Z()) / (bar_of_Z * (Z + size * size)));
  }
  agreement::take(worst.multipliers, difference(old.specimen.lambda, changed.specimen.lambda) / (bar * forces));
  agreement::take(worst.reactions, difference(old.specimen.R, changed.specimen.R) / (bar * forces));
  const auto wrenches = [&](const std::vector<Wrench>& x, const std::vector<Wrench>& y, double& figure) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double own = x[i].force.norm() + x[i].moment.norm();
      agreement::take(figure, difference(x[i], y[i]) / (bar * (forces + own)));
    }
  };
  wrenches(old.specimen.on_bodies, changed.specimen.on_bodies, worst.bodies);
  wrenches(old.specimen.in_joints, changed.specimen.in_joints, worst.joints);
}

Worst run(const std::string& file, Change::Kind kind) {
  const auto model = agreement::load(file);
  const Change change(model, kind, 42);
  WithZ old(model);
  WithZ changed(change.of(model));
  agreement::RandomStates states(changed.specimen.mechanics.symbols, 9);
  Worst worst;
  for (int i = 0; i < k_states; ++i) {
    const agreement::State state = states.next();
    if (changed.specimen.at(state) && old.specimen.at(change.old_state(state))) {
      compare(old, changed, worst);
    } else {
      ++worst.left_out;
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("Z, accelerations of bodies, multipliers, reactions and forces are the same in other coordinates") {
  std::printf("%-30s %-7s %9s %9s %9s %9s %9s %9s %9s   (each / 100 kappa eps)\n", "model", "change", "Z", "bodies' a",
              "lambda", "R", "on body", "in joint", "left out");
  for (const std::string& file : agreement::model_files()) {
    if (file == "robot_arm" || file == "bicycle") continue;
    for (const auto kind : {Change::Kind::affine, Change::Kind::curved}) {
      const Worst worst = run(file, kind);
      const char* name = kind == Change::Kind::affine ? "affine" : "curved";
      std::printf("%-30s %-7s %9.2g %9.2g %9.2g %9.2g %9.2g %9.2g %9d\n", file.c_str(), name, worst.Z,
                  worst.accelerations, worst.multipliers, worst.reactions, worst.bodies, worst.joints, worst.left_out);
      INFO(file << ", " << name);
      CHECK(worst.all() <= 1);
      CHECK(worst.left_out <= k_states / 20);
    }
  }
}
