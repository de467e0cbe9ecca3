// Emitted code of the ball against the same equations written by hand. `./run bench` builds and runs this.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>

#include "by_hand.hpp"
#include "gauss/model_concept.hpp"
#include "generation.hpp"
#include "machine.hpp"
#include "sphere/operations.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"

namespace {

namespace euler = gauss::sphere_in_cylinder;
namespace quaternion = gauss::sphere_in_cylinder_quaternion;
using sphere::Counted;
using sphere::Operations;

constexpr double k_rhs_bar = 60;          // ns
constexpr double k_generation_bar = 0.2;  // s
constexpr double k_largest_difference = 1e-12;

/// An emitted model and the same equations written by hand.
GAUSS_MODEL(EulerModel, euler);
struct Euler : EulerModel {
  template <class S>
  static void written(const by_hand::Constants<S>& k, const S* y, S* dy) {
    by_hand::euler<gauss::Math<S>>(k, y, dy);
  }
};

GAUSS_MODEL(QuaternionModel, quaternion);
struct Quaternion : QuaternionModel {
  template <class S>
  static void written(const by_hand::Constants<S>& k, const S* y, S* dy) {
    by_hand::quaternion<gauss::Math<S>>(k, y, dy);
  }
};

template <class M, class S>
struct Setting {
  typename M::template Parameters<S> parameters{};
  decltype(prepare(parameters)) prepared = prepare(parameters);
  // J is a formula of the model.
  by_hand::Constants<S> constants =
      by_hand::constants(parameters.m, parameters.r, parameters.g, S(0.4) * parameters.m * parameters.r * parameters.r);

  void emitted(const typename M::template State<S>& state, typename M::template Derivative<S>& d) const {
    (void)rhs(S(0), state, typename M::template Inputs<S>{}, prepared, d);
  }
  void written(const typename M::template State<S>& state, typename M::template Derivative<S>& d) const {
    M::written(constants, state.values, d.values);
  }
};

/// Away from the poles of the Euler angles; speeds need not satisfy the constraints.
template <class M>
std::vector<typename M::template State<double>> states() {
  std::mt19937 random(1986);
  std::uniform_real_distribution<double> any(0.3, 2.8);
  std::vector<typename M::template State<double>> result(1000);
  for (auto& state : result) {
    for (double& value : state.values) value = any(random);
  }
  return result;
}

/// Largest difference of any component, relative to the larger of its size and 1.
template <class M>
double difference(const Setting<M, double>& setting) {
  double largest = 0;
  for (const auto& state : states<M>()) {
    typename M::template Derivative<double> a{}, b{};
    setting.emitted(state, a);
    setting.written(state, b);
    for (std::size_t i = 0; i < std::size(a.values); ++i) {
      const double now = std::fabs(a.values[i] - b.values[i]) / std::fmax(1, std::fabs(b.values[i]));
      if (!(now <= largest)) largest = now;
    }
  }
  return largest;
}

template <class M, class Rhs>
Operations operations(Rhs call) {
  const Setting<M, Counted> setting;
  typename M::template State<Counted> state;
  for (auto& value : state.values) value = Counted(0.7);
  typename M::template Derivative<Counted> derivative;
  Counted::tally() = {};
  (setting.*call)(state, derivative);
  return Counted::tally();
}

void print_row(const char* what, bench::Times times, const Operations& count) {
  std::printf("  %-12s %8.1f %8.1f   %3d %3d %3d %3d\n", what, times.median, times.fastest, count.additions,
              count.multiplications, count.divisions, count.functions);
}

template <class M>
void measure(const Setting<M, double>& setting) {
  const auto all = states<M>();
  double checksum = 0;
  const auto batch = [&](auto call) {
    return [&, call] {
      for (const auto& state : all) {
        typename M::template Derivative<double> d;
        (setting.*call)(state, d);
        for (const double value : d.values) checksum += value;
      }
    };
  };
  using Emitted = Setting<M, double>;
  auto [emitted, written] = bench::by_turns(201, batch(&Emitted::emitted), batch(&Emitted::written));
  for (double* time : {&emitted.median, &emitted.fastest, &written.median, &written.fastest}) {
    *time *= 1e9 / static_cast<double>(all.size());
  }
  // Keeps the results alive.
  volatile double sink = checksum;
  static_cast<void>(sink);
  const bench::Times generated = bench::generation(M::name);
  std::printf("\n%s\n  %-12s %8s %8s   %3s %3s %3s %3s\n", M::name, "rhs [ns]", "median", "fastest", "+-", "*", "/",
              "f");
  using Count = Setting<M, Counted>;
  print_row("emitted", emitted, operations<M>(&Count::emitted));
  print_row("by hand", written, operations<M>(&Count::written));
  std::printf("  ratio %.2f; the bar of %.0f ns is %s\n", emitted.median / written.median, k_rhs_bar,
              emitted.median <= k_rhs_bar ? "met" : "MISSED");
  std::printf("  generation   %.1f ms, fastest %.1f ms; the bar of %.0f ms is %s\n", 1e3 * generated.median,
              1e3 * generated.fastest, 1e3 * k_generation_bar, generated.median <= k_generation_bar ? "met" : "MISSED");
}

template <class M>
bool run(bool only_check) {
  const Setting<M, double> setting;
  const double found = difference(setting);
  const bool is_same = found <= k_largest_difference;
  if (only_check || !is_same) {
    std::printf("%s: emitted and by hand differ by %.1e (at most %.0e)\n", M::name, found, k_largest_difference);
  }
  if (!only_check) measure(setting);
  return is_same;
}

}  // namespace

int main(int argc, char** argv) {
  const bool only_check = argc > 1 && std::strcmp(argv[1], "--check") == 0;
  if (!only_check) bench::print_machine();
  const bool is_same = run<Euler>(only_check) & run<Quaternion>(only_check);
  return is_same ? 0 : 1;
}
