// Plain C++ that a person wrote for one case. CASE_… says which, SIZE how many bodies.

#include "by_hand/ball.hpp"
#include "contender.hpp"
#include "counted.hpp"
#if defined(CASE_planar_chain)
#include "by_hand/planar_chain.hpp"
#elif defined(CASE_spatial_chain)
#include "by_hand/spatial_chain.hpp"
#elif defined(CASE_four_bar)
#include "by_hand/four_bar.hpp"
#elif defined(CASE_rolling_disc)
#include "by_hand/rolling_disc.hpp"
#endif

namespace {

/// Rates are copied behind the accelerations, as emitted code does: both fill the derivative of the state.
template <int n, class F>
struct System {
  struct State {
    double q[n], v[n];
  };
  struct Result {
    double rates[n], accelerations[n];
  };

  static State own(const bench::Sample& sample) {
    State state{};
    for (std::size_t i = 0; i < n; ++i) {
      state.q[i] = sample.q[i];
      state.v[i] = sample.v[i];
    }
    return state;
  }
  void operator()(const State& state, Result& result) const {
    for (int i = 0; i < n; ++i) result.rates[i] = state.v[i];
    F()(state.q, state.v, result.accelerations);
  }
  static bool common(const State&, const Result& result, double* a) {
    for (int i = 0; i < n; ++i) a[i] = result.accelerations[i];
    return true;
  }
  static bool count([[maybe_unused]] bench::Operations& operations) {
#ifndef COUNT
    return false;
#else
    operations = bench::operations_of<n>([](auto* q, auto* v, auto* a) { F()(q, v, a); });
    return true;
#endif
  }
};

/// The ball of by_hand/ball.hpp, which takes a state as one array.
template <int n_q, class F>
struct Ball {
  struct State {
    double values[n_q + 5];
  };
  using Result = State;

  by_hand::Constants<double> constants = by_hand::constants(0.5, 0.1, 9.81, 0.4 * 0.5 * 0.1 * 0.1);

  static State own(const bench::Sample& sample) {
    State state{};
    for (std::size_t i = 0; i < n_q; ++i) state.values[i] = sample.q[i];
    for (std::size_t i = 0; i < 5; ++i) state.values[n_q + i] = sample.v[i];
    return state;
  }
  void operator()(const State& state, Result& result) const { F()(constants, state.values, result.values); }
  static bool common(const State&, const Result& result, double* a) {
    for (int i = 0; i < 5; ++i) a[i] = result.values[n_q + i];
    return true;
  }
  static bool count([[maybe_unused]] bench::Operations& operations) {
#ifndef COUNT
    return false;
#else
    bench::Counted y[n_q + 5], dy[n_q + 5];
    for (int i = 0; i < n_q + 5; ++i) y[i] = bench::Counted::variable(0.3 + 0.11 * i);
    const by_hand::Constants<bench::Counted> constants = by_hand::constants<bench::Counted>(0.5, 0.1, 9.81, 0.002);
    bench::Counted::tally() = {};
    F()(constants, y, dy);
    operations = bench::Counted::tally();
    return true;
#endif
  }
};

template <class S>
struct Math {
  static void sincos(S x, S& sine, S& cosine) { bench::sine_and_cosine(x, sine, cosine); }
};

#define BY_HAND(name, call)                               \
  struct name {                                           \
    template <class S>                                    \
    void operator()(const S* q, const S* v, S* a) const { \
      by_hand::call(q, v, a);                             \
    }                                                     \
  }
#define BALL(name)                                                             \
  struct name {                                                                \
    template <class S>                                                         \
    void operator()(const by_hand::Constants<S>& k, const S* y, S* dy) const { \
      by_hand::name<Math<S>>(k, y, dy);                                        \
    }                                                                          \
  }
#define REGISTER(variable, tool, ...) \
  const bench::Registration variable( \
      {tool, "rhs", 1, true, [](const std::string&, int) { return bench::loop<__VA_ARGS__>(); }})

#if defined(CASE_planar_chain)
#if SIZE > 1
BY_HAND(Recursive, planar_chain<SIZE>);
REGISTER(k_recursive, "by hand", System<SIZE, Recursive>);
#endif
#if SIZE <= 2
BY_HAND(Closed, planar_chain_closed<SIZE>);
REGISTER(k_closed, SIZE == 1 ? "by hand" : "by hand, closed", System<SIZE, Closed>);
#elif SIZE <= 20
BY_HAND(Dense, planar_chain_dense<SIZE>);
REGISTER(k_dense, "by hand, dense", System<SIZE, Dense>);
#endif
#elif defined(CASE_spatial_chain)
BY_HAND(Recursive, spatial::spatial_chain<SIZE>);
REGISTER(k_recursive, "by hand", System<2 * SIZE, Recursive>);
#elif defined(CASE_four_bar)
BY_HAND(FourBar, four_bar);
REGISTER(k_four_bar, "by hand", System<3, FourBar>);
#elif defined(CASE_rolling_disc)
BY_HAND(Disc, rolling_disc);
REGISTER(k_disc, "by hand", System<5, Disc>);
#elif defined(CASE_sphere)
BALL(euler);
REGISTER(k_euler, "by hand", Ball<5, euler>);
#elif defined(CASE_sphere_quaternion)
BALL(quaternion);
REGISTER(k_quaternion, "by hand", Ball<6, quaternion>);
#endif

}  // namespace
