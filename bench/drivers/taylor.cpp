// Time to a delivered error: power series against Runge-Kutta methods of Boost.Odeint. Prints JSON; see bench/taylor.py.

#include <time.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "double_pendulum.hpp"
#include "gauss/integrate/bound_model.hpp"
#include "gauss/scalar/float128.hpp"
#include "gauss/simulate/taylor_simulation.hpp"
#include "kepler.hpp"
#include "lagrange_top.hpp"
#include "lagrange_top_euler.hpp"
#include "sphere_in_cylinder.hpp"
#include "sphere_in_cylinder_quaternion.hpp"

namespace {

namespace odeint = boost::numeric::odeint;

constexpr int k_samples = 8;

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <std::size_t n>
using Samples = std::array<std::array<double, n>, k_samples>;

struct Run {
  double error = 0, seconds = 0;
  long steps = 0;
};

/// The cheapest run that delivers an error.
struct Cheapest {
  double seconds = 0, tolerance = 0;
  long steps = 0;
};

GAUSS_MODEL(Kepler, gauss::kepler);
GAUSS_MODEL(Pendulum, gauss::double_pendulum);
GAUSS_MODEL(Ball, gauss::sphere_in_cylinder);
GAUSS_MODEL(QuaternionBall, gauss::sphere_in_cylinder_quaternion);
GAUSS_MODEL(Top, gauss::lagrange_top);
GAUSS_MODEL(EulerTop, gauss::lagrange_top_euler);

template <class Model, template <class> class SeriesOf>
class Problem {
 public:
  static constexpr std::size_t n = static_cast<std::size_t>(Model::n_q + Model::n_v);
  using Array = std::array<double, n>;
  using Bound = decltype(gauss::integrate::bind_model<Model, double>());

  explicit Problem(double end) : end_(end) {
    initial_state(prepared_, start_);
    reference();
  }

  template <class Stepper>
  Run odeint_run(double tolerance) const {
    const auto made = odeint::make_controlled<Stepper>(tolerance, tolerance);
    const auto system = [this](const Array& x, Array& rates, double t) {
      typename Model::template State<double> state;
      typename Model::template Derivative<double> derivative;
      std::memcpy(state.values, x.data(), sizeof x);
      Model::rhs(t, state, inputs_, prepared_, derivative);
      std::memcpy(rates.data(), derivative.values, sizeof rates);
    };
    return timed([&](Samples<n>& samples) {
      auto stepper = made;  // that of dopri5 remembers the rates at the end of a step
      Array x;
      std::copy_n(start_.values, n, x.begin());
      double t = 0, wanted = end_ * 1e-4;
      long steps = 0;
      for (int i = 0; i < k_samples; ++i) {
        const double goal = sample_time(i);
        while (t < goal) {
          double dt = std::min(wanted, goal - t);
          const bool is_cut = dt < wanted;
          const bool arrives = t + dt >= goal;
          ++steps;
          if (stepper.try_step(system, x, t, dt) != odeint::success) {
            wanted = dt;
            if (dt < 1e-14 * end_) return steps;
            continue;
          }
          if (!is_cut || dt > wanted) wanted = dt;
          if (arrives) t = goal;
        }
        samples[static_cast<std::size_t>(i)] = x;
      }
      return steps;
    });
  }

  Run taylor_run(double tolerance, int order) const {
    gauss::simulate::Settings<double> settings;
    settings.tolerance = tolerance;
    settings.project = false;
    const Bound model = gauss::integrate::bind_model<Model, double>();
    return timed([&](Samples<n>& samples) {
      gauss::simulate::TaylorSimulation<Bound, SeriesOf<double>>& simulation = *fresh(model, settings, order);
      for (int i = 0; i < k_samples; ++i) {
        if (!simulation.advance_to(sample_time(i))) break;
        std::copy_n(simulation.state().values, n, samples[static_cast<std::size_t>(i)].begin());
      }
      return simulation.report().steps + simulation.report().rejected;
    });
  }

 private:
  using Simulation = gauss::simulate::TaylorSimulation<Bound, SeriesOf<double>>;

  /// In the same place each time.
  Simulation* fresh(const Bound& model, const gauss::simulate::Settings<double>& settings, int order) const {
    if (simulation_ != nullptr) simulation_->~Simulation();
    if (space_ == nullptr) space_ = std::unique_ptr<Space>(new Space);
    simulation_ = new (space_->bytes) Simulation(model, start_, 0.0, settings, order);
    return simulation_;
  }
  struct Space {
    alignas(Simulation) unsigned char bytes[sizeof(Simulation)];
  };

  double sample_time(int i) const { return end_ * (i + 1) / k_samples; }

  void reference() {
    using Wide = __float128;
    const auto model = gauss::integrate::bind_model<Model, Wide>();
    typename Model::template State<Wide> start;
    initial_state(model.prepared(), start);
    gauss::simulate::Settings<Wide> settings;
    settings.tolerance = 1e-26Q;
    settings.project = false;
    const auto simulation = std::make_unique<gauss::simulate::TaylorSimulation<decltype(model), SeriesOf<Wide>>>(
        model, start, Wide(0), settings, 30);
    for (int i = 0; i < k_samples; ++i) {
      if (!simulation->advance_to(Wide(sample_time(i)))) std::printf("reference lost\n");
      for (std::size_t c = 0; c < n; ++c)
        reference_[static_cast<std::size_t>(i)][c] = static_cast<double>(simulation->state().values[c]);
    }
    for (std::size_t c = 0; c < n; ++c) {
      double least = start_.values[c], most = least;
      for (const auto& sample : reference_) {
        least = std::min(least, sample[c]);
        most = std::max(most, sample[c]);
      }
      range_[c] = most - least;
    }
  }

  double error_of(const Samples<n>& samples) const {
    double worst = 0;
    for (std::size_t i = 0; i < k_samples; ++i) {
      for (std::size_t c = 0; c < n; ++c) {
        if (!(range_[c] > 1e-6)) continue;
        const double error = std::abs(samples[i][c] - reference_[i][c]) / range_[c];
        worst = error <= worst ? worst : error;
      }
    }
    return worst;
  }

  template <class Integrate>
  Run timed(const Integrate& integrate) const {
    Samples<n> samples{};
    Run run;
    run.steps = integrate(samples);
    run.error = error_of(samples);
    double best = 1e9;
    for (int round = 0; round < 5; ++round) {
      const double begin = now();
      int times = 0;
      do {
        integrate(samples);
        ++times;
      } while (now() - begin < 2e-3);
      best = std::min(best, (now() - begin) / times);
    }
    run.seconds = best;
    return run;
  }

  double end_;
  typename Model::template Parameters<double> parameters_{};
  typename Model::template Inputs<double> inputs_{};
  typename Model::template Prepared<double> prepared_ = Model::prepare(parameters_);
  typename Model::template State<double> start_;
  Samples<n> reference_{};
  Array range_{};
  mutable std::unique_ptr<Space> space_;
  mutable Simulation* simulation_ = nullptr;
};

constexpr std::array<double, 4> k_errors{1e-3, 1e-6, 1e-9, 1e-11};

template <class Take>
std::array<Cheapest, 4> cheapest(const Take& take) {
  std::array<Cheapest, 4> best{};
  for (int i = 4; i <= 30; ++i) {
    const double tolerance = std::pow(10.0, -0.5 * i);
    const Run run = take(tolerance);
    for (std::size_t e = 0; e < k_errors.size(); ++e) {
      if (run.error <= k_errors[e] && (best[e].seconds <= 0 || run.seconds < best[e].seconds))
        best[e] = {run.seconds, tolerance, run.steps};
    }
    if (best.back().seconds > 0 && run.seconds > 3 * best.back().seconds) break;
  }
  return best;
}

void print(const char* method, const std::array<Cheapest, 4>& best, const char* end) {
  std::printf("    \"%s\": {", method);
  for (std::size_t e = 0; e < k_errors.size(); ++e) {
    std::printf("%s\"%.0e\": {\"seconds\": %.4g, \"tolerance\": %.2g, \"steps\": %ld}", e > 0 ? ", " : "", k_errors[e],
                best[e].seconds, best[e].tolerance, best[e].steps);
  }
  std::printf("}%s\n", end);
}

template <class Model, template <class> class SeriesOf>
void measure(const char* name, double end, int order, const char* separator) {
  const Problem<Model, SeriesOf> problem(end);
  using Array = typename Problem<Model, SeriesOf>::Array;
  std::printf("  \"%s\": {\n", name);
  print("taylor", cheapest([&](double tolerance) { return problem.taylor_run(tolerance, order); }), ",");
  print("fehlberg78", cheapest([&](double tolerance) {
          return problem.template odeint_run<odeint::runge_kutta_fehlberg78<Array>>(tolerance);
        }),
        ",");
  print("dopri5", cheapest([&](double tolerance) {
          return problem.template odeint_run<odeint::runge_kutta_dopri5<Array>>(tolerance);
        }),
        "");
  std::printf("  }%s\n", separator);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int order = argc > 1 ? std::atoi(argv[1]) : 0;
  std::printf("{\n");
  measure<Ball, gauss::sphere_in_cylinder::TaylorSeries>("ball_euler", 10, order, ",");
  measure<QuaternionBall, gauss::sphere_in_cylinder_quaternion::TaylorSeries>("ball_quaternion", 10, order, ",");
  measure<Pendulum, gauss::double_pendulum::TaylorSeries>("double_pendulum", 10, order, ",");
  measure<EulerTop, gauss::lagrange_top_euler::TaylorSeries>("top_euler", 10, order, ",");
  measure<Top, gauss::lagrange_top::TaylorSeries>("top_quaternion", 10, order, ",");
  measure<Kepler, gauss::kepler::TaylorSeries>("kepler", 20, order, "");
  std::printf("}\n");
}
