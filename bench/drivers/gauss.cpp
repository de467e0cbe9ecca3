// Emitted code. HEADER, MODEL and TOOL say which; METRIC is the function that is measured, and where it is not rhs, RESULT its struct.
// COUNT: operations are counted, which takes
// long to compile where speed is asked for, too. ABSOLUTE: the angles of the model are those against the vertical. FROM_START: states near the one at which the model begins, for
// models of which cases.hpp has none. SYMBOLS: parameters are not numbers in the text.

#include HEADER

#include "counted.hpp"

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)

template <>
struct gauss::Math<bench::Counted> : gauss::ScalarLogic<bench::Counted> {
  using S = bench::Counted;

  static S sin(const S& x) { return bench::sin(x); }
  static S cos(const S& x) { return bench::cos(x); }
  static S tan(const S& x) { return bench::tan(x); }
  static S atan(const S& x) { return bench::atan(x); }
  static S sqrt(const S& x) { return bench::sqrt(x); }
  static void sincos(const S& x, S& sine, S& cosine) { bench::sine_and_cosine(x, sine, cosine); }
  static S epsilon() { return {2.220446049250313e-16}; }
  static S pi() { return {3.141592653589793}; }
  /// A look at the results, which is not counted.
  template <class... Values>
  static bool not_finite(const Values&...) {
    return false;
  }
};

namespace {

namespace emitted = MODEL;
constexpr std::size_t n_q = emitted::n_q;
constexpr std::size_t n_v = emitted::n_v;

struct System {
  using State = emitted::State<double>;
  struct Result {
    emitted::Derivative<double> derivative;
#ifdef RESULT
    emitted::RESULT<double> more;
#endif
    gauss::Status status;
  };

  emitted::Prepared<double> prepared = emitted::prepare(emitted::Parameters<double>{});
  emitted::Inputs<double> inputs{};

  State own(const bench::Sample& sample) {
#ifdef FROM_START
    (void)sample;
    return near_the_start();
#else
    State state{};
    double q = 0, v = 0;
    for (std::size_t i = 0; i < n_q; ++i) state.values[i] = q = sample.q[i] + (k_is_absolute ? q : 0);
    for (std::size_t i = 0; i < n_v; ++i) state.values[n_q + i] = v = sample.v[i] + (k_is_absolute ? v : 0);
    return state;
#endif
  }

  void operator()(const State& state, Result& result) const {
#if defined(RESULT) && defined(WITH_DERIVATIVE)
    result.status = emitted::METRIC(0.0, state, inputs, prepared, result.derivative, result.more);
#elif defined(RESULT)
    result.status = emitted::METRIC(0.0, state, inputs, prepared, result.more);
#else
    result.status = emitted::METRIC(0.0, state, inputs, prepared, result.derivative);
#endif
  }

  static bool common(const State&, const Result& result, double* a) {
#if !defined(RESULT) || defined(WITH_DERIVATIVE)
    double former = 0;
    for (std::size_t i = 0; i < n_v; ++i) {
      a[i] = result.derivative.values[n_q + i] - former;
      if (k_is_absolute) former = result.derivative.values[n_q + i];
    }
    return result.status == gauss::Status::ok;
#else
    (void)result, (void)a;
    return false;
#endif
  }

  static bool count(bench::Operations& operations) {
#ifndef COUNT
    (void)operations;
    return false;
#else
    using bench::Counted;
#ifdef SYMBOLS
    Counted::numbers_vary() = true;
#endif
    const auto prepared = emitted::prepare(emitted::Parameters<Counted>{});
    Counted::numbers_vary() = false;
    emitted::State<Counted> state;
    for (std::size_t i = 0; i < n_q + n_v; ++i)
      state.values[i] = Counted::variable(0.3 + 0.11 * static_cast<double>(i));
    emitted::Inputs<Counted> inputs{};
    emitted::Derivative<Counted> derivative;
    Counted::tally() = {};
    (void)emitted::METRIC(Counted(0.0), state, inputs, prepared, derivative);
    operations = Counted::tally();
    return true;
#endif
  }

 private:
#ifdef ABSOLUTE
  static constexpr bool k_is_absolute = true;
#else
  static constexpr bool k_is_absolute = false;
#endif

#ifdef FROM_START
  State near_the_start() {
    State state{};
    (void)emitted::initial_state(prepared, state);
    for (double& value : state.values) {
      seed_ = seed_ * 6364136223846793005U + 1442695040888963407U;
      value += 0.05 * (static_cast<double>(seed_ >> 11U) / 9007199254740992.0 - 0.5);
    }
    return state;
  }
  unsigned long long seed_ = 1986;
#endif
};

const bench::Registration k_registration({TOOL, TEXT(METRIC), 1, true,
                                          [](const std::string&, int) { return bench::loop<System>(); }});

}  // namespace
