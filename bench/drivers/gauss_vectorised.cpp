// Emitted code with its sines and cosines several at a time. HEADER, MODEL and TOOL say which.

#include HEADER

#include "contender.hpp"
#include "gauss/scalar/vectorised.hpp"

namespace {

namespace emitted = MODEL;
using S = gauss::Vectorised<double>;
constexpr std::size_t n_q = emitted::n_q;
constexpr std::size_t n_v = emitted::n_v;

struct System {
  using State = emitted::State<S>;
  struct Result {
    emitted::Derivative<S> derivative;
    gauss::Status status;
  };

  emitted::Prepared<S> prepared = emitted::prepare(emitted::Parameters<S>{});
  emitted::Inputs<S> inputs{};

  static State own(const bench::Sample& sample) {
    State state;
    for (std::size_t i = 0; i < n_q + n_v; ++i) state.values[i] = i < n_q ? sample.q[i] : sample.v[i - n_q];
    return state;
  }
  void operator()(const State& state, Result& result) const {
    result.status = emitted::rhs(S(0.0), state, inputs, prepared, result.derivative);
  }
  static bool common(const State&, const Result& result, double* a) {
    for (std::size_t i = 0; i < n_v; ++i) a[i] = result.derivative.values[n_q + i].value;
    return result.status == gauss::Status::ok;
  }
  static bool count(bench::Operations&) { return false; }
};

const bench::Registration k_registration({TOOL, "rhs_vectorised", 1, true,
                                          [](const std::string&, int) { return bench::loop<System>(); }});

}  // namespace
