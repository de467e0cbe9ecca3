// The sines and cosines that a right-hand side asks for, and nothing else: ANGLES calls of the library.

#include <cmath>

#include "contender.hpp"

namespace {

struct System {
  struct State {
    double angles[ANGLES];
  };
  struct Result {
    double sines[ANGLES], cosines[ANGLES];
  };

  static State own(const bench::Sample& sample) {
    State state;
    for (std::size_t i = 0; i < ANGLES; ++i) state.angles[i] = sample.q.empty() ? 0.1 * double(i) : sample.q[i % sample.q.size()];
    return state;
  }
  void operator()(const State& state, Result& result) const {
    for (std::size_t i = 0; i < ANGLES; ++i) ::sincos(state.angles[i], &result.sines[i], &result.cosines[i]);
  }
  static bool common(const State&, const Result&, double*) { return false; }
  static bool count(bench::Operations&) { return false; }
};

const bench::Registration k_registration({TOOL, "sines", 1, true,
                                          [](const std::string&, int) { return bench::loop<System>(); }});

}  // namespace
