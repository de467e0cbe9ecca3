// Emitted code with a trajectory per lane of a SIMD register, driven over structures of arrays. HEADER, MODEL and TOOL say which;
// ARCH is an instruction set of xsimd.

#include HEADER

#include "contender.hpp"
#include "gauss/batch/evaluator.hpp"

namespace {

namespace emitted = MODEL;
GAUSS_MODEL(Model, MODEL);
using Batch = xsimd::batch<double, ARCH>;

/// All states in one call, which is as many calls as there are registers of them.
class Lanes : public bench::Contender {
 public:
  void take(const bench::Samples& samples) override {
    constexpr std::size_t n_q = emitted::n_q;
    for (std::size_t k = 0; k < bench::k_states; ++k) {
      for (std::size_t i = 0; i < k_size; ++i)
        states_[i * bench::k_states + k] = i < n_q ? samples[k].q[i] : samples[k].v[i - n_q];
    }
  }
  void run(long calls) override {
    constexpr long k_calls = static_cast<long>(bench::k_states / Batch::size);
    for (long i = 0; i < calls; i += k_calls) {
      evaluate();
      bench::keep(derivatives_);
      bench::keep(statuses_);
    }
  }
  bool accelerations(std::size_t state, double* a) override {
    evaluate();
    for (std::size_t i = 0; i < static_cast<std::size_t>(emitted::n_v); ++i)
      a[i] = derivatives_[(static_cast<std::size_t>(emitted::n_q) + i) * bench::k_states + state];
    return statuses_[state] == gauss::Status::ok;
  }

 private:
  static constexpr std::size_t k_size = static_cast<std::size_t>(emitted::n_q + emitted::n_v);

  void evaluate() {
    gauss::batch::Points<double> points;
    points.count = bench::k_states;
    points.states = {states_.data(), bench::k_states};
    (void)evaluator_.rhs(points, {derivatives_.data(), bench::k_states}, statuses_.data());
  }

  gauss::batch::Evaluator<Model, double, Batch> evaluator_;
  /// Whole lines of the cache for each register, as the page of the driver recommends.
  alignas(64) std::array<double, k_size * bench::k_states> states_{}, derivatives_{};
  std::array<gauss::Status, bench::k_states> statuses_{};
};

const bench::Registration k_registration({TOOL, "batch", static_cast<int>(Batch::size), true,
                                          [](const std::string&, int) { return std::make_unique<Lanes>(); }});

}  // namespace
