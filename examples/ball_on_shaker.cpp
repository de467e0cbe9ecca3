// A ball on a table that shakes: it rests, flies and lands, by the function sets of two regimes and their guards; `ball_on_shaker` prints the events of
// half a second. docs/regimes.md has the laws.
#include <cstdio>
#include <vector>

#include "ball_on_shaker_variants.hpp"
#include "gauss/event/crossing.hpp"
#include "gauss/event/impulse.hpp"

namespace {

namespace flying = gauss::ball_on_shaker_flying;
using gauss::simulate::ChosenModel;
using State = std::vector<double>;

constexpr double k_step = 1e-4, k_end = 0.5;  // s

/// One regime, and the guard that ends it.
struct Regime {
  ChosenModel model;
  int guard;

  Regime(const char* name, const char* guard_name)
      : model(*gauss::simulate::find_model(gauss::ball_on_shaker_variants::variants, name)),
        guard(gauss::simulate::find_guard(model.model(), guard_name)) {}

  double value(double t, const State& x) const {
    std::vector<double> all(static_cast<std::size_t>(model.model().n_guards));
    model.guards(t, x.data(), all.data());
    return all[static_cast<std::size_t>(guard)];
  }
};

State moved(const State& x, double h, const State& rates) {
  State y = x;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * rates[i];
  return y;
}

/// The classical method of Runge and Kutta.
State after(const ChosenModel& model, double t, const State& x, double h) {
  State k1(x.size()), k2(x.size()), k3(x.size()), k4(x.size());
  model.rhs(t, x.data(), k1.data());
  model.rhs(t + h / 2, moved(x, h / 2, k1).data(), k2.data());
  model.rhs(t + h / 2, moved(x, h / 2, k2).data(), k3.data());
  model.rhs(t + h, moved(x, h, k3).data(), k4.data());
  for (std::size_t i = 0; i < x.size(); ++i) k1[i] += 2 * k2[i] + 2 * k3[i] + k4[i];
  return moved(x, h / 6, k1);
}

/// The impulse along the gap; speeds jump.
double hit(double t, State& x) {
  flying::State<double> state;
  for (std::size_t i = 0; i < x.size(); ++i) state.values[i] = x[i];
  flying::ImpactSystem<double> system;
  impact_system(t, state, flying::Inputs<double>{}, prepare(flying::Parameters<double>{}), system);
  gauss::event::ImpactProblem<double> problem;
  problem.speeds = 1;
  problem.metric = {system.g[0][0]};
  problem.rows = {system.rows[0][0]};
  problem.rates = {system.rates[0]};
  problem.restitution = {0};  // with more it would fly on
  problem.takes_part = {1};
  const auto found = gauss::event::ImpactSolver<double>(problem).solve();
  x[1] += found.changes[0];
  return found.impulses[0];
}

}  // namespace

int main() {
  const Regime rests("resting", "table_opens"), flies("flying", "table_closes");
  const Regime* now = &rests;
  State x(rests.model.size());
  if (rests.model.initial_state(x.data()) != gauss::Status::ok) return 1;
  std::printf("%18s  %-7s %18s %18s %18s\n", "t [s]", "", "z [m]", "z_dot [m/s]", "impulse [N*s]");
  for (double t = 0; t < k_end;) {
    const State next = after(now->model, t, x, k_step);
    const double end = now->value(t + k_step, next);
    if (end >= 0) {
      t += k_step;
      x = next;
      continue;
    }
    // The step is made again to shorter times, until it ends where the guard falls through 0.
    const auto value = [&](double h) { return now->value(t + h, after(now->model, t, x, h)); };
    const double h = gauss::event::falls_through(0.0, now->value(t, x), k_step, end, 1e-16, value);
    x = after(now->model, t, x, h);
    t += h;
    const bool lands = now == &flies;
    const double impulse = lands ? hit(t, x) : 0;
    // Where the table falls too fast to press, the ball flies on.
    now = lands && rests.value(t, x) > 0 ? &rests : &flies;
    std::printf("%18.15f  %-7s %18.15f %18.15f %18.15f\n", t, lands ? "lands" : "leaves", x[0], x[1], impulse);
  }
}
