// Emitted code with a state per lane of a SIMD register. HEADER, MODEL and TOOL say which; ARCH is an instruction set of xsimd.

#include HEADER

#include "contender.hpp"
#include "gauss/scalar/xsimd.hpp"

namespace {

namespace emitted = MODEL;
using Batch = xsimd::batch<double, ARCH>;

class Lanes : public bench::Contender {
 public:
  void take(const bench::Samples& samples) override {
    constexpr std::size_t n_q = emitted::n_q;
    states_.resize(bench::k_states / Batch::size);
    alignas(64) double lanes[Batch::size];
    for (std::size_t block = 0; block < states_.size(); ++block) {
      for (std::size_t i = 0; i < n_q + emitted::n_v; ++i) {
        for (std::size_t lane = 0; lane < Batch::size; ++lane) {
          const bench::Sample& sample = samples[block * Batch::size + lane];
          lanes[lane] = i < n_q ? sample.q[i] : sample.v[i - n_q];
        }
        states_[block].values[i] = Batch::load_aligned(lanes);
      }
    }
  }
  void run(long calls) override {
    emitted::Derivative<Batch> derivative;
    for (long i = 0; i < calls; ++i) {
      const auto status = emitted::rhs(Batch(0.0), states_[static_cast<std::size_t>(i) % states_.size()], inputs_,
                                       prepared_, derivative);
      bench::keep(status);
      bench::keep(derivative);
    }
  }
  bool accelerations(std::size_t state, double* a) override {
    emitted::Derivative<Batch> derivative;
    (void)emitted::rhs(Batch(0.0), states_[state / Batch::size], inputs_, prepared_, derivative);
    for (std::size_t i = 0; i < static_cast<std::size_t>(emitted::n_v); ++i)
      a[i] = derivative.values[static_cast<std::size_t>(emitted::n_q) + i].get(state % Batch::size);
    return true;
  }

 private:
  std::vector<emitted::State<Batch>, xsimd::aligned_allocator<emitted::State<Batch>, 64>> states_;
  emitted::Inputs<Batch> inputs_{};
  emitted::Prepared<Batch> prepared_ = emitted::prepare(emitted::Parameters<Batch>{});
};

const bench::Registration k_registration({TOOL, "batch", static_cast<int>(Batch::size), true,
                                          [](const std::string&, int) { return std::make_unique<Lanes>(); }});

}  // namespace
