// A thousand double pendulums at once: they begin within a thousandth of a degree, and part. Several of them are evaluated together,
// in the registers of the processor.

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "double_pendulum.hpp"
#include "gauss/batch/evaluator.hpp"

GAUSS_MODEL(Pendulum, gauss::double_pendulum);  // the emitted namespace as a type

namespace {

constexpr std::size_t k_count = 1000;
constexpr std::size_t k_components = Pendulum::n_q + Pendulum::n_v;
using Column = std::vector<double>;  ///< of all pendulums, component after component

/// The classical method of Runge and Kutta, of order 4, with one step for all; false: one of them went wrong.
class Ensemble {
 public:
  explicit Ensemble(Column start) : y_(std::move(start)) {}

  bool step(double h) {
    const bool is_good =
        rates(y_, k1_) && rates(moved(k1_, h / 2), k2_) && rates(moved(k2_, h / 2), k3_) && rates(moved(k3_, h), k4_);
    for (std::size_t i = 0; i < y_.size(); ++i) y_[i] += h / 6 * (k1_[i] + 2 * k2_[i] + 2 * k3_[i] + k4_[i]);
    return is_good;
  }

  /// Standard deviation of a component.
  double spread(std::size_t component) const {
    const double* const values = &y_[component * k_count];
    double sum = 0, squares = 0;
    for (std::size_t k = 0; k < k_count; ++k) sum += values[k];
    for (std::size_t k = 0; k < k_count; ++k) squares += std::pow(values[k] - sum / k_count, 2);
    return std::sqrt(squares / k_count);
  }

 private:
  bool rates(const Column& y, Column& dy) const {
    gauss::batch::Points<double> points;
    points.count = k_count;
    points.states = {y.data(), k_count};
    return evaluator_.rhs(points, {dy.data(), k_count}) == 0;
  }

  const Column& moved(const Column& k, double h) {
    for (std::size_t i = 0; i < y_.size(); ++i) moved_[i] = y_[i] + h * k[i];
    return moved_;
  }

  gauss::batch::Evaluator<Pendulum> evaluator_;
  Column y_;
  Column k1_ = y_, k2_ = y_, k3_ = y_, k4_ = y_, moved_ = y_;
};

/// The initial state of the model, its first angle changed a little more from one pendulum to the next.
Column start() {
  gauss::double_pendulum::State<double> state;
  (void)initial_state(Pendulum::prepare(Pendulum::Parameters<double>{}), state);
  Column y(k_components * k_count);
  for (std::size_t i = 0; i < k_components; ++i) {
    for (std::size_t k = 0; k < k_count; ++k)
      y[i * k_count + k] = state.values[i] + (i == 0 ? 1.7e-5 * static_cast<double>(k) / k_count : 0);
  }
  return y;
}

}  // namespace

int main() {
  Ensemble ensemble(start());
  std::printf("%zu at a time\n  t [s]  spread of the first angle [rad]\n", gauss::batch::Evaluator<Pendulum>::lanes);
  for (int second = 0; second <= 20; second += 2) {
    std::printf("%7d  %.3g\n", second, ensemble.spread(0));
    for (int i = 0; i < 2000; ++i) {
      if (!ensemble.step(1e-3)) return 1;
    }
  }
}
